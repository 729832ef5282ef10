#include "tools/drawing.h"

#include <algorithm>
#include <cmath>

#include "evenlift/angles.h"
#include "evenlift/document.h"
#include "evenlift/numbers.h"
#include "evenlift/output/words.h"
#include "evenlift/plane.h"
#include "evenlift/predicates.h"
#include "evenlift/stands.h"
#include "evenlift/supports.h"
#include "evenlift/wording.h"
#include "state/camera.h"

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

namespace {

constexpr std::string_view first_line_of_hole = "hole\n";

constexpr double half_turn = 180;

int sign(double value) { return (value > 0) - (value < 0); }

bool within_box(const Vec2& a, const Vec2& b, const Vec2& p) {
  return std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) && std::min(a.y, b.y) <= p.y &&
         p.y <= std::max(a.y, b.y);
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

// Moves `value` to the nearer of two lines, if within reach.
void pull(double& value, double first, double second, double reach) {
  const double nearer = std::abs(value - first) <= std::abs(value - second) ? first : second;
  if (std::abs(value - nearer) <= reach) value = nearer;
}

// Per unit of length: a million divided by the least power of ten that is at least `size`. Without
// a library logarithm, a typed edge has the same bits everywhere.
double units_of_rounding(double size) {
  double above = 1, below = 1;
  while (above < size) above *= 10;
  while (below < 1e300 && size * below * 10 <= 1) below *= 10;
  return 1e6 * below / above;
}

}  // namespace

bool closes(const AppState& state, const Vec2& screen) {
  const Points& points = state.view.drawing.points;
  return points.size() >= 3 &&
         length(state.view.camera.to_screen(points.front()) - screen) <= closing_reach;
}

std::optional<std::size_t> placed_at(const AppState& state, const Vec2& screen) {
  double reach = state.session.screen.touch ? 22.0 : 10.0;
  std::optional<std::size_t> nearest;
  const Points& points = state.view.drawing.points;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double away = length(state.view.camera.to_screen(points[i]) - screen);
    if (away > reach) continue;
    reach = away;
    nearest = i;
  }
  return nearest;
}

Edge edge_between(const Vec2& from, const Vec2& to) {
  const Vec2 along = to - from;
  return {length(along), arctangent2(along.y, along.x) * half_turn / pi};
}

std::string length_in_words(const AppState& state, double length) {
  const double step = grid_step(state.view.camera);
  return fixed(length, std::clamp(static_cast<int>(std::ceil(-std::log10(step))) + 1, 0, 6));
}

std::string edge_in_words(const AppState& state, const Vec2& from, const Vec2& to) {
  const Edge edge = edge_between(from, to);
  return say("{length} long · {angle}",
             {length_in_words(state, edge.length), fixed(edge.degrees, 1) + "°"});
}

Vec2 typed_end(const Drawing& drawing, const Vec2& wanted) {
  const Vec2& from = drawing.points.back();
  const Edge edge = edge_between(from, wanted);
  const double size = drawing.length.value_or(edge.length),
               angle = drawing.degrees.value_or(edge.degrees) * pi / half_turn;
  const double power = units_of_rounding(size);
  const auto rounded = [&](double value) {
    const double nearest = std::round(value * power) / power;
    return nearest == 0 || !std::isfinite(nearest) ? 0.0 : nearest;
  };
  return {rounded(from.x + size * cosine(angle)), rounded(from.y + size * sine(angle))};
}

std::optional<Vec2> centroid_of(const Points& chain) {
  if (chain.size() < 3) return std::nullopt;
  Vec2 sum;
  double twice = 0;
  const Vec2& origin = chain.front();
  for (std::size_t i = 1; i + 1 < chain.size(); ++i) {
    const Vec2 a = chain[i] - origin, b = chain[i + 1] - origin;
    twice += cross(a, b);
    sum += (a + b) * cross(a, b);
  }
  if (twice == 0) return std::nullopt;
  return origin + sum / (3 * twice);
}

Vec2 snapped(const AppState& state, const Vec2& to) {
  return state.view.snap.grid ? nearest_dot(state.view.camera, to)
                              : rounded_to_pixels(state.view.camera, to);
}

Vec2 snapped(const AppState& state, const Vec2& to, const Vec2& before, const Vec2& after) {
  Vec2 at = snapped(state, to);
  if (state.view.snap.axis) {
    const double reach = 12 / state.view.camera.scale;
    double x = to.x, y = to.y;
    pull(x, before.x, after.x, reach);
    pull(y, before.y, after.y, reach);
    if (x != to.x) at.x = x;
    if (y != to.y) at.y = y;
  }
  return at;
}

Vec2 next_point(const AppState& state, const Vec2& world) {
  const Points& points = state.view.drawing.points;
  if (!points.empty() && (state.view.drawing.length || state.view.drawing.degrees))
    return typed_end(state.view.drawing, world);
  if (!points.empty()) return snapped(state, world, points.back(), points.front());
  return snapped(state, world);
}

std::vector<std::pair<std::size_t, std::size_t>> crossings(const Points& chain) {
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  if (chain.size() > 1000) return pairs;
  for (std::size_t j = 1; j + 1 < chain.size(); ++j) {
    if (fold_back(chain[j - 1], chain[j], chain[j + 1])) pairs.emplace_back(j - 1, j);
    for (std::size_t i = 0; i + 1 < j; ++i) {
      // The last edge of a closed chain ends where the first begins.
      if (i == 0 && j + 2 == chain.size() && chain.front() == chain.back()) continue;
      if (meet(chain[i], chain[i + 1], chain[j], chain[j + 1])) pairs.emplace_back(i, j);
    }
  }
  return pairs;
}

std::string drawing_text(const Drawing& drawing, bool is_hole) {
  std::string text(is_hole && !drawing.points.empty() ? first_line_of_hole : "");
  for (const Vec2& p : drawing.points) text += shortest(p.x) + "," + shortest(p.y) + "\n";
  return text;
}

std::optional<KeptDrawing> read_drawing(std::string_view text) {
  KeptDrawing kept;
  kept.is_hole = text.starts_with(first_line_of_hole);
  if (kept.is_hole) text.remove_prefix(first_line_of_hole.size());
  Points& points = kept.points;
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
  return kept;
}

namespace {

// The nearest vertex or else the nearest point, within reach.
std::optional<Vec2> on_outline(const Points& vertices, const Vec2& to, double reach) {
  std::optional<Vec2> edge;
  double least = reach;
  for (const Vec2& vertex : vertices) {
    if (length(vertex - to) > least) continue;
    least = length(vertex - to);
    edge = vertex;
  }
  if (edge) return edge;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const Vec2 at =
        nearest_on_segment(vertices[i], vertices[i + 1 == vertices.size() ? 0 : i + 1], to);
    if (length(at - to) > least) continue;
    least = length(at - to);
    edge = at;
  }
  return edge;
}

}  // namespace

std::optional<Vec2> even_spot(const AppState& state, const Vec2& to,
                              std::optional<std::size_t> robot, double reach) {
  const Placement& placement = *state.derived().placement;
  const SupportPlacer placer(placement.object, placement.settings);
  const Points robots = positions(lifting_points(placement.teams));
  std::optional<Vec2> nearest;
  double least = reach / state.view.camera.scale;
  for (std::size_t i = 0; i < robots.size(); ++i) {
    if (robot == i) continue;
    const Vec2 opposite = 2 * placement.centre_of_mass - robots[i];
    if (length(opposite - to) > least || !placer.place(opposite)) continue;
    least = length(opposite - to);
    nearest = opposite;
  }
  return nearest;
}

std::optional<Vec2> support_spot(const AppState& state, const Vec2& to,
                                 std::optional<std::size_t> robot) {
  if (const auto even = even_spot(state, to, robot, even_reach)) return even;
  const Placement& placement = *state.derived().placement;
  if (const auto edge = on_outline(placement.vertices(), to, edge_reach / state.view.camera.scale))
    return edge;
  if (!inside(placement.vertices(), to) || placement.object.hole_around(to)) return std::nullopt;
  return rounded_to_pixels(state.view.camera, to);
}

bool holds_support(const AppState& state) {
  const Pick::Kind held = state.view.held.kind;
  return (held == Pick::Kind::robot || held == Pick::Kind::left_out) && state.work.edit_open &&
         state.work.document().settings.method == Method::given;
}

namespace {

// In the order of the list of vertices.
Points forward_way(const Points& vertices, const LiftingPoint& from, const LiftingPoint& to) {
  const std::size_t n = vertices.size();
  const Vec2& start = vertices[from.edge];
  const bool ahead = length(to.position - start) >= length(from.position - start);
  Points way{from.position};
  if (from.edge != to.edge || !ahead) {
    std::size_t edge = from.edge;
    do {
      edge = (edge + 1) % n;
      way.push_back(vertices[edge]);
    } while (edge != to.edge);
  }
  way.push_back(to.position);
  return way;
}

double length_of(const Points& way) {
  double sum = 0;
  for (std::size_t i = 1; i < way.size(); ++i) sum += length(way[i] - way[i - 1]);
  return sum;
}

}  // namespace

Points shorter_way(const Points& vertices, const LiftingPoint& from, const LiftingPoint& to) {
  Points there = forward_way(vertices, from, to), back = forward_way(vertices, to, from);
  if (length_of(there) <= length_of(back)) return there;
  std::reverse(back.begin(), back.end());
  return back;
}

std::string closed_in_words(const Placement& placement, std::size_t robot) {
  return say(placement.settings.method == Method::balanced
                 ? "Robot {robot} cannot go there: no two neighbours could keep all loads equal."
                 : "Robot {robot} cannot go there: other robots are in the way.",
             {placement.number_of(robot)});
}

bool can_go_on_drawing(const AppState& state) {
  const std::optional<LeftDrawing>& left = state.view.left_drawing;
  return left && left->edits == state.work.edits() && left->depth == state.work.history.depth() &&
         state.view.drawing.points.empty();
}

}  // namespace evenlift::view
