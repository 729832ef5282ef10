#include "canvas/canvas.h"

#include <algorithm>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "evenlift/output/trace_words.h"
#include "evenlift/output/words.h"
#include "evenlift/plane.h"
#include "evenlift/wording.h"
#include "marks/marks.h"
#include "tools/drawing.h"
#include "tools/pick.h"
#include "ui/theme.h"

namespace evenlift::view {
namespace {

constexpr double ring = 15;  // pixels around a vertex of a step
constexpr double line = 5;   // beside an edge
constexpr double centre = 13;

// `from` is on the boundary. Returns `away` on the screen, or its opposite if `away` leads inside.
Vec2 outwards(const CanvasView& view, const Vec2& from, const Vec2& away) {
  const Points& vertices = view.placement->vertices();
  const Vec2 near = from + away * (3 / view.camera.scale);
  const Vec2 on_screen = view.camera.to_screen(from + away) - view.camera.to_screen(from);
  return on_screen / length(on_screen) * (inside(vertices, near) ? -1 : 1);
}

LabelRequest beside_edge(const CanvasView& view, const Points& edge) {
  const Vec2 along = edge[1] - edge[0], middle = (edge[0] + edge[1]) / 2;
  const Vec2 normal = Vec2(along.y, -along.x) / length(along);
  return {view.camera.to_screen(middle), outwards(view, middle, normal), Vec2{}, line};
}

LabelRequest beside_vertex(const CanvasView& view, const Vec2& vertex) {
  const Vec2 from_centre = vertex - view.placement->centre_of_mass;
  const double away = length(from_centre);
  const Vec2 direction = away > 0 ? Vec2(from_centre / away) : Vec2(0, 1);
  return {view.camera.to_screen(vertex), outwards(view, vertex, direction), Vec2{}, ring};
}

LabelRequest beside_centre(const CanvasView& view) {
  return {view.camera.to_screen(view.placement->centre_of_mass), Vec2(1, -1) / std::numbers::sqrt2,
          Vec2{}, centre};
}

}  // namespace

void draw_part_names(const Painter& painter, const CanvasView& view, Occupied& occupied) {
  std::vector<LabelRequest> requests;
  std::vector<std::string> names;
  const auto add = [&](LabelRequest request, std::string name) {
    const ImVec2 text = text_size(Face::label, name);
    request.size = Vec2(text.x + 10, text.y + 4);
    requests.push_back(request);
    names.push_back(std::move(name));
  };
  const Vec2 c = view.placement->centre_of_mass;
  for (const Figure& figure : view.state.view.walkthrough.figures) {
    const std::string name = part_name(figure);
    if (name.empty()) continue;
    if (figure.kind == FigureKind::vertex) {
      add(beside_vertex(view, figure.points[0]), name);
    } else if (figure.kind != FigureKind::centroid) {
      add(beside_edge(view, figure.points), name);
    } else if (length(figure.points[0] - c) * view.camera.scale > 2 * ring) {
      const Vec2 at = view.camera.to_screen(figure.points[0]);
      occupied.disc(at, ring);
      add({at, Vec2(1, -1) / std::numbers::sqrt2, Vec2{}, ring}, name);
    }
  }
  add(beside_centre(view), "C");
  const auto places = place_labels(requests, occupied, line, 1000);
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (!places[i]) continue;
    const ImVec2 low = vec(places[i]->left, places[i]->top),
                 high = vec(places[i]->right, places[i]->bottom);
    painter.list().AddRectFilled(low, high, view.theme.panel.at(0.9f).packed(), 5);
    draw_text(painter.list(), Face::label, ImVec2(low.x + 5, low.y + 2), view.theme.text, names[i]);
  }
}

namespace {

std::string hint_of_walkthrough(const AppState& state) {
  const Walkthrough& walk = state.view.walkthrough;
  if (walk.ask) return "Click the one that you expect";
  if (walk.hovered && *walk.hovered < walk.figures.size())
    return capitalised(figure_text(*walk.trace, walk.detail, walk.figures[*walk.hovered]));
  if (walk.trace->balanced()) return "Click the boundary: why does no robot stand here?";
  return "Click a chord, or anywhere in the object: why not this one?";
}

// A drag moves the vertex, even under a robot, unless the robot's card is open.
std::string hint_of_vertex(const AppState& state, std::size_t i) {
  const Document& document = state.work.document();
  if (i >= count_vertices(document)) return {};
  const Vec2 at = place_of(document, i);
  const Pick robot = pick_explained(state, state.view.camera.to_screen(at), false);
  return say(can_take_robot(state, robot)
                 ? "{part} {place} · drag to move, Delete to remove · press it once, then drag to "
                   "move the robot"
                 : "{part} {place} · drag to move, Delete to remove",
             {name_of(document, i), given_point(at)});
}

bool on_centroid(const AppState& state) {
  return state.view.held.kind == Pick::Kind::centre && !state.work.document().centre_of_mass &&
         !(state.derived().placement && state.derived().placement->weighing);
}

std::string hint_of_weight(const AppState& state, std::size_t i) {
  const std::vector<Cargo>& cargo = settings(state).cargo;
  if (i >= cargo.size()) return {};
  return say(
      "{part} · {weight} at {place} · drag to move, Delete to remove",
      {name_of(state.work.document(), weight_handle(state.work.document(), i)),
       with_weight_unit(plain(cargo[i].weight), shown(state).units), given_point(cargo[i].at)});
}

std::string hint_of_centre(const AppState& state) {
  const bool cargo = !settings(state).cargo.empty();
  const char* words = on_centroid(state)
                          ? (cargo ? "Centre of mass of the object alone {place} · on the centroid"
                                   : "Centre of mass {place} · on the centroid")
                          : (cargo ? "Centre of mass of the object alone {place} · drag to move"
                                   : "Centre of mass {place} · drag to move");
  return say(words, {point_in_words(own_centre(state),
                                    coordinate_decimals(state.work.document().vertices))});
}

std::string hint_of_team(const Placement* placement, std::size_t i, const Units& units) {
  if (!placement || i >= placement->teams.size()) return {};
  const TeamInWords words =
      team_in_words(*placement, i, coordinate_decimals(placement->vertices()));
  return say(
      "Team {team} · load ratio {ratio} · {load} and {other_load} · {length} apart · press it "
      "to see why",
      {i + 1, words.ratio, words.loads[0], with_weight_unit(words.loads[1], units),
       with_length_unit(words.length, units)});
}

std::string hint_of_uncertainty(const AppState& state) {
  const double radius = shown(state).com_radius;
  return radius > 0 ? say("C uncertainty {radius} · drag to change it",
                          {with_length_unit(plain(radius), shown(state).units)})
                    : "The centre of mass is known exactly · drag outwards to set an uncertainty";
}

std::string hint_of_failing(const Failure& failure, const Pick& at, const Units& units) {
  const std::size_t team = failure.placement.teams.front().robots.size(),
                    robot = at.index * team + static_cast<std::size_t>(at.end);
  if (robot >= failure.report.loads.size()) return {};
  if (robot == failure.robot)
    return say("Robot {robot} fails · Esc brings it back", {failure.placement.number_of(robot)});
  if (!failure.rest)
    return say("Robot {robot} · cannot carry the object while robot {failed} fails",
               {failure.placement.number_of(robot), failure.placement.number_of(failure.robot)});
  const LoadRange& load = failure.report.loads[robot];
  return say("Robot {robot} · {load} while robot {failed} fails",
             {failure.placement.number_of(robot),
              load_in_words(failure.report.model, load, failure.report.greatest, units),
              failure.placement.number_of(failure.robot)});
}

std::string hint_of_robot(const AppState& state, const Pick& at) {
  const Placement* placement = current_placement(state, at.second);
  const Units& units = shown(state).units;
  if (const Failure* failure = failing(state); failure && !at.second)
    return hint_of_failing(*failure, at, units);
  if (!placement || !is_one_team(placement->settings.method))
    return hint_of_team(placement, at.index, units) +
           (can_take_robot(state, at) ? " · " + say("drag it along its range") : "");
  const auto robot = static_cast<std::size_t>(at.end);
  const TeamInWords words =
      team_in_words(*placement, 0, coordinate_decimals(placement->vertices()));
  if (robot >= words.at.size()) return {};
  return say(
      placement->settings.method == Method::given
          ? "Robot {robot} {place} · {load} · drag it anywhere"
      : can_take_robot(state, at)
          ? "Robot {robot} {place} · {load}, like all the others · drag it along the edge: its "
            "neighbours follow"
          : "Robot {robot} {place} · {load}, like all the others · press it to see why",
      {placement->number_of(robot), words.at[robot], with_weight_unit(words.loads[robot], units)});
}

std::string hint_of_candidate(const Placement* placement, std::size_t i) {
  if (!placement || i >= placement->candidates.size()) return {};
  return say("Candidate {candidate} · load ratio {ratio} · press it to see why it was not chosen",
             {i + 1, ratio_in_words(placement->candidates[i].chord.ratio)});
}

std::string hint_of_drawing(const AppState& state) {
  const Points& points = state.view.drawing.points;
  if (points.empty())
    return "Click to place the first vertex · drag to move the view · or use arrow keys and Enter";
  if (state.view.hover.kind == Pick::Kind::vertex && state.view.hover.index < points.size())
    return say("Vertex {vertex} {place} · drag to move",
               {state.view.hover.index + 1, given_point(points[state.view.hover.index])});
  return "Click to place vertices, or type a length · click the first or press Enter to close · Esc removes the last";
}

std::string hint_of_pick(const AppState& state, const Pick& at) {
  switch (at.kind) {
    case Pick::Kind::vertex:
      return hint_of_vertex(state, at.index);
    case Pick::Kind::centre:
      return hint_of_centre(state);
    case Pick::Kind::uncertainty:
      return hint_of_uncertainty(state);
    case Pick::Kind::edge:
      if (const auto why = why_unusable(state, at))
        return say(
            "Edge {edge} cannot be used here: {reason}",
            {at.index + 1, unusable_in_words(*why, settings(state).robot, shown(state).units)});
      return "Double-click the edge to add a vertex";
    case Pick::Kind::robot:
      return hint_of_robot(state, at);
    case Pick::Kind::left_out:
      return say("Robot {robot} is left out: it carries nothing · drag it onto the object",
                 {at.index + 1});
    case Pick::Kind::chord:
      return hint_of_team(current_placement(state, at.second), at.index, shown(state).units);
    case Pick::Kind::candidate:
      return hint_of_candidate(current_placement(state, at.second), at.index);
    case Pick::Kind::cargo:
      return hint_of_weight(state, at.index);
    case Pick::Kind::object:
    case Pick::Kind::frame:
    case Pick::Kind::none:
    case Pick::Kind::ground:
      break;
  }
  return "Drag a robot, a vertex or the centre of mass · scroll to zoom · ? for keys";
}

}  // namespace

std::string hint(const AppState& state) {
  if (state.session.screen.embed) return {};
  if (draws(state.view.tool)) return hint_of_drawing(state);
  if (state.view.tool == Tool::transform)
    return "Drag inside to move, a corner to scale, the knob to turn · arrow keys, [ ] and { } do the same";
  if (state.view.tool == Tool::mark)
    return "Drag along the boundary to mark no-go parts, over a mark to erase it · click an edge to mark all of it";
  if (state.view.tool == Tool::robot)
    return "Click the outline or the object to add a robot · drag a robot to move it · Esc ends it";
  if (state.view.tool == Tool::weight)
    return "Click to put cargo there · drag it to move it · type its weight above · Esc ends it";
  const bool holds =
      state.view.held.kind != Pick::Kind::none && state.view.held.kind != Pick::Kind::ground;
  const Pick& at = holds ? state.view.held : state.view.hover;
  const bool on_grip = at.kind == Pick::Kind::vertex || at.kind == Pick::Kind::centre;
  if (walkthrough_is_open(state) && !state.derived().refusal && !on_grip)
    return hint_of_walkthrough(state);
  return hint_of_pick(state, at);
}

std::string shown_hint(const AppState& state, const Layout& layout) {
  // A phone has neither room for the hint nor the wheel that it mentions; a notice takes its place.
  if (!state.session.notice.text.empty() || state.session.screen.foot > 0 ||
      state.session.screen.window_left > 0 || state.session.screen.window_right > 0 ||
      state.session.screen.window_foot > 0 || !layout.wide || state.session.screen.finger ||
      state.session.screen.height < 560)
    return {};
  std::string text(translated(hint(state)));
  const double room = layout.free.right - layout.tools.right - 22 - 10 - layout.margin;
  while (static_cast<double>(text_size(Face::label, text).x) > room) {
    const std::size_t last = text.rfind(" · ");
    if (last == std::string::npos) return {};
    text.resize(last);
  }
  return text;
}

void draw_hint(ImDrawList& list, const AppState& state, const Layout& layout, const Theme& theme) {
  const std::string text = shown_hint(state, layout);
  if (text.empty()) return;
  const ImVec2 size = text_size(Face::label, text);
  const double width = static_cast<double>(size.x);
  // Beside the view tools, not under them.
  const double left = std::max(layout.free.middle().x - width / 2, layout.tools.right + 22);
  const double top = state.session.screen.height - layout.margin - 24;
  list.AddRectFilled(vec(left - 10, top - 5),
                     vec(left + width + 10, top + static_cast<double>(size.y) + 5),
                     theme.ground.packed(), 8);
  draw_text(list, Face::label, vec(left, top), theme.second_text, text);
}

}  // namespace evenlift::view
