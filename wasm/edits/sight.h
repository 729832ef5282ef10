// The visible part of the plane.
#pragma once

#include "state/state.h"

namespace evenlift::view {

// Fits the window again, until the user pans or zooms.
void fit_view(AppState& state);

// Fits the view to the polygon if due: for a new document and, until the user pans or zooms, after
// the window or its panels changed. Never during a drag.
void frame_view(AppState& state);

// Within the smallest and the largest zoom.
void look_through(AppState& state, const Camera& camera);
void zoom_view(AppState& state, const Vec2& about, double factor);

// Moves the drawing so that a cursor moved by keys stays visible.
void keep_in_sight(AppState& state, const Vec2& at);

}  // namespace evenlift::view
