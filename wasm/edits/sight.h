// Which part of the plane is seen.
#pragma once

#include "state/state.h"

namespace evenlift::view {

// The view fits its window again, until somebody pans or zooms.
void fit_view(AppState& state);

// Fits the view to the polygon if that is due: for a new document, and until somebody pans or zooms
// also after the window or its panels changed. Never during a drag.
void frame_view(AppState& state);

// Shows what this camera shows, as large as the smallest and the largest zoom allow.
void look_through(AppState& state, const Camera& camera);
void zoom_view(AppState& state, const Vec2& about, double factor);

// A cursor that keys move stays in sight: the drawing moves along.
void keep_in_sight(AppState& state, const Vec2& at);

}  // namespace evenlift::view
