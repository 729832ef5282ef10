// SPLINE: a B-spline or NURBS curve.
#pragma once

#include "import/dxf/outlines.h"

namespace evenlift {

// Reads curves of degree 1 to 10 with positive weights whose knots fit the control points. A closed
// curve's first control points follow the last again if its knots go on for as many spans as its
// degree. They also do if it is closed and periodic, but has even knots of an open curve whose ends
// do not meet. Each cause of refusal has a reason of its own.
DxfDrawn draw_spline(DxfEntity& entity, double same_point);

}  // namespace evenlift
