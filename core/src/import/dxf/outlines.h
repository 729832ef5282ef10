// Converts directions in degrees to vectors.
#pragma once

#include <cmath>

#include "curves/outline.h"
#include "evenlift/angles.h"
#include "evenlift/vec.h"
#include "import/dxf/drawing.h"

namespace evenlift {

// The unit vector at this angle, counter-clockwise from the x axis. It is exact for multiples of 90
// degrees, so a block that is turned by such an angle keeps its right angles. O(1).
inline Vec2 direction_of(double degrees) {
  const double turn = std::fmod(degrees, 360);
  const double quarters = std::floor(turn / 90 + 0.5);
  const double rest = (turn - 90 * quarters) * (pi / 180);
  Vec2 direction = rest == 0 ? Vec2(1, 0) : Vec2(cosine(rest), sine(rest));
  for (int i = static_cast<int>(quarters) & 3; i > 0; --i) direction = left_normal(direction);
  return direction;
}

// --- Reads the outlines of DXF objects, in the coordinates of the drawing or block that contains them.

// The name of a kind of object that is left out, in the singular and in the plural.
struct DxfName {
  const char* one;
  const char* many;
};

// An outline, perhaps without pieces, or a reason why the object cannot be read.
struct DxfDrawn {
  Outline outline;
  const char* closed_kind = nullptr;  // such as "circle"; nullptr for an open outline
  const DxfName* reason = nullptr;
  bool made_periodic = false;  // a spline marked as periodic had the knots of an open one
};

// Whether the type is LINE, ARC, CIRCLE, ELLIPSE, LWPOLYLINE, POLYLINE or SPLINE.
bool is_drawn(std::string_view type);

// The object's outline. A spline is closed if its ends differ in x and in y by at most `same_point`
// times the larger side of the box around its control points (spline.h). An ellipse is closed if
// its angle differs from a full turn by less than `same_point` radians. O(groups + vertices); for
// splines the cost is that of Outline::b_spline().
DxfDrawn draw(DxfEntity& entity, double same_point);

// --- SPLINE: a B-spline or NURBS curve.

// Reads a curve of degree 1 to 10 if its weights are positive and its knots fit the control points.
// If the curve is marked as closed, the function repeats the first control points after the last
// one in two cases: if the number of knots includes those for the repetition; or if the curve is
// also marked as periodic, has the evenly spaced knots of an open curve, and its first and last
// control points differ by more than `same_point` (outlines.h) allows. If a curve is refused, the
// result gives the reason.
DxfDrawn draw_spline(DxfEntity& entity, double same_point);

}  // namespace evenlift
