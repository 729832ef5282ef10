// The outlines of the objects of a DXF drawing, in the coordinates of the drawing or block that
// contains them.
#pragma once

#include "curves/outline.h"
#include "import/dxf/entity.h"

namespace evenlift {

// The name of objects that are left out.
struct DxfName {
  const char* one;
  const char* many;
};

// What an object draws: nothing, if the outline has no pieces, or a reason why it cannot be read.
struct DxfDrawn {
  Outline outline;
  const char* closed_kind = nullptr;  // in words, such as "circle"; nullptr for an open outline
  const DxfName* reason = nullptr;
  bool made_periodic =
      false;  // a spline that the object marks as periodic has knots of an open one
};

// Whether objects of this type are read: LINE, ARC, CIRCLE, ELLIPSE, LWPOLYLINE, POLYLINE, SPLINE.
bool is_drawn(std::string_view type);

// What an object of such a type draws. Ends closer than `same_point` of a spline's larger side
// close it. A spline is read as spline.h says. O(groups), for splines as Outline::b_spline.
DxfDrawn draw(DxfEntity& entity, double same_point);

}  // namespace evenlift
