#include "tools/brush.h"

#include <algorithm>
#include <cmath>

#include "evenlift/plane.h"
#include "evenlift/stands.h"

namespace evenlift::view {
namespace {

Vec2 vertex_on_screen(const AppState& state, std::size_t i) {
  const Points& vertices = state.work.document().vertices;
  return state.view.camera.to_screen(vertices[i == vertices.size() ? 0 : i]);
}

// From 0 to 1; widened to four decimals, since no-go parts are read and typed as text.
std::optional<Stretch> within_disc(const Vec2& a, const Vec2& b, const Vec2& middle,
                                   double radius) {
  const double size = length(b - a);
  if (!(size > 0)) return std::nullopt;
  const Vec2 along = (b - a) / size;
  const double at = dot(middle - a, along), aside = cross(along, middle - a);
  if (std::fabs(aside) >= radius) return std::nullopt;
  const double half = std::sqrt((radius - aside) * (radius + aside));
  constexpr double steps = 1e4;
  const Stretch part{std::clamp(std::floor((at - half) / size * steps) / steps, 0.0, 1.0),
                     std::clamp(std::ceil((at + half) / size * steps) / steps, 0.0, 1.0)};
  return part.from < part.to ? std::optional(part) : std::nullopt;
}

double reach_of(bool finger) { return finger ? finger_reach : brush_reach; }

}  // namespace

std::optional<BrushedPlace> brushed_place(const AppState& state, const Vec2& screen, bool finger) {
  std::optional<BrushedPlace> nearest;
  double least = reach_of(finger);
  for (std::size_t i = 0; i < state.work.document().vertices.size(); ++i) {
    const Vec2 a = vertex_on_screen(state, i), b = vertex_on_screen(state, i + 1);
    const Vec2 at = nearest_on_segment(a, b, screen);
    if (!(length(at - screen) < least)) continue;
    least = length(at - screen);
    nearest = {static_cast<std::uint32_t>(i), length(at - a) / std::max(length(b - a), 1e-300)};
  }
  return nearest;
}

Settings brushed(const AppState& state, const Vec2& from, const Vec2& to, bool finger) {
  Settings changed = settings(state);
  const double radius = reach_of(finger);
  const int steps = std::clamp(static_cast<int>(length(to - from) / (radius / 3)) + 1, 1, 200);
  for (std::uint32_t i = 0; i < state.work.document().vertices.size(); ++i) {
    const Vec2 a = vertex_on_screen(state, i), b = vertex_on_screen(state, i + std::size_t{1});
    for (int step = 0; step <= steps; ++step) {
      const auto part = within_disc(a, b, from + (to - from) * (double(step) / steps), radius);
      if (!part) continue;
      const EdgePart met{i, part->from, part->to};
      std::vector<EdgePart> marks =
          state.view.erases ? without_part(changed.no_go, met) : with_part(changed.no_go, met);
      if (marks.size() <= most_no_go) changed.no_go = std::move(marks);
    }
  }
  return changed;
}

Settings with_whole_edge(const AppState& state, std::uint32_t edge) {
  Settings changed = settings(state);
  std::vector<EdgePart> marks = state.view.erases ? without_part(changed.no_go, {edge, 0, 1})
                                                  : with_part(changed.no_go, {edge, 0, 1});
  if (marks.size() <= most_no_go) changed.no_go = std::move(marks);
  return changed;
}

}  // namespace evenlift::view
