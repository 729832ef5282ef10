#include "app.h"

#include "canvas.h"
#include "panels.h"
#include "update.h"

namespace evenlift::view {

void draw_frame(App& app, const Pointer& pointer) {
  frame_view(app.state);
  interact(app.state, pointer, app.commands);
  settle(app);
  follow(app.scene, app.state);
  draw_canvas(app.state, app.scene, layout(app.state));
  draw_panels(app.state, app.commands);
}

bool settle(App& app) {
  const bool changed = apply(app.state, app.commands);
  if (changed) frame_view(app.state);
  return changed;
}

}  // namespace evenlift::view
