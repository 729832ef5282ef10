// A picture on the canvas. The first picture shows the placement; the second, if any, shows the
// placement by the second method.
#pragma once

#include <algorithm>

#include "evenlift/tolerance.h"
#include "picture/painter.h"
#include "picture/scene.h"
#include "state/layout.h"
#include "state/state.h"

namespace evenlift::view {

struct CanvasView {
  const AppState& state;
  const Theme& theme;
  const Layout& layout;
  const Placement* placement;  // null before the first placement
  const Scene& scene;
  const Camera& camera;
  Rect window;  // the picture's part of the canvas
  bool second;  // whether this is the second method's picture
  // The part of the window that no panel covers for long. Text there is legible.
  Rect uncovered() const {
    const Rect& free = layout.free;
    return {std::max(free.left, window.left), std::max(free.top, window.top),
            std::min(free.right, window.right), std::min(free.bottom, window.bottom)};
  }
  const Report& report() const { return shown_report(state, second); }
  const Failure* failure() const { return second ? nullptr : failing(state); }
  bool overloads(std::size_t robot, double load) const {
    const auto& capacities = report().capacities;
    const auto capacity = robot < capacities.size() ? capacities[robot] : std::nullopt;
    return capacity && exceeds(load, *capacity);
  }
  bool current() const { return placement && !state.derived().refusal; }
};

}  // namespace evenlift::view
