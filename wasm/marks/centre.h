// The centre of mass, and how far it may be off.
#pragma once

#include "picture/canvas_view.h"

namespace evenlift::view {

void draw_centre(const Painter& painter, const CanvasView& view);

// How far the centre of mass may be off before the object tips; and, as a ring with a grip, within
// which distance it is known.
void draw_halo(const Painter& painter, const CanvasView& view);

}  // namespace evenlift::view
