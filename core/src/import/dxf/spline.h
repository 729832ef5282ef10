// SPLINE: a B-spline or NURBS curve.
#pragma once

#include "import/dxf/outlines.h"

namespace evenlift {

// Reads a curve of degree 1 to 10 if its weights are positive and its knots fit the control points.
// If the curve is marked as closed, the function repeats the first control points after the last
// one in two cases: if the number of knots includes those for the repetition; or if the curve is
// also marked as periodic, has the evenly spaced knots of an open curve, and its first and last
// control points differ by more than `same_point` (outlines.h) allows. If a curve is refused, the
// result gives the reason.
DxfDrawn draw_spline(DxfEntity& entity, double same_point);

}  // namespace evenlift
