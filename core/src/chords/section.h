// Points across C from a vertex: the arithmetic that vertex-chords and section ends share.
#pragma once

#include <cstdint>
#include <optional>

#include "evenlift/chords.h"
#include "evenlift/polygon.h"

namespace evenlift {

// Where the ray from C away from vertex w meets the line of an edge, as the multiple `factor` of
// |C w|: the point is C + factor (C - w).
struct Across {
  double factor = 0;  // > 0, to a relative error of about 2^-45; exactly 1 if C bisects the chord
  int excess = 0;     // exact sign of factor - 1
};

// The edge b c is given counter-clockwise about C and not radial, `area` is its orient(centre, b,
// c); the ray meets it.
Across look_across(const Vec2& centre, const Vec2& w, const Vec2& b, const Vec2& c, double area);

// The same factor to a relative error below 2^-33, from a few multiplications; nothing where
// doubles do not give that.
std::optional<double> estimate_across(const Vec2& centre, const Vec2& w, const Vec2& b,
                                      const Vec2& c, double area);

// The chord from vertex w (on edge `edge_w`) through C to the point `across` on edge `edge_hit`,
// which is vertex `hit` if that is not inside_edge. Its ends are ordered as Chord says.
Chord chord_from_vertex(const Polygon& polygon, const Vec2& centre, std::uint32_t w,
                        std::uint32_t edge_w, const Across& across, std::uint32_t edge_hit,
                        std::uint32_t hit);

// A chord from its forward half: `ahead` and `behind` in either order, `direction` from behind to
// ahead.
Chord order_ends(const LiftingPoint& ahead, double arm_ahead, const LiftingPoint& behind,
                 double arm_behind, const Vec2& direction);

// Whether a direction points from r1 to r2: to the right, or upward if it counts as vertical.
bool points_right(const Vec2& direction);

// min / max of two positive lengths.
double load_ratio(double arm1, double arm2);

}  // namespace evenlift
