#include "state/camera.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "evenlift/output/words.h"
#include "evenlift/plane.h"
#include "evenlift/wording.h"
#include "state/layout.h"
#include "state/screen.h"

namespace evenlift::view {

std::optional<PartOfSegment> part_within(const Rect& rect, const Vec2& a, const Vec2& b) {
  PartOfSegment part;
  const auto bound = [&part](double start, double step, double low, double high) {
    if (step == 0) return start >= low && start <= high;
    const double first = (low - start) / step, second = (high - start) / step;
    part.from = std::max(part.from, std::min(first, second));
    part.to = std::min(part.to, std::max(first, second));
    return part.from <= part.to;
  };
  const Vec2 along = b - a;
  if (!bound(a.x, along.x, rect.left, rect.right) || !bound(a.y, along.y, rect.top, rect.bottom))
    return std::nullopt;
  return part;
}

Vec2 Camera::to_screen(const Vec2& world) const {
  return {anchor.x + (world.x - centre.x) * scale, anchor.y - (world.y - centre.y) * scale};
}

Vec2 Camera::to_world(const Vec2& screen) const {
  return {centre.x + (screen.x - anchor.x) / scale, centre.y - (screen.y - anchor.y) / scale};
}

Camera fit(const Points& points, const Rect& room) {
  Camera camera;
  camera.anchor = room.middle();
  if (points.empty()) return camera;
  const Box box = bounding_box(points);
  camera.centre = box.middle();
  // An edit may pass through a shape without extent: it is shown with a minimal one.
  const double width = std::max(box.size().x, 1e-9), height = std::max(box.size().y, 1e-9);
  camera.scale =
      std::min(std::max(room.width(), 40.0) / width, std::max(room.height(), 40.0) / height);
  return camera;
}

Camera zoom(const Camera& camera, const Vec2& about, double factor, double smallest,
            double largest) {
  Camera zoomed = camera;
  zoomed.centre = camera.to_world(about);
  zoomed.anchor = about;
  zoomed.scale = std::clamp(camera.scale * factor, smallest, largest);
  // Back to the old anchor, where the next fit or resize expects the centre.
  zoomed.centre = zoomed.to_world(camera.anchor);
  zoomed.anchor = camera.anchor;
  return zoomed;
}

Camera pan(const Camera& camera, const Vec2& pixels) {
  Camera panned = camera;
  panned.centre = camera.to_world(camera.anchor - pixels);
  return panned;
}

double grid_step(const Camera& camera) {
  const double wanted = 22 / camera.scale, power = std::pow(10.0, std::floor(std::log10(wanted)));
  for (double nice : {1.0, 2.0, 5.0}) {
    if (nice * power >= wanted) return nice * power;
  }
  return 10 * power;
}

Vec2 nearest_dot(const Camera& camera, const Vec2& world) {
  const double step = grid_step(camera), inverse = std::round(1 / step);
  // A quotient or product of integers is rounded once, to the double nearest to the decimal.
  const auto nearest = [&](double value) {
    const double dots = std::round(value / step);
    const double at = step < 1 ? dots / inverse : dots * step;
    return at == 0 ? 0.0 : at;  // no -0
  };
  return {nearest(world.x), nearest(world.y)};
}

namespace {

Vec2 rounded(const Camera& camera, const Vec2& world, int more) {
  const int decimals =
      std::clamp(static_cast<int>(std::ceil(std::log10(camera.scale))) + more, -6, 12);
  const double power = std::pow(10.0, std::abs(decimals));
  const auto round = [&](double value) {
    const double nearest =
        decimals >= 0 ? std::round(value * power) / power : std::round(value / power) * power;
    return nearest == 0 ? 0.0 : nearest;
  };
  return {round(world.x), round(world.y)};
}

}  // namespace

Vec2 rounded_to_pixels(const Camera& camera, const Vec2& world) {
  return rounded(camera, world, 0);
}

Vec2 rounded_finely(const Camera& camera, const Vec2& world) { return rounded(camera, world, 2); }

namespace {

// In presentation mode the screen counts as about this large, to be legible from the last row:
// steps have it to themselves, and the tool needs room for its settings.
struct Room {
  double width, height;
};
constexpr Room room_of_steps{880, 500}, room_of_tool{820, 540};

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

namespace {

// Enough to read the text twice, at 15 letters a second.
double reading_time(std::string_view text) { return 4 + 2 * static_cast<double>(text.size()) / 15; }

}  // namespace

void emit(AppState& state, Effect effect) { state.session.effects.push_back(std::move(effect)); }

void announce(AppState& state, std::string text) {
  emit(state, Announce{std::string(translated(text))});
}

void show(AppState& state, Notice notice) {
  // A repeated refusal is announced again, but not for each point of a drag.
  const bool again = notice.kind == Notice::Kind::problem && !state.work.edit_open;
  if (again || notice.text != state.session.notice.text) announce(state, notice.text);
  state.session.notice = std::move(notice);
  const bool ends =
      !state.session.notice.text.empty() && state.session.notice.kind != Notice::Kind::problem;
  emit(state,
       EndNoticeAfter{ends ? std::optional(reading_time(translated(state.session.notice.text)))
                           : std::nullopt});
}

void end_notice(AppState& state) {
  if (state.session.notice.kind != Notice::Kind::problem) state.session.notice = {};
}

}  // namespace evenlift::view
