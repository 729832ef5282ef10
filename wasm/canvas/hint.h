// The line at the foot of the canvas: what is under the pointer, and what can be done with it.
#pragma once

#include <string>

#include "picture/canvas_view.h"

namespace evenlift::view {

// Empty if there is nothing to say.
std::string hint(const AppState& state);

// As much of it as there is room for beside the tools of the view: its last parts go first.
std::string shown_hint(const AppState& state, const Layout& layout);

void draw_hint(ImDrawList& list, const AppState& state, const Layout& layout, const Theme& theme);

// The text with a capital at its beginning, if that is a letter from a to z.

}  // namespace evenlift::view
