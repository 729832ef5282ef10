#include "state/screen.h"

#include <algorithm>

#include "state/layout.h"
#include "state/notice.h"

namespace evenlift::view {
namespace {

// In presentation mode the screen counts as about this large, to be legible from the last row:
// steps have it to themselves, and the tool needs room for its settings.
struct Room {
  double width, height;
};
constexpr Room room_of_steps{880, 500}, room_of_tool{960, 540};

double zoom_for(const AppState& state) {
  if (!state.view.presenting) return 1;
  const Screen& screen = state.session.screen;
  const Room& room = presents_steps(state) ? room_of_steps : room_of_tool;
  const double fitting = std::min(screen.css_width / room.width, screen.css_height / room.height);
  return std::clamp(fitting, 1.0, 5.0);
}

void measure_screen(AppState& state) {
  Screen& screen = state.session.screen;
  screen.zoom = zoom_for(state);
  screen.width = screen.css_width / screen.zoom;
  screen.height = screen.css_height / screen.zoom;
  screen.ratio = screen.css_ratio * screen.zoom;
}

}  // namespace

void scale_screen(AppState& state) {
  if (zoom_for(state) != state.session.screen.zoom) measure_screen(state);
}

void set_canvas(AppState& state, double css_width, double css_height, double css_ratio) {
  Screen& screen = state.session.screen;
  screen.css_width = css_width;
  screen.css_height = css_height;
  screen.css_ratio = css_ratio;
  measure_screen(state);
}

void cover_screen(AppState& state, double left, double right, double foot) {
  Screen& screen = state.session.screen;
  screen.window_left = std::clamp(left / screen.zoom, 0.0, screen.width);
  screen.window_right = std::clamp(right / screen.zoom, 0.0, screen.width);
  screen.window_foot = std::clamp(foot / screen.zoom, 0.0, screen.height);
}

void make_room(AppState& state, double height) {
  Screen& screen = state.session.screen;
  screen.foot = 0;
  screen.card = height / screen.zoom;
  if (height > 0)
    screen.foot = std::max(0.0, layout(state).free.bottom - card_seat(state).bottom + screen.card);
}

void set_presenting(AppState& state, bool on) {
  if (state.view.presenting == on) return;
  state.view.presenting = on;
  // A task's card has the words and the goals; the drawing needs the panel's room.
  if (on && state.view.task) state.view.panel_open = false;
  measure_screen(state);
  emit(state, ShowFullScreen{on});
}

}  // namespace evenlift::view
