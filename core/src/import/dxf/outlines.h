// The outlines of DXF objects, in the coordinates around them.
#pragma once

#include "curves/outline.h"
#include "import/dxf/entity.h"

namespace evenlift {

// The name of a kind of objects that are left out, for one and for several of them.
struct DxfName {
  const char* one;
  const char* many;
};

// An outline, perhaps without pieces, or a reason why the object cannot be read.
struct DxfDrawn {
  Outline outline;
  const char* closed_kind = nullptr;  // such as "circle"; nullptr for an open outline
  const DxfName* reason = nullptr;
  bool made_periodic = false;  // a spline marked as periodic has the knots of an open one
};

// Whether the type is LINE, ARC, CIRCLE, ELLIPSE, LWPOLYLINE, POLYLINE or SPLINE.
bool is_drawn(std::string_view type);

// The object's outline. A spline is closed if its ends are within `same_point` times the larger
// side of its control points' box (spline.h). O(groups); for splines the cost is that of
// Outline::b_spline.
DxfDrawn draw(DxfEntity& entity, double same_point);

}  // namespace evenlift
