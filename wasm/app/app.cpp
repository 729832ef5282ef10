#include "app/app.h"

#include <imgui.h>

#include "app/update.h"
#include "canvas/canvas.h"
#include "edits/undo.h"
#include "panels/panels.h"
#include "walkthrough/walkthrough.h"

namespace evenlift::view {

namespace {

// Both pictures show the same polygon, so a point in the second becomes that point in the first.
Pointer over_one_picture(App& app, Pointer pointer) {
  const Layout places = layout(app.state);
  if (!pointer.down && !pointer.released) {
    app.over_second =
        app.state.work.second_method.has_value() && places.second.contains(pointer.at);
  }
  if (!app.over_second) return pointer;
  const Vec2 back(places.first.left - places.second.left, places.first.top - places.second.top);
  pointer.second = true;
  pointer.at += back;
  pointer.pinch_at += back;
  return pointer;
}

}  // namespace

void advance(App& app, const Pointer& pointer, double now) {
  AppState& state = app.state;
  frame_view(state);
  interact(state, over_one_picture(app, pointer), app.commands);
  settle(app);
  turn_over(state, now);
  app.layout = layout(state);
  follow(app.scene, state, reported(state), now);
  if (state.derived().second) follow(app.second_scene, state, reported(state, true), now);
}

Commands draw_frame(const App& app, bool picture) {
  const AppState& state = app.state;
  Commands commands;
  if (picture) {
    const bool moves =
        app.scene.progress < 1 || (state.derived().second && app.second_scene.progress < 1);
    if (moves) commands.push_back(LayOutAgain{});
    draw_canvas(state, app.scene, app.second_scene, app.layout);
  }
  draw_panels(state, app.layout, commands);
  return commands;
}

bool settle(App& app) {
  const bool changed = apply(app.state, app.commands);
  if (changed) frame_view(app.state);
  return changed;
}

}  // namespace evenlift::view
