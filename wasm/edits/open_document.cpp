#include "edits/undo.h"

#include <algorithm>
#include <utility>

#include "evenlift/output/words.h"
#include "evenlift/wording.h"
#include "state/layout.h"
#include "state/screen.h"

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

namespace {

void forget_former(AppState& state) {
  if (draws(state.view.tool)) state.view.tool = Tool::parts;
  state.view.drawing = {};
  state.view.selected.reset();
  state.work.aside = {};
  if (state.work.backdrop) state.work.backdrop->traced = false;
  state.view.hover = state.view.held = {};
  if (state.view.task) state.view.challenge = false;
  state.view.task.reset();
  // A new walkthrough begins at the document's step, if any.
  state.view.walkthrough.trace.reset();
  state.view.walkthrough.script.reset();
  state.view.walkthrough.aside.reset();
  state.view.walkthrough.of_lesson = false;
  state.view.walkthrough.playing = false;
  state.view.walkthrough.visited.clear();
  state.view.walkthrough.guesses = {};
  state.view.walkthrough.at = 0;
  state.view.walkthrough.all_steps = false;
  fit_view(state);
}

}  // namespace

void show_opened(AppState& state, Opened opened) {
  forget_former(state);
  show(state, {});
  state.work.edit() = std::move(opened.document);
  state.given = {std::move(opened.placement), std::move(opened.trace), {}, {}};
}

void open(AppState& state, Opened opened, Edit edit) {
  begin_edit(state, false, edit);
  ++state.session.opened;
  if (edit == Edit::lesson_opened)
    state.work.second_method.reset();  // a lesson uses the whole picture
  const bool left_robots = opened.left_robots;
  show_opened(state, std::move(opened));
  if (left_robots)
    show(state, {Notice::Kind::info,
                 say("The robots are placed by {method}: yours stay with the former object.",
                     {method_in_words(settings(state).method)}),
                 say("Back to mine")});
}

void start_with(AppState& state, Opened opened, const std::optional<Document>& work) {
  if (work) {
    state.work.edit() = *work;
    open(state, std::move(opened));
  } else {
    show_opened(state, std::move(opened));
  }
}

void resume_draft(AppState& state, Document draft) {
  Document& document = edit(state, false, Edit::vertex_moved);
  forget_former(state);
  document = std::move(draft);
  document.moved = {};
}

}  // namespace evenlift::view
