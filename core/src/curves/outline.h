// Outlines of lines and curves, as in drawings, and their conversion to polygons. They use only
// + - x / and square roots, so the same outline gives the same bits everywhere.
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
// whose end points have the weight 1. If its control point has the weight 1, it is a parabola; if
// the weight is the cosine of half the angle, it is an arc. So all arcs are conics, of at most 90
// degrees each, and affine maps move their control points.
struct CurvePiece {
  enum class Kind : std::uint8_t { line, conic, cubic };
  Kind kind;
  Vec2 end;
  Vec2 first = Vec2::Zero(), second = Vec2::Zero();  // control points: a conic has only the first
  double weight = 1;                                 // of a conic's control point, in (0, 1]
};

inline constexpr std::size_t max_spline_degree = 10;
inline constexpr std::size_t max_spline_pieces = std::size_t{1} << 20;

// An outline, or a part of an outline.
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
  // An arc as in DXF: `bulge` is the tangent of a quarter of its angle, positive if the arc turns
  // counter-clockwise, and finite. 0 is a line.
  void bulge_to(const Vec2& to, double bulge);
  // The image under `frame` of the arc of the unit circle from `from` to `to`, counter-clockwise or
  // clockwise; if `large`, the part of more than 180 degrees. It ends exactly at `last`.
  void arc_to(const Affine& frame, const Vec2& from, const Vec2& to, bool counterclockwise,
              bool large, const Vec2& last);
  // The image of the whole unit circle, counter-clockwise before the map. Sets the start.
  static Outline ellipse(const Affine& frame);
  // The B-spline curve of degree 1 to max_spline_degree, and with weights the NURBS curve. Its
  // knots must be finite, in order, and control points + degree + 1 in number, its weights finite,
  // above 0, and as many as control points. Nothing if they are not, or if the curve has no length,
  // or parts with a gap of more than 1e-6 of the larger side of the box around the control points.
  // Lines, parabolas and cubics without weights are exact, and so are conics with weights of at
  // most 1. Other curves deviate from the outline by at most 1e-7 of that side, unless weights
  // differ by so many orders of magnitude that 10 halvings of a span do not suffice. The outline
  // ends as soon as it has more than `most` pieces. O(points degree^3 + pieces degree^2).
  static std::optional<Outline> b_spline(const Points& control, const std::vector<double>& knots,
                                         std::size_t degree,
                                         const std::vector<double>& weights = {},
                                         std::size_t most = max_spline_pieces);
};

// The outline in the opposite direction, and its image. O(pieces).
Outline reversed(const Outline& outline);
Outline transformed(const Outline& outline, const Affine& map);

// The bounding box of the ends and control points. It contains the outline. O(pieces).
Box control_box(const Outline& outline);

// The ends of edges that stay within `tolerance` (> 0) of the outline, from its start to its end,
// without consecutive repeated points. No point of a curve is farther than `tolerance` from its
// edges. Nothing if there would be more than `most`. O(points).
std::optional<Points> flatten(const Outline& outline, double tolerance, std::size_t most);

}  // namespace evenlift
