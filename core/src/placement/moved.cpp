#include "evenlift/moved.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "evenlift/balanced.h"
#include "evenlift/candidates.h"
#include "evenlift/placed_robots.h"
#include "evenlift/settings.h"
#include "evenlift/stands.h"
#include "evenlift/tolerance.h"
#include "evenlift/wording.h"
#include "placement/robot_drift.h"

namespace evenlift {
namespace {

// Moved robots are in a link or a saved result, not in a setting: the error has no place.
InputError refused(const std::string& why) {
  return {ErrorCode::bad_setting, say("robots moved by hand: {why}", {why})};
}

InputError no_such_edge(std::size_t edge) {
  return refused(say("there is no edge {edge}", {edge + 1}));
}

// --- Points of edges

Vec2 position_of(const Polygon& polygon, const EdgePoint& point) {
  // Exact at both ends.
  return (1 - point.part) * polygon.edge_start(point.edge) +
         point.part * polygon.edge_end(point.edge);
}

EdgePoint edge_point(const Polygon& polygon, std::uint32_t edge, const Vec2& at) {
  constexpr double decimals = 1e12;
  const Vec2 &a = polygon.edge_start(edge), &b = polygon.edge_end(edge);
  const double part = std::clamp(dot(at - a, b - a) / dot(b - a, b - a), 0.0, 1.0);
  return {edge, std::round(part * decimals) / decimals + 0.0};
}

// --- Balanced robots

LiftingPoint lifting_point(const Placement& placement, const EdgePoint& contact) {
  const LiftingPoint touched{position_of(placement.polygon(), contact), contact.edge};
  return placement.stands ? placement.stands->lifting_point(touched) : touched;
}

std::optional<InputError> check_balanced(const Placement& placement,
                                         const std::vector<LiftingPoint>& robots) {
  Vec2 sum;
  for (const LiftingPoint& robot : robots) sum += robot.position - placement.centre_of_mass;
  if (length(sum) >
      near_distance(placement.polygon().diameter()) * static_cast<double>(robots.size()))
    return refused("the centroid of the robots is not the centre of mass");
  const Stands* stands = placement.stands.get();
  if (!stands) return std::nullopt;
  for (std::size_t i = 0; i < robots.size(); ++i)
    if (!stands->can_lift(robots[i]))
      return refused(say("robot {robot} has no room there", {i + 1}));
  if (stands->any_collide(robots)) return refused("two robots collide");
  return std::nullopt;
}

std::optional<InputError> move_balanced(Placement& placement,
                                        const std::vector<EdgePoint>& contacts) {
  if (placement.settings.method != Method::balanced || contacts.size() != placement.settings.robots)
    return refused(say("{number} balanced robots were not requested", {contacts.size()}));
  std::vector<LiftingPoint> robots;
  for (const EdgePoint& contact : contacts) {
    if (contact.edge >= placement.vertices().size()) return no_such_edge(contact.edge);
    robots.push_back(lifting_point(placement, contact));
  }
  if (auto error = check_balanced(placement, robots)) return error;
  placement.teams = {share_evenly(robots, placement.centre_of_mass, placement.weight())};
  placement.search_ended = true;
  return std::nullopt;
}

// --- Teams of two

// A chord from edge `a` to `b`, whichever is left.
struct Turned {
  std::uint32_t a = 0, b = 0;
  Chord chord;
  Vec2 on_a, on_b;
};

double closeness(const Vec2& direction, const Vec2& wanted) {
  return dot(direction, wanted) / (length(direction) * length(wanted));
}

// The chord on two edges whose end on `a` is nearest to a direction from C; nullopt if none meets
// the minimum ratio.
std::optional<Turned> towards(const Placement& placement, std::uint32_t a, std::uint32_t b,
                              const Vec2& direction) {
  Chord ends;
  ends.r1.edge = a;
  ends.r2.edge = b;
  const Vec2& centre = placement.centre_of_mass;
  std::optional<Turned> nearest;
  for (const PairRange& range : ranges_of(placement, ends)) {
    const Chord chord = chord_at(centre, range, place_towards(range, direction));
    const bool a_is_left = chord.r1.edge == a;
    const Turned turned{a, b, chord, a_is_left ? chord.r1.position : chord.r2.position,
                        a_is_left ? chord.r2.position : chord.r1.position};
    if (!nearest ||
        closeness(turned.on_a - centre, direction) > closeness(nearest->on_a - centre, direction))
      nearest = turned;
  }
  return nearest;
}

// One edge, or two at a vertex.
struct EdgesAt {
  std::array<std::uint32_t, 2> edges{};
  std::size_t count = 1;
};

EdgesAt edges_at(const Polygon& polygon, std::uint32_t edge, const Vec2& at) {
  const double near = near_distance(polygon.diameter());
  const auto n = static_cast<std::uint32_t>(polygon.vertices().size());
  EdgesAt found{{edge, edge}, 1};
  if (length(at - polygon.edge_start(edge)) <= near)
    found = {{edge, edge == 0 ? n - 1 : edge - 1}, 2};
  else if (length(at - polygon.edge_end(edge)) <= near)
    found = {{edge, static_cast<std::uint32_t>(polygon.next(edge))}, 2};
  return found;
}

// The chord nearest to a direction, on the present edges or, from a vertex, their neighbours;
// nullopt if none is nearer than `now`.
std::optional<Turned> next_chord(const Placement& placement, const Turned& now,
                                 const Vec2& direction) {
  const Vec2& centre = placement.centre_of_mass;
  constexpr double rounding = 1e-12;
  double best = closeness(now.on_a - centre, direction) + rounding;
  std::optional<Turned> next;
  const EdgesAt at_a = edges_at(placement.polygon(), now.a, now.on_a),
                at_b = edges_at(placement.polygon(), now.b, now.on_b);
  for (std::size_t i = 0; i < at_a.count; ++i)
    for (std::size_t k = 0; k < at_b.count; ++k) {
      auto turned = towards(placement, at_a.edges[i], at_b.edges[k], direction);
      const double close = turned ? closeness(turned->on_a - centre, direction) : best;
      if (close <= best) continue;
      best = close;
      next = std::move(turned);
    }
  return next;
}

// The point is on the moved robot's edge.
MovedTeam kept(const Placement& placement, std::size_t team, const Turned& turned) {
  return {static_cast<std::uint32_t>(team), edge_point(placement.polygon(), turned.a, turned.on_a),
          turned.b};
}

std::optional<InputError> move_team(const Placement& placement, const MovedTeam& moved,
                                    std::vector<Chord>& chords) {
  const std::size_t n = placement.vertices().size();
  if (moved.team >= chords.size()) return refused(say("there is no team {team}", {moved.team + 1}));
  for (const std::uint32_t edge : {moved.end.edge, moved.opposite})
    if (edge >= n) return no_such_edge(edge);
  const Vec2 at = lifting_point(placement, moved.end).position;
  const Vec2 direction = at - placement.centre_of_mass;
  std::optional<Turned> turned;
  if (length(direction) > 0 && moved.end.edge != moved.opposite)
    turned = towards(placement, moved.end.edge, moved.opposite, direction);
  if (!turned || length(turned->on_a - at) > near_distance(placement.polygon().diameter()))
    return refused(say("team {team} is outside its range there", {moved.team + 1}));
  chords[moved.team] = turned->chord;
  return std::nullopt;
}

std::optional<InputError> move_teams(Placement& placement, const std::vector<MovedTeam>& teams) {
  if (!can_move_teams(placement))
    return refused("teams can be moved only with the positions range");
  std::vector<Chord> chords;
  for (const Team& team : placement.teams) chords.push_back(chord_of(team));
  for (const MovedTeam& moved : teams)
    if (auto error = move_team(placement, moved, chords)) return error;
  placement.teams = distribute_weight(chords, placement.weight());
  if (placement.stands && placement.stands->any_collide(lifting_points(placement.teams)))
    return refused("two robots collide");
  placement.team_candidates.clear();
  return std::nullopt;
}

}  // namespace

bool can_move_teams(const Placement& placement) {
  return placement.settings.positions == Positions::range &&
         selects_candidates(placement.settings.method) && placement.search_ended;
}

std::optional<Moved> moved_along_outline(const Placement& placement, std::size_t robot,
                                         const LiftingPoint& to) {
  if (placement.settings.method != Method::balanced || placement.teams.empty()) return std::nullopt;
  const BalancedProblem problem(placement.object, placement.centre_of_mass, placement.settings);
  const auto robots = move_robot(problem, lifting_points(placement.teams), robot, to);
  if (!robots) return std::nullopt;
  Moved moved;
  for (const LiftingPoint& each : *robots)
    moved.robots.push_back(
        edge_point(placement.polygon(), each.edge,
                   placement.stands ? placement.stands->contact(each) : each.position));
  return moved;
}

std::optional<Moved> moved_along_range(const Placement& placement, std::size_t robot,
                                       const Vec2& to) {
  const Vec2 direction = to - placement.centre_of_mass;
  if (!can_move_teams(placement) || robot >= count_robots(placement.teams) ||
      !(length(direction) > 0))
    return std::nullopt;
  const auto [number, end] = find_robot(placement.teams, robot);
  const LiftingPoint &own = placement.teams[number].robots[end].point,
                     &other = placement.teams[number].robots[1 - end].point;
  Turned now{own.edge, other.edge, chord_of(placement.teams[number]), own.position, other.position};
  bool moved = false;
  // Passes each edge at most once, since the chord only comes nearer to the direction.
  for (std::size_t steps = 0; steps <= 2 * placement.vertices().size(); ++steps) {
    auto next = next_chord(placement, now, direction);
    if (!next) break;
    now = *std::move(next);
    moved = true;
  }
  if (!moved) return std::nullopt;
  Moved all = placement.moved;
  std::vector<MovedTeam>& teams = all.teams;
  const MovedTeam team = kept(placement, number, now);
  std::size_t at = 0;
  while (at < teams.size() && teams[at].team != team.team) ++at;
  if (at == teams.size()) teams.push_back(team);
  teams[at] = team;
  for (; at > 0 && team.team < teams[at - 1].team; --at) std::swap(teams[at], teams[at - 1]);
  if (teams.size() > most_moved_teams) return std::nullopt;
  return all;
}

std::optional<InputError> move_robots(Placement& placement, const Moved& moved) {
  if (!is_moved(moved)) return refused("a robot does not stand on an edge");
  auto error = moved.robots.empty() ? move_teams(placement, moved.teams)
                                    : move_balanced(placement, moved.robots);
  if (error) return error;
  placement.moved = moved;
  describe_grasp(placement);
  return std::nullopt;
}

Result<Placement> with_moved(Placement placement, const Moved& moved) {
  if (auto error = move_robots(placement, moved)) return *std::move(error);
  return placement;
}

}  // namespace evenlift
