// The line at the foot of the canvas: the part under the pointer, and its possible uses.
#pragma once

#include <string>

#include "picture/canvas_view.h"

namespace evenlift::view {

// Empty without a hint.
std::string hint(const AppState& state);

// The hint as far as there is room beside the view tools; its last parts are dropped first.
std::string shown_hint(const AppState& state, const Layout& layout);

void draw_hint(ImDrawList& list, const AppState& state, const Layout& layout, const Theme& theme);

// The text with a capital at its beginning, if that is a letter from a to z.

}  // namespace evenlift::view
