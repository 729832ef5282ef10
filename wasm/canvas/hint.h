// The line at the foot of the canvas: the part under the pointer and its uses.
#pragma once

#include <string>

#include "picture/canvas_view.h"

namespace evenlift::view {

// The hint; empty if there is none.
std::string hint(const AppState& state);

// The hint, shortened by last parts for which there is no space beside the view tools.
std::string shown_hint(const AppState& state, const Layout& layout);

void draw_hint(ImDrawList& list, const AppState& state, const Layout& layout, const Theme& theme);

}  // namespace evenlift::view
