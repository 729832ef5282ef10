// The drawing: ground, picture, numbers, grips.
#pragma once

#include "layout.h"
#include "scene.h"
#include "state.h"

namespace evenlift::view {

// Draws into Dear ImGui's background, under every panel.
void draw_canvas(const AppState& state, const Scene& scene, const Layout& layout);

}  // namespace evenlift::view
