#include "edits/sight.h"

#include <algorithm>

#include "state/layout.h"

namespace evenlift::view {
namespace {

// Times the view that fits. Larger ones would make screen coordinates unfit for floats.
constexpr double largest_zoom = 1000, smallest_zoom = 0.25;

}  // namespace

void fit_view(AppState& state) { state.camera_follows = state.fit_due = true; }

void look_through(AppState& state, const Camera& camera) {
  const double fitting = fitting_camera(state).scale;
  state.camera = camera;
  state.camera.scale = std::clamp(camera.scale, fitting * smallest_zoom, fitting * largest_zoom);
  state.camera_follows = false;
}

void keep_in_sight(AppState& state, const Vec2& at) {
  const Rect& free = layout(state).free;
  const Vec2 spot = state.camera.to_screen(at);
  constexpr double edge = 48;
  const Vec2 wanted(
      std::clamp(spot.x(), free.left + edge, std::max(free.left + edge, free.right - edge)),
      std::clamp(spot.y(), free.top + edge, std::max(free.top + edge, free.bottom - edge)));
  if (wanted == spot) return;
  state.camera = pan(state.camera, wanted - spot);
  state.camera_follows = false;
}

void zoom_view(AppState& state, const Vec2& about, double factor) {
  const double fitting = fitting_camera(state).scale;
  state.camera = zoom(state.camera, about, factor, fitting * smallest_zoom, fitting * largest_zoom);
  state.camera_follows = false;
}

void frame_view(AppState& state) {
  // A polygon that is being drawn must not move under the hand; a picture may until its first vertex is traced.
  const bool drawn = state.tool == Tool::draw && !(state.backdrop && state.drawing.points.empty());
  if (!state.camera_follows || state.edit_open || drawn) return;
  const Rect room = layout(state).room;
  if (!state.fit_due && room == state.fitted) return;
  state.camera = fitting_camera(state);
  state.fitted = room;
  state.fit_due = false;
}

}  // namespace evenlift::view
