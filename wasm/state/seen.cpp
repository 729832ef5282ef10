#include "state/seen.h"

#include <algorithm>
#include <cstddef>

#include "evenlift/output/words.h"
#include "state/layout.h"

namespace evenlift::view {

bool centre_is_shown(const AppState& state) {
  return !state.work.document().centre_of_mass ||
         layout(state).free.contains(
             state.view.camera.to_screen(*state.work.document().centre_of_mass));
}

bool vertices_are_shown(const AppState& state) {
  const Rect free = layout(state).free;
  const Points& vertices = state.work.document().vertices;
  return std::all_of(vertices.begin(), vertices.end(),
                     [&](const Vec2& p) { return free.contains(state.view.camera.to_screen(p)); });
}

bool well_shown(const AppState& state) {
  const double best = fitting_camera(state).scale;
  if (state.view.camera.scale < best * 0.7) return false;
  const Rect window = state.session.screen.area();
  return std::all_of(
      state.work.document().vertices.begin(), state.work.document().vertices.end(),
      [&](const Vec2& p) { return window.contains(state.view.camera.to_screen(p)); });
}

std::string zoom_in_words(const AppState& state) {
  if (state.view.camera_follows || state.work.document().vertices.empty()) return "100\u00A0%";
  return fixed(100 * state.view.camera.scale / fitting_camera(state).scale, 0) + "\u00A0%";
}

bool outline_is_seen(const AppState& state) {
  const Rect free = layout(state).free;
  const Points& vertices = state.work.document().vertices;
  const auto on_screen = [&](const Vec2& p) { return state.view.camera.to_screen(p); };
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const Vec2 from = on_screen(vertices[i]), to = on_screen(vertices[(i + 1) % vertices.size()]);
    if (part_within(free, from, to)) return true;
  }
  return false;
}

}  // namespace evenlift::view
