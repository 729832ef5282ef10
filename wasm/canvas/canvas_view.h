// One of the pictures on the canvas: the placement, or beside it that of another method.
#pragma once

#include "canvas/painter.h"
#include "canvas/scene.h"
#include "state/layout.h"
#include "state/state.h"

namespace evenlift::view {

struct CanvasView {
  const AppState& state;
  const Theme& theme;
  const Layout& layout;
  const Placement* placement;  // null: there is none yet
  const Scene& scene;
  const Camera& camera;
  Rect window;  // what of the canvas is this picture's
  bool other;   // of the method that is compared
  bool current() const { return placement && !state.refusal; }
};

}  // namespace evenlift::view
