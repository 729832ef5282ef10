// The picture that lies behind the drawing.
#pragma once

#include <string>

#include "evenlift/plane.h"
#include "state/state.h"

namespace evenlift::view {

// Lays a picture with these corners behind the drawing, in place of one that is there, shows all of
// it and begins to draw.
void lay_behind(AppState& state, const Vec2& low, const Vec2& high);
void take_picture_away(AppState& state);

// Makes the picture so wide; its lower left corner becomes the origin. What was traced on it goes
// with it: the vertices placed so far, or the polygon that was drawn on it, which is one step of
// undo. Does nothing without a picture. Returns why it cannot be so wide, or nothing. O(n) and a
// placement.
std::string scale_picture(AppState& state, double width);

}  // namespace evenlift::view
