// Reads the outlines of DXF objects, in the coordinates of the drawing or block that contains them.
#pragma once

#include "curves/outline.h"
#include "import/dxf/drawing.h"

namespace evenlift {

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

}  // namespace evenlift
