// The drawing: background, picture, numbers, grips.
#pragma once

#include "picture/scene.h"
#include "state/layout.h"
#include "state/state.h"

namespace evenlift::view {

// Draws into Dear ImGui's background, under every panel. `second` is the compared method's scene.
void draw_canvas(const AppState& state, const Scene& scene, const Scene& second,
                 const Layout& layout);

}  // namespace evenlift::view
