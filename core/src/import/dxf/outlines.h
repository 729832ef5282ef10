// The outlines of DXF objects, in the coordinates around them.
#pragma once

#include "curves/outline.h"
#include "import/dxf/entity.h"

namespace evenlift {

// Objects that are left out.
struct DxfName {
  const char* one;
  const char* many;
};

// An outline, perhaps without pieces, or a reason why the object cannot be read.
struct DxfDrawn {
  Outline outline;
  const char* closed_kind = nullptr;  // such as "circle"; nullptr for an open outline
  const DxfName* reason = nullptr;
  bool made_periodic =
      false;  // a spline that the object marks as periodic has knots of an open one
};

// Of LINE, ARC, CIRCLE, ELLIPSE, LWPOLYLINE, POLYLINE, SPLINE.
bool is_drawn(std::string_view type);

// Ends closer than `same_point` of a spline's larger side close it (spline.h). O(groups), for
// splines as Outline::b_spline.
DxfDrawn draw(DxfEntity& entity, double same_point);

}  // namespace evenlift
