#include "state/seen.h"

#include <algorithm>
#include <cstddef>

#include "evenlift/output/words.h"
#include "state/layout.h"

namespace evenlift::view {

bool centre_is_shown(const AppState& state) {
  return !state.document.centre_of_mass ||
         layout(state).free.contains(state.camera.to_screen(*state.document.centre_of_mass));
}

bool well_shown(const AppState& state) {
  const double best = fitting_camera(state).scale;
  if (state.camera.scale < best * 0.7) return false;
  const Rect window = state.screen.area();
  return std::all_of(state.document.vertices.begin(), state.document.vertices.end(),
                     [&](const Vec2& p) { return window.contains(state.camera.to_screen(p)); });
}

std::string zoom_in_words(const AppState& state) {
  if (state.camera_follows || state.document.vertices.empty()) return "100\u00A0%";
  return fixed(100 * state.camera.scale / fitting_camera(state).scale, 0) + "\u00A0%";
}

bool outline_is_seen(const AppState& state) {
  const Rect free = layout(state).free;
  const Points& vertices = state.document.vertices;
  const auto on_screen = [&](const Vec2& p) { return state.camera.to_screen(p); };
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const Vec2 from = on_screen(vertices[i]), to = on_screen(vertices[(i + 1) % vertices.size()]);
    if (part_within(free, from, to)) return true;
  }
  return false;
}

}  // namespace evenlift::view
