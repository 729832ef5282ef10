#include "state/screen.h"

#include <algorithm>

#include "state/browser.h"

namespace evenlift::view {
namespace {

// Before a room the screen counts as one of about this size, whose letters are read from the last row.
constexpr double room_width = 880, room_height = 500;

void measure_screen(AppState& state) {
  Screen& screen = state.screen;
  const double fitting = std::min(screen.css_width / room_width, screen.css_height / room_height);
  screen.zoom = state.presenting ? std::clamp(fitting, 1.0, 5.0) : 1;
  screen.width = screen.css_width / screen.zoom;
  screen.height = screen.css_height / screen.zoom;
  screen.ratio = screen.css_ratio * screen.zoom;
}

}  // namespace

void set_canvas(AppState& state, double css_width, double css_height, double css_ratio) {
  Screen& screen = state.screen;
  screen.css_width = css_width;
  screen.css_height = css_height;
  screen.css_ratio = css_ratio;
  measure_screen(state);
}

void set_presenting(AppState& state, bool on) {
  if (state.presenting == on) return;
  state.presenting = on;
  measure_screen(state);
  browser::show_full_screen(on);
}

}  // namespace evenlift::view
