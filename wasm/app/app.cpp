#include "app/app.h"

#include <imgui.h>

#include "app/update.h"
#include "canvas/canvas.h"
#include "panels/panels.h"
#include "state/browser.h"
#include "walkthrough/walkthrough.h"

namespace evenlift::view {

namespace {

// Both pictures show the same polygon: over the second, the pointer is where it would be over the
// first.
Pointer over_one_picture(App& app, Pointer pointer) {
  const Layout places = layout(app.state);
  if (!pointer.down && !pointer.released) {
    app.over_other = app.state.compared.has_value() && places.second.contains(pointer.at);
  }
  if (!app.over_other) return pointer;
  const Vec2 back(places.first.left - places.second.left, places.first.top - places.second.top);
  pointer.other = true;
  pointer.at += back;
  pointer.pinch_at += back;
  return pointer;
}

void draw_picture(App& app, double now) {
  follow(app.scene, app.state, *app.state.placement, now);
  if (app.state.other) follow(app.other_scene, app.state, *app.state.other, now);
  if (app.scene.progress < 1 || (app.state.other && app.other_scene.progress < 1))
    browser::request_frame();
  draw_canvas(app.state, app.scene, app.other_scene, layout(app.state));
}

}  // namespace

void draw_frame(App& app, const Pointer& pointer, bool picture) {
  frame_view(app.state);
  interact(app.state, over_one_picture(app, pointer), app.commands);
  settle(app);
  const double now = ImGui::GetTime();
  turn_over(app.state, now);
  if (picture) draw_picture(app, now);
  draw_panels(app.state, app.commands);
}

bool settle(App& app) {
  const bool changed = apply(app.state, app.commands);
  if (changed) frame_view(app.state);
  return changed;
}

}  // namespace evenlift::view
