#include "edits/sight.h"

#include <algorithm>

#include "state/layout.h"

namespace evenlift::view {
namespace {

// Multiples of the fitting scale. A larger zoom would make screen coordinates too large for floats.
constexpr double largest_zoom = 1000, smallest_zoom = 0.25;

}  // namespace

void fit_view(AppState& state) { state.view.camera_follows = state.view.fit_due = true; }

void look_through(AppState& state, const Camera& camera) {
  const double fitting = fitting_camera(state).scale;
  state.view.camera = camera;
  state.view.camera.scale =
      std::clamp(camera.scale, fitting * smallest_zoom, fitting * largest_zoom);
  state.view.camera_follows = false;
}

void keep_in_sight(AppState& state, const Vec2& at) {
  const Rect& free = layout(state).free;
  const Vec2 spot = state.view.camera.to_screen(at);
  constexpr double edge = 48;
  const Vec2 wanted(
      std::clamp(spot.x, free.left + edge, std::max(free.left + edge, free.right - edge)),
      std::clamp(spot.y, free.top + edge, std::max(free.top + edge, free.bottom - edge)));
  if (wanted == spot) return;
  state.view.camera = pan(state.view.camera, wanted - spot);
  state.view.camera_follows = false;
}

void zoom_view(AppState& state, const Vec2& about, double factor) {
  const double fitting = fitting_camera(state).scale;
  state.view.camera =
      zoom(state.view.camera, about, factor, fitting * smallest_zoom, fitting * largest_zoom);
  state.view.camera_follows = false;
}

void frame_view(AppState& state) {
  // A polygon must not move while it is drawn; a picture may until its first vertex is traced.
  const bool drawn =
      draws(state.view.tool) && !(state.work.backdrop && state.view.drawing.points.empty());
  if (!state.view.camera_follows || state.work.edit_open || drawn) return;
  const Rect room = layout(state).room;
  if (!state.view.fit_due && room == state.view.fitted) return;
  state.view.camera = fitting_camera(state);
  state.view.fitted = room;
  state.view.fit_due = false;
}

}  // namespace evenlift::view
