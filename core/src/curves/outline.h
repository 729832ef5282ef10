// Outlines of lines and curves, as drawings have them, and how they become polygons. Only + - x /
// and square roots are used, so the same outline gives the same bits everywhere.
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
  Vec2 operator()(const Vec2& p) const {
    return {a * p.x() + c * p.y() + e, b * p.x() + d * p.y() + f};
  }
  // The map that does `inner` first.
  Affine operator*(const Affine& inner) const;
};

// From the end of the piece before it to its own end. A conic is a rational quadratic Bézier curve
// whose end points have the weight 1: with a control point of the weight 1 it is a parabola, and
// with the cosine of half the angle it is an arc. So all arcs are conics, of at most 90 degrees
// each, and affine maps move their control points.
struct CurvePiece {
  enum class Kind : std::uint8_t { line, conic, cubic };
  Kind kind;
  Vec2 end;
  Vec2 first = Vec2::Zero(), second = Vec2::Zero();  // control points: a conic has only the first
  double weight = 1;                                 // of a conic's control point, in (0, 1]
};

// One outline, or a part of one.
struct Outline {
  Vec2 start = Vec2::Zero();
  std::vector<CurvePiece> pieces;

  const Vec2& end() const { return pieces.empty() ? start : pieces.back().end; }
  bool curved() const;

  void line_to(const Vec2& to);
  void quadratic_to(const Vec2& control, const Vec2& to);
  void cubic_to(const Vec2& first, const Vec2& second, const Vec2& to);
  // A quarter of an ellipse whose tangents at its ends meet at the corner.
  void quarter_to(const Vec2& corner, const Vec2& to);
  // An arc as DXF has it: `bulge` is the tangent of a quarter of its angle, positive if it turns
  // counter-clockwise, and finite. 0 is a line.
  void bulge_to(const Vec2& to, double bulge);
  // The image under `frame` of the arc of the unit circle from `from` to `to`, counter-clockwise or
  // clockwise, the part of more than 180 degrees if `large`. It ends exactly at `last`.
  void arc_to(const Affine& frame, const Vec2& from, const Vec2& to, bool counterclockwise,
              bool large, const Vec2& last);
  // The whole image of the unit circle, counter-clockwise before the map. Sets the start.
  static Outline ellipse(const Affine& frame);
  // The B-spline curve of degree 1, 2 or 3 without weights; nothing if there are not as many finite
  // knots as control points, the degree and 1 together, in order, or if it is in two or has no
  // length. O(points).
  static std::optional<Outline> b_spline(const Points& control, const std::vector<double>& knots,
                                         std::size_t degree);
};

// The same outline the other way round; and its image. O(pieces).
Outline reversed(const Outline& outline);
Outline transformed(const Outline& outline, const Affine& map);

// A box that contains the outline: that of its ends and control points. O(pieces).
Box control_box(const Outline& outline);

// The ends of edges that stay within `tolerance` (> 0) of the outline, from its start to its end,
// without points that repeat the one before. No point of a curve is farther from its edges than
// that. Nothing if there would be more than `most`. O(points).
std::optional<Points> flatten(const Outline& outline, double tolerance, std::size_t most);

}  // namespace evenlift
