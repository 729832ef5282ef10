#include "tools/pick.h"

#include <algorithm>

#include "evenlift/centre_of_mass.h"
#include "evenlift/moved.h"
#include "evenlift/output/picture.h"
#include "evenlift/plane.h"
#include "evenlift/wording.h"

namespace evenlift::view {

std::size_t count_vertices(const Document& document) {
  return first_of_ring(document, document.holes.size() + 1);
}

std::size_t count_handles(const Document& document) {
  return count_vertices(document) + document.settings.cargo.size();
}

std::size_t weight_handle(const Document& document, std::size_t item) {
  return count_vertices(document) + item;
}

std::optional<Handle> handle_of(const Document& document, std::size_t number) {
  std::size_t rest = number;
  for (std::size_t ring = 0; ring <= document.holes.size(); ++ring) {
    const std::size_t size = ring_of(document, ring).size();
    if (rest < size) return Handle{false, ring, rest};
    rest -= size;
  }
  if (rest < document.settings.cargo.size()) return Handle{true, 0, rest};
  return std::nullopt;
}

const Points& ring_of(const Document& document, std::size_t ring) {
  return ring == 0 ? document.vertices : document.holes[ring - 1];
}

Points& ring_of(Document& document, std::size_t ring) {
  return ring == 0 ? document.vertices : document.holes[ring - 1];
}

std::size_t first_of_ring(const Document& document, std::size_t ring) {
  std::size_t first = 0;
  for (std::size_t i = 0; i < ring; ++i) first += ring_of(document, i).size();
  return first;
}

Vec2 place_of(const Document& document, std::size_t number) {
  const Handle handle = *handle_of(document, number);
  return handle.is_weight ? document.settings.cargo[handle.index].at
                          : ring_of(document, handle.ring)[handle.index];
}

void put(Document& document, std::size_t number, const Vec2& at) {
  const Handle handle = *handle_of(document, number);
  Vec2& place = handle.is_weight ? document.settings.cargo[handle.index].at
                                 : ring_of(document, handle.ring)[handle.index];
  place = at;
}

Vec2 before(const Document& document, std::size_t vertex) {
  const Handle handle = *handle_of(document, vertex);
  const Points& ring = ring_of(document, handle.ring);
  return ring[handle.index == 0 ? ring.size() - 1 : handle.index - 1];
}

Vec2 after(const Document& document, std::size_t vertex) {
  const Handle handle = *handle_of(document, vertex);
  const Points& ring = ring_of(document, handle.ring);
  return ring[handle.index + 1 == ring.size() ? 0 : handle.index + 1];
}

std::string name_of(const Document& document, std::size_t number) {
  const std::optional<Handle> handle = handle_of(document, number);
  if (!handle) return {};
  if (!handle->is_weight && handle->ring == 0) return say("Vertex {vertex}", {handle->index + 1});
  if (!handle->is_weight)
    return say("Hole {hole}, vertex {vertex}", {handle->ring, handle->index + 1});
  const std::string& name = document.settings.cargo[handle->index].name;
  return say("Weight {weight}", {handle->index + 1}) + (name.empty() ? "" : ", " + name);
}

PolygonGrip grip_of(const Document& document) {
  return {document.vertices, document.centre_of_mass, document.holes, document.settings.cargo,
          document.settings.supports};
}

namespace {

double distance(const Vec2& a, const Vec2& b) { return length(a - b); }

// In a tie, the later part.
struct Nearest {
  double reach;
  Pick pick = {};
  void offer(double away, const Pick& candidate) {
    if (away <= reach) {
      reach = away;
      pick = candidate;
    }
  }
};

void offer_weights(const AppState& state, const Vec2& screen, Nearest& nearest) {
  const std::vector<Cargo>& cargo = state.work.document().settings.cargo;
  for (std::size_t i = 0; i < cargo.size(); ++i)
    nearest.offer(distance(state.view.camera.to_screen(cargo[i].at), screen),
                  {Pick::Kind::cargo, i, 0, cargo[i].at});
}

Pick part_at(const AppState& state, const Vec2& screen) {
  Nearest nearest{state.session.screen.touch ? 24.0 : 12.0};
  for_each_ring(state.work.document(), [&](const Points& ring, std::size_t first) {
    for (std::size_t i = 0; i < ring.size(); ++i)
      nearest.offer(distance(state.view.camera.to_screen(ring[i]), screen),
                    {Pick::Kind::vertex, first + i, 0, ring[i]});
  });
  offer_weights(state, screen, nearest);
  if (const std::optional<Vec2> grip = uncertainty_grip(state))
    nearest.offer(distance(*grip, screen),
                  {Pick::Kind::uncertainty, 0, 0, state.view.camera.to_world(*grip)});
  const Vec2 centre = own_centre(state);
  nearest.offer(distance(state.view.camera.to_screen(centre), screen),
                {Pick::Kind::centre, 0, 0, centre});
  return nearest.pick;
}

Pick robot_at(const AppState& state, const Placement& placement, const Vec2& screen) {
  Nearest nearest{14};
  const std::vector<Team>& teams = placement.teams;
  for (std::size_t i = 0; i < teams.size(); ++i) {
    const std::vector<Robot>& robots = teams[i].robots;
    for (std::size_t k = 0; k < robots.size(); ++k) {
      const Vec2& at = robots[k].point.position;
      nearest.offer(distance(state.view.camera.to_screen(at), screen),
                    {Pick::Kind::robot, i, static_cast<int>(k), at});
    }
  }
  return nearest.pick;
}

}  // namespace

Pick left_out_at(const AppState& state, const Vec2& screen) {
  Nearest nearest{14};
  const Placement* placement = current_placement(state, false);
  if (!placement || walkthrough_is_open(state)) return nearest.pick;
  for (const Misplaced& each : placement->left_out) {
    if (each.kind != Misplaced::Kind::support) continue;
    const Vec2& at = placement->settings.supports[each.index];
    nearest.offer(distance(state.view.camera.to_screen(at), screen),
                  {Pick::Kind::left_out, each.index, 0, at});
  }
  return nearest.pick;
}

namespace {

Pick edge_at(const AppState& state, const Vec2& screen) {
  Nearest nearest{state.session.screen.touch ? 16.0 : 8.0};
  const Vec2 world = state.view.camera.to_world(screen);
  for_each_ring(state.work.document(), [&](const Points& ring, std::size_t first) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vec2 at = nearest_on_segment(ring[i], ring[i + 1 == ring.size() ? 0 : i + 1], world);
      nearest.offer(distance(state.view.camera.to_screen(at), screen),
                    {Pick::Kind::edge, first + i, 0, at});
    }
  });
  return nearest.pick;
}

Pick chord_at(const AppState& state, const Placement& placement, const Vec2& screen) {
  if (is_one_team(placement.settings.method)) return {};  // these robots have no chords
  Nearest nearest{6};
  const std::vector<Team>& teams = placement.teams;
  const Vec2 world = state.view.camera.to_world(screen);
  for (std::size_t i = 0; i < teams.size(); ++i) {
    for (const Segment& line : joining_lines(teams[i], placement.centre_of_mass)) {
      const Vec2 at = nearest_on_segment(line.from, line.to, world);
      nearest.offer(distance(state.view.camera.to_screen(at), screen),
                    {Pick::Kind::chord, i, 0, at});
    }
  }
  return nearest.pick;
}

Pick candidate_at(const AppState& state, const Placement& placement, const Vec2& screen) {
  if (!shown(state).overlays.candidates || is_one_team(placement.settings.method)) return {};
  Nearest nearest{state.session.screen.touch ? 12.0 : 6.0};
  const Vec2 world = state.view.camera.to_world(screen);
  for (std::size_t i = 0; i < placement.candidates.size(); ++i) {
    const Chord& chord = placement.candidates[i].chord;
    const Vec2 at = nearest_on_segment(chord.r1.position, chord.r2.position, world);
    nearest.offer(distance(state.view.camera.to_screen(at), screen),
                  {Pick::Kind::candidate, i, 0, at});
  }
  return nearest.pick;
}

// Whether its card is open.
bool is_asked_about(const AppState& state, const Pick& pick) {
  if (pick.kind != Pick::Kind::robot || !state.derived().explanation ||
      state.derived().explanation->of.second)
    return false;
  const std::size_t in_team = shown_placement(state).teams.front().robots.size();
  return state.derived().explanation->robot ==
         pick.index * in_team + static_cast<std::size_t>(pick.end);
}

// Pixels between the ring and its grip.
double grip_stands_off(const AppState& state) { return state.session.screen.finger ? 40 : 28; }

}  // namespace

std::optional<Vec2> uncertainty_grip(const AppState& state) {
  const bool there = shown(state).overlays.halo && !state.session.screen.embed &&
                     state.view.tool == Tool::parts && !state.derived().refusal &&
                     !walkthrough_is_open(state);
  if (!there || !state.derived().placement || state.derived().placement->teams.empty())
    return std::nullopt;
  const Vec2 up_and_right(0.70710678, -0.70710678);
  return Vec2(state.view.camera.to_screen(centre_of_mass(state)) +
              up_and_right * (effect_on({*state.derived().placement, shown(state)}).reach *
                                  state.view.camera.scale +
                              grip_stands_off(state)));
}

double uncertainty_for_grip(const AppState& state, const Vec2& screen) {
  const double away = distance(state.view.camera.to_screen(centre_of_mass(state)), screen);
  const double besides = effect_on({*state.derived().placement, shown(state)}).reach -
                         shown(state).com_radius,
               radius = (away - grip_stands_off(state)) / state.view.camera.scale - besides;
  return std::max(0.0, rounded_to_pixels(state.view.camera, Vec2(radius, 0)).x);
}

Pick marked_part(const AppState& state) {
  const Pick::Kind over = state.view.hover.kind;
  const bool part =
      over == Pick::Kind::robot || over == Pick::Kind::chord || over == Pick::Kind::candidate;
  return part || !state.derived().explanation ? state.view.hover : state.derived().explanation->of;
}

std::optional<Chord> chord_of_part(const Placement& placement, const Pick& part) {
  if (part.kind == Pick::Kind::candidate && part.index < placement.candidates.size())
    return placement.candidates[part.index].chord;
  const bool of_team = part.kind == Pick::Kind::robot || part.kind == Pick::Kind::chord;
  if (of_team && part.index < placement.teams.size()) return chord_of(placement.teams[part.index]);
  return std::nullopt;
}

Vec2 own_centre(const AppState& state) {
  if (state.work.document().centre_of_mass) return *state.work.document().centre_of_mass;
  if (state.derived().placement) return state.derived().placement->own_centre;
  return state.work.document().vertices.empty() ? Vec2(0, 0) : state.work.document().vertices[0];
}

Vec2 centre_of_mass(const AppState& state) {
  return with_cargo(own_centre(state), settings(state));
}

std::optional<Vec2> own_centroid(const AppState& state) {
  if (!state.derived().placement || state.derived().refusal) return std::nullopt;
  return state.derived().placement->object.centroid();
}

Pick weight_at(const AppState& state, const Vec2& screen) {
  Nearest nearest{state.session.screen.touch ? 24.0 : 14.0};
  offer_weights(state, screen, nearest);
  return nearest.pick;
}

const Placement* current_placement(const AppState& state, bool second) {
  const std::optional<Placement>& placement =
      second ? state.derived().second : state.derived().placement;
  return placement && !state.derived().refusal ? &shown_placement(state, second) : nullptr;
}

Pick object_at(const AppState& state, const Vec2& screen, bool second) {
  const Placement* placement = current_placement(state, second);
  const Vec2 world = state.view.camera.to_world(screen);
  if (!placement || !inside(placement->vertices(), world) || placement->object.hole_around(world))
    return {};
  return {Pick::Kind::object, 0, 0, world, second};
}

Pick pick(const AppState& state, const Vec2& screen, bool second) {
  Pick found = part_at(state, screen);
  const Placement* placement = current_placement(state, second);
  if (placement) {
    const Pick robot = robot_at(state, *placement, screen);
    const auto away = [&](const Pick& p) {
      return distance(state.view.camera.to_screen(p.at), screen);
    };
    // On a vertex, a robot that was placed by hand or whose card is open comes first, so that it
    // can be grabbed.
    const bool first =
        !second && can_take_robot(state, robot) &&
        (placement->settings.method == Method::given || is_asked_about(state, robot));
    if (robot.kind != Pick::Kind::none &&
        (found.kind == Pick::Kind::none || first || away(robot) < away(found)))
      found = robot;
  }
  if (!second)
    if (const Pick outside = left_out_at(state, screen); outside.kind != Pick::Kind::none)
      found = outside;
  if (found.kind == Pick::Kind::none) found = edge_at(state, screen);
  if (found.kind == Pick::Kind::none && placement) found = chord_at(state, *placement, screen);
  if (found.kind == Pick::Kind::none && placement) found = candidate_at(state, *placement, screen);
  if (found.kind == Pick::Kind::none) found = object_at(state, screen, second);
  found.second = second;
  return found;
}

bool can_take_robot(const AppState& state, const Pick& pick) {
  if (pick.kind != Pick::Kind::robot || pick.second) return false;
  if (walkthrough_is_open(state) || failing(state)) return false;  // other robots are shown
  return current_placement(state, false) != nullptr;
}

Pick pick_to_hold(const AppState& state, const Vec2& screen, bool second) {
  const Pick nearest = pick(state, screen, second);
  if (can_take_robot(state, nearest) || nearest.kind == Pick::Kind::left_out) return nearest;
  Pick found = part_at(state, screen);
  found.second = second;
  return found.kind == Pick::Kind::none ? nearest : found;
}

Pick pick_explained(const AppState& state, const Vec2& screen, bool second) {
  const Placement* placement = current_placement(state, second);
  if (!placement) return {};
  Pick found = robot_at(state, *placement, screen);
  if (found.kind == Pick::Kind::none) found = chord_at(state, *placement, screen);
  if (found.kind == Pick::Kind::none) found = candidate_at(state, *placement, screen);
  found.second = second;
  return found;
}

bool is_hovered(const AppState& state, Pick::Kind kind, std::size_t index) {
  if (draws(state.view.tool)) return false;  // the pointer is over vertices of the drawing
  const Pick& held = state.view.held;
  if (held.kind != Pick::Kind::none && held.kind != Pick::Kind::ground)
    return held.kind == kind && held.index == index;
  return state.view.hover.kind == kind && state.view.hover.index == index;
}

}  // namespace evenlift::view
