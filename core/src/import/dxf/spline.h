// SPLINE: a B-spline or NURBS curve.
#pragma once

#include "import/dxf/outlines.h"

namespace evenlift {

// Reads curves of degree 1 to 10 with positive weights whose knots fit the control points. In two
// cases, a closed curve's first control points are repeated after its last. In the first, the
// number of knots includes those for this repetition. In the second, the curve is marked as
// periodic, its knots are the even knots of an open curve, and its first and last control points
// differ. Each cause of refusal has a reason of its own.
DxfDrawn draw_spline(DxfEntity& entity, double same_point);

}  // namespace evenlift
