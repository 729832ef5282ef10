// What stands on the drawing at a fixed size: grips, robots, the centre of mass, numbers, the hint.
#pragma once

#include "layout.h"
#include "painter.h"
#include "scene.h"
#include "state.h"

namespace evenlift::view {

void draw_marks(const Painter& painter, const AppState& state, const Scene& scene,
                const Layout& layout, const Theme& theme);

// What can be done with what is under the pointer; empty if there is nothing to say.
std::string hint(const AppState& state);

}  // namespace evenlift::view
