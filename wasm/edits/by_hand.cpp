#include "edits/vertices.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "edits/undo.h"
#include "evenlift/moved.h"
#include "evenlift/output/words.h"
#include "evenlift/plane.h"
#include "evenlift/stands.h"
#include "evenlift/supports.h"
#include "evenlift/weighing.h"
#include "evenlift/wording.h"
#include "state/method.h"
#include "state/screen.h"
#include "tools/drawing.h"

namespace evenlift::view {
namespace {

bool has_robots(const AppState& state) {
  return !state.derived().refusal && state.derived().placement;
}

// "Back to Area".
std::string way_back(Method method) {
  std::string name = method_in_words(method);
  if (name[0] >= 'a' && name[0] <= 'z') name[0] = static_cast<char>(name[0] - 'a' + 'A');
  return say("Back to {method}", {name});
}

// Returns the document, with the method `given`.
Document& edit_supports(AppState& state, bool live) {
  const Placement& placement = *state.derived().placement;
  const Method before = settings(state).method;
  Settings own = taken_over(settings(state), placement);
  const bool goes_on = live && state.work.edit_open;  // then the notice of its beginning stays
  Document& document = goes_on ? state.work.edit() : edit(state, live, Edit::robots_moved);
  state.given = {};
  document.settings = std::move(own);
  if (before == Method::given) return document;
  state.work.aside.method = before;
  document.settings.support_names.clear();
  state.work.show().support_capacities.clear();
  show(state, {Notice::Kind::info, "The robots now stand where you put them.", way_back(before)});
  return document;
}

template <class Value>
void remove_at(std::vector<Value>& values, std::size_t i) {
  if (i < values.size()) values.erase(values.begin() + static_cast<std::ptrdiff_t>(i));
  if (std::all_of(values.begin(), values.end(),
                  [](const Value& value) { return value == Value(); }))
    values.clear();
}

// A support with its name and capacity.
void remove_from(Document& document, std::size_t support) {
  Points& supports = document.settings.supports;
  supports.erase(supports.begin() + static_cast<std::ptrdiff_t>(support));
  remove_at(document.settings.support_names, support);
  remove_at(document.shown.support_capacities, support);
}

// Places the document here and notes the moved robot, so that its card stays open.
void hand_over(AppState& state, std::optional<std::size_t> robot) {
  Result<Placement> placed = compute_placement(state.work.document(), state.derived().placement);
  if (!placed) return;
  const bool all_stand = placed->left_out == state.derived().placement->left_out;
  state.given.placement = std::move(placed).value();
  if (robot && all_stand) state.given.moved = {*robot, *robot};
}

}  // namespace

Settings taken_over(Settings settings, const Placement& placement) {
  if (settings.method == Method::given) return settings;
  const auto teams = static_cast<std::uint32_t>(placement.teams.size());
  settings = with_method(std::move(settings), Method::given, std::max(teams, 1u));
  settings.supports = positions(contact_points(placement));
  // Without robots, one at each of three hull corners.
  const Points& hull = placement.polygon().hull();
  for (std::size_t i = 0; settings.supports.empty() || (placement.teams.empty() && i < 3); ++i)
    settings.supports.push_back(hull[i]);
  if (settings.supports.size() > most_supports) settings.supports.resize(most_supports);
  return settings;
}

bool stands_freely(const Placement& placement) {
  if (placement.settings.method == Method::given) return true;
  return !can_move_teams(placement) &&
         !(placement.settings.method == Method::balanced && count_robots(placement.teams) >= 3);
}

namespace {

// A point of an edge: its ring (0 is the outline), the edge's number, and the part of the edge.
struct OnEdge {
  std::size_t ring, edge;
  double part;
};

const Vec2& next_in(const Points& ring, std::size_t i) {
  return ring[i + 1 == ring.size() ? 0 : i + 1];
}

std::optional<OnEdge> nearest_edge(const std::vector<const Points*>& rings, const Vec2& point,
                                   double within) {
  std::optional<OnEdge> nearest;
  for (std::size_t r = 0; r < rings.size(); ++r)
    for (std::size_t i = 0; i < rings[r]->size(); ++i) {
      const Vec2 &a = (*rings[r])[i], &b = next_in(*rings[r], i);
      const Vec2 at = nearest_on_segment(a, b, point);
      if (length(at - point) > within) continue;
      within = length(at - point);
      const double whole = length(b - a);
      nearest = OnEdge{r, i, whole > 0 ? length(at - a) / whole : 0};
    }
  return nearest;
}

std::vector<const Points*> rings_of(const Points& outline, const std::vector<Points>& holes) {
  std::vector<const Points*> rings = {&outline};
  for (const Points& hole : holes) rings.push_back(&hole);
  return rings;
}

Vec2 point_of(const Points& ring, std::size_t edge, double part) {
  return ring[edge] + part * (next_in(ring, edge) - ring[edge]);
}

}  // namespace

void carry_supports(Document& document, const PolygonGrip& before) {
  Points& supports = document.settings.supports;
  if (document.settings.method != Method::given || supports.size() != before.supports.size())
    return;
  const auto rings = rings_of(before.vertices, before.holes),
             now = rings_of(document.vertices, document.holes);
  const double within =
      document.settings.snap.value_or(usual_snap * length(bounding_box(before.vertices).size()));
  for (std::size_t i = 0; i < supports.size(); ++i) {
    supports[i] = before.supports[i];
    const auto on = nearest_edge(rings, supports[i], within);
    if (!on || rings[on->ring]->size() != now[on->ring]->size()) continue;
    const Points &ring = *rings[on->ring], &edited = *now[on->ring];
    const bool has_moved =
        ring[on->edge] != edited[on->edge] || next_in(ring, on->edge) != next_in(edited, on->edge);
    if (has_moved) supports[i] = point_of(edited, on->edge, on->part);
  }
}

namespace {

// The placed robot at this support; nothing if the support is left out.
std::optional<std::size_t> robot_at_support(const Placement& placement, std::size_t support) {
  for (std::size_t i = 0; i < count_robots(placement.teams); ++i)
    if (placement.support_of(i) == support) return i;
  return std::nullopt;
}

// The pointer goes on holding the support, whether or not it now is outside the object.
void hold_support(AppState& state, std::size_t support) {
  Pick& held = state.view.held;
  if (held.kind != Pick::Kind::robot && held.kind != Pick::Kind::left_out) return;
  const Placement& placement =
      state.given.placement ? *state.given.placement : *state.derived().placement;
  const auto robot = robot_at_support(placement, support);
  held.kind = robot ? Pick::Kind::robot : Pick::Kind::left_out;
  held.index = robot ? 0 : support;
  held.end = static_cast<int>(robot.value_or(0));
}

}  // namespace

void move_support(AppState& state, std::size_t support, const Vec2& to) {
  if (!has_robots(state) || support >= supports_now(state).size()) return;
  const Placement& placement = *state.derived().placement;
  const auto robot = robot_at_support(placement, support);
  const auto spot = support_spot(state, to, robot);
  // In a challenge, and while readings count, all robots stay: one dragged out waits where it last
  // could stand. So does the only one.
  const bool all_stay = (state.view.challenge && !state.view.task) ||
                        evenlift::is_weighed(settings(state)) || count_robots(placement.teams) == 1;
  if (!spot && robot && all_stay) return;
  Document& document = edit_supports(state, true);
  document.settings.supports[support] = spot.value_or(to);
  if (!spot && robot) state.view.dragged_out = support;
  if (spot) state.view.dragged_out.reset();
  hand_over(state, robot);
  hold_support(state, support);
}

void take_away_dragged_out(AppState& state) {
  const auto support = std::exchange(state.view.dragged_out, std::nullopt);
  if (!support || !state.work.edit_open) return;
  Document& document = state.work.edit();
  if (*support >= document.settings.supports.size()) return;
  const std::string called = support_called(document.settings, *support);
  remove_from(document, *support);
  show(state,
       {Notice::Kind::info, say("Robot {robot} is taken away.", {called}), say("Bring it back")});
}

void place_yourself(AppState& state, std::size_t robots) {
  if (!has_robots(state)) return;
  const Placement& placement = *state.derived().placement;
  if (settings(state).method != Method::given) state.work.aside.method = settings(state).method;
  Settings own = with_method(settings(state), Method::given, 1);
  own.supports = supports_to_place(placement.object, placement.centre_of_mass, robots, own);
  own.support_names.clear();
  edit(state, false, Edit::robots_moved).settings = std::move(own);
  state.work.show().support_capacities.clear();
  if (!state.view.challenge)  // its card says it
    show(state,
         {Notice::Kind::hint,
          say("Drag the robots until all carry nearly the same and the object does not tip.")});
}

Points supports_now(const AppState& state) {
  if (!has_robots(state)) return {};
  if (settings(state).method != Method::given && state.derived().placement->teams.empty())
    return {};
  return taken_over(settings(state), *state.derived().placement).supports;
}

void put_support(AppState& state, std::size_t robot, const Vec2& at) {
  if (robot >= supports_now(state).size()) return;
  const Placement& placement = *state.derived().placement;
  if (!SupportPlacer(placement.object, placement.settings).place(at)) return;
  edit_supports(state, false).settings.supports[robot] = at;
}

void name_support(AppState& state, std::size_t robot, const std::string& name) {
  if (robot >= supports_now(state).size()) return;
  Document& document = edit_supports(state, false);
  std::vector<std::string>& names = document.settings.support_names;
  names.resize(document.settings.supports.size());
  names[robot] = name;
  if (std::all_of(names.begin(), names.end(), [](const auto& each) { return each.empty(); }))
    names.clear();
}

void add_support(AppState& state, std::optional<Vec2> at) {
  if (!has_robots(state)) return;
  const Placement& placement = *state.derived().placement;
  if (supports_now(state).size() >= most_supports) return;
  if (at)
    at = support_spot(state, *at, std::nullopt);
  else
    at = widest_addition(placement.polygon(), positions(lifting_points(placement.teams)));
  if (!at) return;
  Document& document = edit_supports(state, false);
  document.settings.supports.push_back(*at);
  if (auto& names = document.settings.support_names; !names.empty()) names.emplace_back();
  if (auto& capacities = document.shown.support_capacities; !capacities.empty())
    capacities.emplace_back();
}

void remove_support(AppState& state, std::optional<std::size_t> robot) {
  if (!has_robots(state)) return;
  const std::size_t number = supports_now(state).size();
  if (number < 2) return;
  const std::size_t gone = robot.value_or(number - 1);
  if (gone >= number) return;
  Document& document = edit_supports(state, false);
  if (gone < document.settings.supports.size()) remove_from(document, gone);
}

void even_out_supports(AppState& state) {
  if (!has_robots(state) || settings(state).method != Method::given) return;
  const auto even = with_even_supports(state.work.document(), Misfitting::left_out);
  if (!even) return show(state, {Notice::Kind::problem, sentence(even.error()) + "."});
  Points supports = even->settings.supports;
  edit(state, false, Edit::robots_moved).settings.supports = std::move(supports);
}

namespace {

LiftingPoint nearest_on_outline(const Points& vertices, const Vec2& to) {
  LiftingPoint nearest{vertices[0], 0};
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const Vec2 at =
        nearest_on_segment(vertices[i], vertices[i + 1 == vertices.size() ? 0 : i + 1], to);
    if (length(at - to) < length(nearest.position - to))
      nearest = {at, static_cast<std::uint32_t>(i)};
  }
  return nearest;
}

// A team's left end has the lower number, so the held robot's may change.
void follow_grip(AppState& state, const Placement& placement, std::size_t now) {
  const auto [team, robot] = find_robot(placement.teams, now);
  if (state.view.held.kind == Pick::Kind::robot && state.view.held.index == team)
    state.view.held.end = static_cast<int>(robot);
}

// The number of the team's robot on the edge of `team.end`.
std::size_t number_of(const Placement& placement, const MovedTeam& team) {
  const std::vector<Robot>& robots = placement.teams[team.team].robots;
  return team.team * robots.size() + (robots[0].point.edge == team.end.edge ? 0 : 1);
}

const MovedTeam* find_team(const Moved& moved, std::size_t team) {
  for (const MovedTeam& each : moved.teams)
    if (each.team == team) return &each;
  return nullptr;
}

// Notes that the held robot cannot go there; for keys, shows a notice. O(n).
void refuse_by_hand(AppState& state, std::size_t robot, const Vec2& to) {
  if (state.view.held.kind == Pick::Kind::robot)
    state.view.closed_to = nearest_on_outline(state.derived().placement->vertices(), to);
  else
    show(state, {Notice::Kind::info, closed_in_words(*state.derived().placement, robot)});
}

// The robots after a move by move_robot(); nothing if they stay. O(n log n).
std::optional<Moved> moved_by_hand(AppState& state, std::size_t robot, const Vec2& to) {
  state.view.closed_to.reset();
  if (state.derived().refusal || !state.derived().placement ||
      state.derived().placement->teams.empty())
    return std::nullopt;
  const Placement& placement = *state.derived().placement;
  if (can_move_teams(placement)) return moved_along_range(placement, robot, to);
  if (placement.settings.method != Method::balanced) return std::nullopt;
  auto moved = moved_along_outline(placement, robot, nearest_on_outline(placement.vertices(), to));
  if (!moved) refuse_by_hand(state, robot, to);
  return moved;
}

std::size_t number_after(const Placement& placement, std::size_t robot) {
  const MovedTeam* moved = find_team(placement.moved, find_robot(placement.teams, robot).team);
  return moved ? number_of(placement, *moved) : robot;
}

}  // namespace

void move_robot(AppState& state, std::size_t robot, const Vec2& to) {
  const std::optional<Moved> moved = moved_by_hand(state, robot, to);
  if (!moved || *moved == state.work.document().moved) return;
  Result<Placement> placement = with_moved(*state.derived().placement, *moved);
  if (!placement) return refuse_by_hand(state, robot, to);  // two robots would meet
  begin_edit(state, true, Edit::robots_moved);
  state.work.edit().moved = placement->moved;
  const std::size_t now = number_after(*placement, robot);
  if (now != robot) follow_grip(state, *placement, now);
  state.given = {};
  state.given.placement = std::move(placement).value();
  state.given.moved = {robot, now};
}

void put_robots_back(AppState& state) {
  if (state.work.document().moved.any()) edit(state, false, Edit::robots_reset);
}

void put_teams_back(AppState& state) {
  if (!state.work.document().moved.teams.empty()) put_robots_back(state);
}

}  // namespace evenlift::view
