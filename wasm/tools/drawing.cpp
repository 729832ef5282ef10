#include "tools/drawing.h"

#include <algorithm>
#include <cmath>

#include "evenlift/document.h"
#include "evenlift/numbers.h"
#include "evenlift/predicates.h"

namespace evenlift::view {
namespace {

int sign(double value) { return (value > 0) - (value < 0); }

bool within_box(const Vec2& a, const Vec2& b, const Vec2& p) {
  return std::min(a.x(), b.x()) <= p.x() && p.x() <= std::max(a.x(), b.x()) &&
         std::min(a.y(), b.y()) <= p.y() && p.y() <= std::max(a.y(), b.y());
}

bool meet(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  const int abc = sign(orient(a, b, c)), abd = sign(orient(a, b, d));
  const int cda = sign(orient(c, d, a)), cdb = sign(orient(c, d, b));
  if (abc * abd < 0 && cda * cdb < 0) return true;
  return (abc == 0 && within_box(a, b, c)) || (abd == 0 && within_box(a, b, d)) ||
         (cda == 0 && within_box(c, d, a)) || (cdb == 0 && within_box(c, d, b));
}

// Whether the edges a b and b c overlap.
bool fold_back(const Vec2& a, const Vec2& b, const Vec2& c) {
  return sign(orient(a, b, c)) == 0 && dot_of_differences(b, a, b, c) > 0;
}

// Moves the value to the nearer of two lines, if that is within reach.
void pull(double& value, double first, double second, double reach) {
  const double nearer = std::abs(value - first) <= std::abs(value - second) ? first : second;
  if (std::abs(value - nearer) <= reach) value = nearer;
}

}  // namespace

bool closes(const AppState& state, const Vec2& screen) {
  const Points& points = state.drawing.points;
  return points.size() >= 3 &&
         length(state.camera.to_screen(points.front()) - screen) <= closing_reach;
}

Vec2 snapped(const AppState& state, const Vec2& to, const Vec2& before, const Vec2& after) {
  Vec2 at = state.snap.grid ? nearest_dot(state.camera, to) : rounded_to_pixels(state.camera, to);
  if (state.snap.axis) {
    const double reach = 12 / state.camera.scale;
    double x = to.x(), y = to.y();
    pull(x, before.x(), after.x(), reach);
    pull(y, before.y(), after.y(), reach);
    if (x != to.x()) at.x() = x;
    if (y != to.y()) at.y() = y;
  }
  return at;
}

Vec2 next_point(const AppState& state, const Vec2& world) {
  const Points& points = state.drawing.points;
  if (!points.empty()) return snapped(state, world, points.back(), points.front());
  return state.snap.grid ? nearest_dot(state.camera, world)
                         : rounded_to_pixels(state.camera, world);
}

std::vector<std::pair<std::size_t, std::size_t>> crossings(const Points& chain) {
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  if (chain.size() > 1000) return pairs;
  for (std::size_t j = 1; j + 1 < chain.size(); ++j) {
    if (fold_back(chain[j - 1], chain[j], chain[j + 1])) pairs.emplace_back(j - 1, j);
    for (std::size_t i = 0; i + 1 < j; ++i) {
      // A closed chain's last edge ends where its first begins.
      if (i == 0 && j + 2 == chain.size() && chain.front() == chain.back()) continue;
      if (meet(chain[i], chain[i + 1], chain[j], chain[j + 1])) pairs.emplace_back(i, j);
    }
  }
  return pairs;
}

std::string drawing_text(const Drawing& drawing) {
  std::string text;
  for (const Vec2& p : drawing.points) text += shortest(p.x()) + "," + shortest(p.y()) + "\n";
  return text;
}

std::optional<Points> read_drawing(std::string_view text) {
  Points points;
  while (!text.empty()) {
    const std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
    const std::size_t comma = line.find(',');
    if (comma == std::string_view::npos || points.size() == max_link_vertices) return std::nullopt;
    const auto x = read_number(line.substr(0, comma)), y = read_number(line.substr(comma + 1));
    if (!x || !y || std::abs(*x) > max_coordinate || std::abs(*y) > max_coordinate)
      return std::nullopt;
    points.push_back({*x, *y});
  }
  return points;
}

}  // namespace evenlift::view
