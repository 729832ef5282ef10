#include "evenlift/stability.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "evenlift/loads.h"
#include "evenlift/tolerance.h"
#include "polygon/corners.h"

namespace evenlift {

Chord chord_of(const Team& team) {
  const Robot &r1 = team.robots[0], &r2 = team.robots[1];
  return {r1.point, r2.point, r1.arm, r2.arm, team.ratio};
}

std::size_t count_robots(const std::vector<Team>& teams) {
  return teams.empty() ? 0 : teams.size() * teams.front().robots.size();
}

RobotOfTeam find_robot(const std::vector<Team>& teams, std::size_t number) {
  const std::size_t size = teams.front().robots.size();
  return {number / size, number % size};
}

std::vector<LiftingPoint> lifting_points(const std::vector<Team>& teams) {
  std::vector<LiftingPoint> points;
  points.reserve(count_robots(teams));
  for (const Team& team : teams)
    for (const Robot& robot : team.robots) points.push_back(robot.point);
  return points;
}

std::vector<double> planned_loads(const std::vector<Team>& teams) {
  std::vector<double> loads;
  loads.reserve(count_robots(teams));
  for (const Team& team : teams)
    for (const Robot& robot : team.robots) loads.push_back(robot.load);
  return loads;
}

std::vector<Team> distribute_weight(const std::vector<Chord>& chords, double weight) {
  std::vector<Team> teams;
  teams.reserve(chords.size());
  const double share = weight / static_cast<double>(chords.size());
  for (const Chord& chord : chords) {
    const double whole = chord.arm1 + chord.arm2;
    teams.push_back({{{chord.r1, chord.arm1, share * (chord.arm2 / whole)},
                      {chord.r2, chord.arm2, share * (chord.arm1 / whole)}},
                     chord.ratio});
  }
  return teams;
}

Team share_evenly(const std::vector<LiftingPoint>& robots, const Vec2& centre, double weight) {
  Team team;
  const double load = weight / static_cast<double>(robots.size());
  for (const LiftingPoint& robot : robots)
    team.robots.push_back({robot, length(robot.position - centre), load});
  return team;
}

std::optional<LoadSummary> summarize_loads(const std::vector<Team>& teams) {
  if (teams.empty()) return std::nullopt;
  LoadSummary summary;
  summary.min = summary.max = teams.front().robots.front().load;
  double sum = 0;
  for (const Team& team : teams) {
    double low = team.robots.front().load, high = low, of_team = 0;
    for (const Robot& robot : team.robots) {
      low = std::min(low, robot.load);
      high = std::max(high, robot.load);
      of_team += robot.load;
    }
    summary.min = std::min(summary.min, low);
    summary.max = std::max(summary.max, high);
    summary.max_share = std::max(summary.max_share, high / of_team);
    sum += of_team;
  }
  summary.mean = sum / static_cast<double>(count_robots(teams));
  summary.spread = summary.max - summary.min;
  return summary;
}

namespace {

// The tipping force at q, which is on the line of a segment H beyond its end r.
double force_beyond_end(const Vec2& r, const Vec2& centre, double weight, const Vec2& q) {
  return weight * length(r - centre) / length(q - r);
}

double segment_tipping_force(const Points& hull, const Vec2& centre, double weight, const Vec2& q) {
  const Vec2 &a = hull[0], &b = hull[1];
  const Vec2 line = b - a;
  if (std::fabs(cross(line, q - a)) > tau * dot(line, line)) return 0;
  const double along = dot(q - a, line) / dot(line, line);
  if (along < 0) return force_beyond_end(a, centre, weight, q);
  if (along > 1) return force_beyond_end(b, centre, weight, q);
  return std::numeric_limits<double>::infinity();
}

// Coordinates are relative to a corner of H, so that an object far from the origin loses no digits.
Points relative_to(const Vec2& origin, const PolygonWithHoles& object) {
  Points ring;
  ring.reserve(object.boundary().size());
  for (const Vec2& v : object.boundary()) ring.push_back(v - origin);
  return ring;
}

// The part of a ring, relative to `origin`, within a hull in absolute coordinates.
Points part_within(Points ring, const Points& hull, const Vec2& origin) {
  for (std::size_t i = 0; i < hull.size(); ++i) {
    // The direction comes from the original corners. If two of them differ only by rounding,
    // translation would change it.
    ring = clip_left_of_ray(ring, hull[i] - origin, hull[(i + 1) % hull.size()] - hull[i]);
  }
  return ring;
}

double share_of(double area, double part) { return std::clamp(std::fabs(part) / area, 0.0, 1.0); }

// Clipping takes n h steps.
bool is_slow_to_clip(const Points& ring, const Points& hull) {
  constexpr std::size_t many = std::size_t{1} << 18;
  return ring.size() * hull.size() > many;
}

// The area of the part of a ring, relative to `origin`, within a hull in absolute coordinates.
double area_within(const Points& ring, const Points& hull, const Vec2& origin) {
  if (!is_slow_to_clip(ring, hull)) return signed_area(part_within(ring, hull, origin));
  Points relative;
  for (const Vec2& corner : hull) relative.push_back(corner - origin);
  return doubled_area_in_hull(ring, relative) / 2;
}

}  // namespace

Points lifting_base(const Polygon& polygon, const std::vector<LiftingPoint>& points) {
  return convex_hull(positions(points), near_distance(polygon.diameter()));
}

double coverage(const PolygonWithHoles& object, const Points& hull) {
  if (hull.size() < 3) return 0;
  const Vec2& origin = hull.front();
  return share_of(object.area(), area_within(relative_to(origin, object), hull, origin));
}

CoverageWithin::CoverageWithin(const PolygonWithHoles& object, const Points& outer)
    : origin_(outer.front()), part_(relative_to(origin_, object)), area_(object.area()) {
  if (!is_slow_to_clip(part_, outer)) part_ = part_within(std::move(part_), outer, origin_);
}

double CoverageWithin::of(const Points& hull) const {
  return hull.size() < 3 ? 0 : share_of(area_, area_within(part_, hull, origin_));
}

double tipping_force(const Points& hull, const Vec2& centre, double weight, const Vec2& q,
                     double reach) {
  if (hull.size() < 2) return 0;
  if (hull.size() == 2) return reach > 0 ? 0 : segment_tipping_force(hull, centre, weight, q);
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Vec2 &a = hull[i], &b = hull[(i + 1) % hull.size()];
    const double beyond = cross(b - a, q - a);
    const double room = cross(b - a, centre - a) - reach * length(b - a);
    if (reach > 0 && room < 0) return 0;
    if (beyond >= 0) continue;
    least = std::min(least, weight * (room / -beyond));
  }
  return least;
}

}  // namespace evenlift
