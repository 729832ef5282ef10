// SPLINE: a B-spline or NURBS curve.
#pragma once

#include "import/dxf/outlines.h"

namespace evenlift {

// Reads every curve of degree 1 to 10 with positive weights whose knots fit its control points. If
// the object says that it is closed and its knots go on for as many spans as its degree, its first
// control points follow the last again. So they do if the object says that it is closed and
// periodic, but its knots are even ones of an open curve whose ends do not meet. There is one reason for each cause of refusal.
DxfDrawn draw_spline(DxfEntity& entity, double same_point);

}  // namespace evenlift
