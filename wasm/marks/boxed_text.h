// A text in a box, over the picture.
#pragma once

#include <string>

#include "picture/painter.h"

namespace evenlift::view {

// Draws it beside a spot, moved so that it is inside the window.
void draw_word(ImDrawList& list, const Vec2& spot, const Rect& window, const Theme& theme,
               Colour colour, const std::string& text);

std::string capitalised(std::string text);

}  // namespace evenlift::view
