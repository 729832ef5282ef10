#include "evenlift/output/picture.h"

#include <algorithm>
#include <cmath>

#include "evenlift/angles.h"

namespace evenlift {
namespace {

void add_area(std::vector<Shape>& shapes, Role role, const Points& points) {
  if (!points.empty()) shapes.push_back({role, points});
}

// Of `count` lines, every stride-th is shown.
std::size_t stride(std::size_t count, std::size_t most) {
  return count <= most ? 1 : (count - 1) / most + 1;
}

// Candidates of no team.
void add_candidates(std::vector<Shape>& shapes, const Placement& placement, std::size_t most) {
  std::vector<bool> taken(placement.candidates.size(), false);
  for (const std::uint32_t i : placement.team_candidates) taken[i] = true;
  for (std::size_t i = 0; i < taken.size(); i += stride(taken.size(), most)) {
    if (taken[i]) continue;
    const Chord& chord = placement.candidates[i].chord;
    shapes.push_back({Role::candidate, {chord.r1.position, chord.r2.position}});
  }
}

void add_cargo(std::vector<Shape>& shapes, const Placement& placement) {
  const std::vector<Cargo>& cargo = placement.settings.cargo;
  if (cargo.empty()) return;
  const std::vector<double> radii = cargo_radii(placement);
  for (std::uint32_t i = 0; i < cargo.size(); ++i)
    shapes.push_back({.role = Role::cargo,
                      .points = {cargo[i].at},
                      .load = cargo[i].weight,
                      .item = i,
                      .radius = radii[i]});
  shapes.push_back({Role::cargo_lever, {placement.own_centre, placement.centre_of_mass}});
  shapes.push_back({Role::own_centre, {placement.own_centre}});
}

}  // namespace

std::vector<double> cargo_radii(const Placement& placement) {
  const Settings& settings = placement.settings;
  const double most = largest_cargo_disc * placement.polygon().diameter();
  double largest = 0;
  std::vector<double> radii;
  for (const Cargo& item : settings.cargo) {
    radii.push_back(std::sqrt(placement.object.area() * (item.weight / settings.weight) / pi));
    largest = std::max(largest, radii.back());
  }
  if (largest > most)
    for (double& radius : radii) radius *= most / largest;
  return radii;
}

std::vector<Segment> joining_lines(const Team& team, const Vec2& centre) {
  const std::vector<Robot>& robots = team.robots;
  if (robots.size() == 2) return {{robots[0].point.position, robots[1].point.position}};
  std::vector<Segment> lines;
  for (const Robot& robot : robots) lines.push_back({robot.point.position, centre});
  return lines;
}

std::vector<TallyStroke> tally(std::size_t team, const Vec2& at, const Vec2& outward,
                               double radius) {
  constexpr double stroke = 7, apart = 5;  // pixels
  const double way = length(outward);
  const Vec2 out = way > 0 ? outward / way : Vec2(0, 1);
  const Vec2 across(-out.y, out.x);
  const std::size_t fives = team / 5, strokes = fives + team % 5;
  std::vector<TallyStroke> marks;
  for (std::size_t i = 0; i < strokes; ++i) {
    const double aside = apart * (static_cast<double>(i) - static_cast<double>(strokes - 1) / 2);
    const Vec2 from = at + radius * out + aside * across;
    marks.push_back({{from, from + stroke * out}, i < fives});
  }
  return marks;
}

std::vector<Shape> make_picture(const Placement& placement, const Overlays& overlays,
                                std::size_t most_lines) {
  std::vector<Shape> shapes;
  shapes.push_back({.role = Role::object,
                    .points = placement.vertices(),
                    .holes = placement.object.rings_of_holes()});
  // Without contacts every point is free: there is no region.
  const bool touches = placement.closure.margin.has_value();
  if (touches && overlays.clockwise)
    add_area(shapes, Role::clockwise, placement.closure.clockwise.clipped);
  if (touches && overlays.counterclockwise)
    add_area(shapes, Role::counterclockwise, placement.closure.counterclockwise.clipped);
  if (overlays.lifting_base) add_area(shapes, Role::lifting_base, placement.lifting_base);
  // Balanced robots and supports have no candidates.
  if (overlays.candidates && !is_one_team(placement.settings.method))
    add_candidates(shapes, placement, most_lines);
  const auto teams = static_cast<std::uint32_t>(placement.teams.size());
  if (overlays.chords) {
    const auto step = static_cast<std::uint32_t>(stride(placement.teams.size(), most_lines));
    for (std::uint32_t i = 0; i < teams; i += step) {
      for (const Segment& line : joining_lines(placement.teams[i], placement.centre_of_mass))
        shapes.push_back({Role::chord, {line.from, line.to}, i});
    }
  }
  add_cargo(shapes, placement);
  shapes.push_back({Role::centre_of_mass, {placement.centre_of_mass}});
  // The first teams matter most and are on top.
  for (std::uint32_t i = teams; i-- > 0;) {
    for (const Robot& robot : placement.teams[i].robots)
      shapes.push_back({Role::robot, {robot.point.position}, i, robot.load});
  }
  return shapes;
}

}  // namespace evenlift
