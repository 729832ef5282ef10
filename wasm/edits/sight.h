// The visible part of the plane.
#pragma once

#include "state/state.h"

namespace evenlift::view {

// From now on, the view fits the window, until the user pans or zooms.
void fit_view(AppState& state);

// Fits the view to the polygon if that is due. Does nothing during a drag, or while a drawing tool
// is selected (if there is a picture behind the drawing, only once a vertex is drawn). Fitting is
// due for a new document and, until the user pans or zooms, after the window or its panels change.
void frame_view(AppState& state);

// Takes this camera, but keeps its scale between the smallest and the largest zoom.
void look_through(AppState& state, const Camera& camera);
void zoom_view(AppState& state, const Vec2& about, double factor);

// Moves the drawing so that a cursor moved by keys stays visible.
void keep_in_sight(AppState& state, const Vec2& at);

}  // namespace evenlift::view
