// The picture behind the drawing.
#pragma once

#include <string>

#include "evenlift/plane.h"
#include "state/state.h"

namespace evenlift::view {

// Puts a picture with these corners behind the drawing, in place of any other picture. Shows the
// whole picture, and selects the tool that draws a polygon.
void lay_behind(AppState& state, const Vec2& low, const Vec2& high);
void take_picture_away(AppState& state);

// Gives the picture this width; its lower left corner becomes the origin. Also scales the vertices
// being drawn, or the polygon that was drawn on the picture. Scaling the polygon is one step of
// undo. Does nothing if there is no picture. Returns why the width is impossible, or an empty text.
// O(n), plus a placement.
std::string scale_picture(AppState& state, double width);

}  // namespace evenlift::view
