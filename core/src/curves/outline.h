// Outlines of lines and curves, and their conversion to polygons. They use only + - x / and square
// roots, so an outline gives the same bits everywhere.
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
  // The map that applies `inner` first.
  Affine operator*(const Affine& inner) const;
};

// From the end of the preceding piece to its own end. A conic is a rational quadratic Bézier curve
// with end points of weight 1: a parabola if its control point has the weight 1, an arc if that
// weight is the cosine of half the angle. So arcs are conics of at most 90 degrees, and affine maps
// move their control points.
struct CurvePiece {
  enum class Kind : std::uint8_t { line, conic, cubic };
  Kind kind;
  Vec2 end;
  Vec2 first = Vec2::Zero(), second = Vec2::Zero();  // control points: a conic has only the first
  double weight = 1;                                 // of a conic's control point, in (0, 1]
};

inline constexpr std::size_t max_spline_degree = 10;
inline constexpr std::size_t max_spline_pieces = std::size_t{1} << 20;

// An outline, or a part of one.
struct Outline {
  Vec2 start = Vec2::Zero();
  std::vector<CurvePiece> pieces;

  const Vec2& end() const { return pieces.empty() ? start : pieces.back().end; }
  bool curved() const;

  void line_to(const Vec2& to);
  void quadratic_to(const Vec2& control, const Vec2& to);
  void cubic_to(const Vec2& first, const Vec2& second, const Vec2& to);
  // A quarter of an ellipse; its tangents at the two ends meet at the corner.
  void quarter_to(const Vec2& corner, const Vec2& to);
  // An arc as in DXF: `bulge` is finite and the tangent of a quarter of its angle, positive if the
  // arc turns counter-clockwise. 0 is a line.
  void bulge_to(const Vec2& to, double bulge);
  // The image under `frame` of the arc of the unit circle from `from` to `to`; if `large`, of more
  // than 180 degrees. It ends exactly at `last`.
  void arc_to(const Affine& frame, const Vec2& from, const Vec2& to, bool counterclockwise,
              bool large, const Vec2& last);
  // The image of the whole unit circle, counter-clockwise before the map. Sets the start.
  static Outline ellipse(const Affine& frame);
  // The B-spline curve of degree 1 to max_spline_degree, with weights the NURBS curve. Knots must
  // be finite, in order, and control points + degree + 1 in number; weights finite, above 0, and as
  // many as control points. Nothing otherwise, or if the curve has no length, or a gap of more than
  // 1e-6 of the larger side of the box around the control points. Lines, parabolas and cubics
  // without weights and conics with weights of at most 1 are exact. Other curves deviate by at most
  // 1e-7 of that side, unless weights differ so much that 10 halvings of a span do not suffice. The
  // outline ends once it has more than `most` pieces. O(points degree^3 + pieces degree^2).
  static std::optional<Outline> b_spline(const Points& control, const std::vector<double>& knots,
                                         std::size_t degree,
                                         const std::vector<double>& weights = {},
                                         std::size_t most = max_spline_pieces);
};

// O(pieces).
Outline reversed(const Outline& outline);
Outline transformed(const Outline& outline, const Affine& map);

// The box of the ends and control points, which contains the outline. O(pieces).
Box control_box(const Outline& outline);

// The ends of edges that stay within `tolerance` (> 0) of the outline, from start to end, without
// consecutive repeated points; curves stay as near to their edges. Nothing if there would be more
// than `most`. O(points).
std::optional<Points> flatten(const Outline& outline, double tolerance, std::size_t most);

}  // namespace evenlift
