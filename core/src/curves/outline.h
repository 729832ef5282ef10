// Outlines of lines and curves, and their conversion to polygons. The arithmetic uses only + - x /
// and square roots, so an outline gives the same bits on every platform.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "evenlift/vec.h"

namespace evenlift {

// The map (x, y) -> (a x + c y + e, b x + d y + f).
struct Affine {
  double a = 1, b = 0, c = 0, d = 1, e = 0, f = 0;
  Vec2 operator()(const Vec2& p) const { return {a * p.x + c * p.y + e, b * p.x + d * p.y + f}; }
  // The map that applies `inner` first and then this map.
  Affine operator*(const Affine& inner) const;
};

// A line or curve from the end of the preceding piece to `end`. A conic is a rational quadratic
// Bézier curve whose end points have the weight 1. It is a parabola if its control point also has
// the weight 1. An arc of at most 90 degrees is a conic: its control point is where the tangents at
// its ends meet, and the weight of that point is the cosine of half the arc's angle. An affine map
// of a piece moves its ends and control points, and keeps its weight.
struct CurvePiece {
  enum class Kind : std::uint8_t { line, conic, cubic };
  Kind kind;
  Vec2 end;
  Vec2 first, second;  // control points: a conic has only the first
  double weight = 1;   // of a conic's control point, in (0, 1]
};

// Points count as one if they are closer than this share of their shape's larger side, since
// drawings repeat points, and ends that should meet differ a little.
inline constexpr double same_point = 1e-5;

inline constexpr std::size_t max_spline_degree = 10;
inline constexpr std::size_t max_spline_pieces = std::size_t{1} << 20;

// An outline, or a part of one.
struct Outline {
  Vec2 start;
  std::vector<CurvePiece> pieces;

  const Vec2& end() const { return pieces.empty() ? start : pieces.back().end; }
  bool curved() const;

  void line_to(const Vec2& to);
  void quadratic_to(const Vec2& control, const Vec2& to);
  void cubic_to(const Vec2& first, const Vec2& second, const Vec2& to);
  // Adds a quarter of an ellipse whose tangents at the two ends meet at `corner`.
  void quarter_to(const Vec2& corner, const Vec2& to);
  // Adds an arc as in DXF, or a line if `bulge` is 0. `bulge` must be finite. It is the tangent of
  // a quarter of the arc's angle, with a positive sign if the arc turns counter-clockwise.
  void bulge_to(const Vec2& to, double bulge);
  // Adds the image under `frame` of the arc of the unit circle from `from` to `to`. If `large`, the
  // arc has more than 180 degrees. The image ends exactly at `last`.
  void arc_to(const Affine& frame, const Vec2& from, const Vec2& to, bool counterclockwise,
              bool large, const Vec2& last);
  // The image under `frame` of the whole unit circle, taken counter-clockwise.
  static Outline ellipse(const Affine& frame);
  // The B-spline curve of degree 1 to max_spline_degree or, with weights, the NURBS curve. Knots
  // and weights must be finite. Returns nothing unless, for p control points, the degree is below
  // p, there are p + degree + 1 knots, which never decrease, and there are either no weights or p
  // weights above 0. Also returns nothing if no span between knots has a length, or if the curve
  // has a gap of more than 1e-6 s, where s is the larger side of the box around the control points.
  // Lines are exact, and so are parabolas and cubics without weights. A conic is exact if its
  // control point has a weight of at most 1 once its ends are given the weight 1. Other curves
  // deviate by at most 1e-7 s, unless weights differ so much that 10 halvings of a span do not
  // suffice. The outline ends once it has more than max_spline_pieces. O(p degree^3 + pieces degree^2).
  static std::optional<Outline> b_spline(const Points& control, const std::vector<double>& knots,
                                         std::size_t degree,
                                         const std::vector<double>& weights = {});
};

// reversed() returns the outline from its end to its start, and transformed() its image under a
// map. O(pieces).
Outline reversed(const Outline& outline);
Outline transformed(const Outline& outline, const Affine& map);

// The box around all ends and control points. It contains the outline. O(pieces).
Box control_box(const Outline& outline);

// The ends of the edges that replace the outline, in order; successive points differ. No point of a
// curve is farther than `tolerance` (> 0) from the curve's edges, nor any point of these edges from
// the curve. Returns nothing if there would be more than `most` points. O(points).
std::optional<Points> flatten(const Outline& outline, double tolerance, std::size_t most);

}  // namespace evenlift
