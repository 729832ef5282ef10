// The canvas: the background, and the pictures with their numbers and grips.
#pragma once

#include "picture/scene.h"
#include "state/layout.h"
#include "state/state.h"

namespace evenlift::view {

// Draws into Dear ImGui's background, under every panel. `second` is the scene of the second
// method.
void draw_canvas(const AppState& state, const Scene& scene, const Scene& second,
                 const Layout& layout);

}  // namespace evenlift::view
