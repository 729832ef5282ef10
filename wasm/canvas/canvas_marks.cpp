#include "canvas/canvas_marks.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "canvas/canvas_drawing.h"
#include "canvas/canvas_walkthrough.h"
#include "canvas/hint.h"
#include "canvas/labels.h"
#include "evenlift/output/picture.h"
#include "evenlift/output/words.h"
#include "evenlift/stability.h"
#include "tools/pick.h"
#include "tools/shorter_way.h"
#include "ui/icons.h"
#include "walkthrough/walkthrough.h"

namespace evenlift::view {
namespace {

ImVec2 vec(double x, double y) { return {static_cast<float>(x), static_cast<float>(y)}; }

bool is_hovered(const AppState& state, Pick::Kind kind, std::size_t index) {
  const Pick& held = state.held;
  if (held.kind != Pick::Kind::none && held.kind != Pick::Kind::ground)
    return held.kind == kind && held.index == index;
  return state.hover.kind == kind && state.hover.index == index;
}

// A ring to take hold of, or a dot; nothing where they would be so close that they hide the shape.
void draw_vertices(const Painter& painter, const CanvasView& view) {
  const AppState& state = view.state;
  const Theme& theme = view.theme;
  if (state.tool == Tool::transform) return;  // the frame has the grips
  const Points& vertices = state.document.vertices;
  const std::size_t n = vertices.size();
  const Colour outline = state.refusal ? theme.amber : theme.object_outline;
  ImDrawList& list = painter.list();
  for (std::size_t i = 0; i < n; ++i) {
    const ImVec2 at = painter.at(vertices[i]);
    if (is_hovered(state, Pick::Kind::vertex, i) || state.selected == i) {
      list.AddCircleFilled(at, 18, theme.accent.at(0.22f).packed(), 36);
      list.AddCircleFilled(at, 6, theme.panel.packed(), 24);
      list.AddCircle(at, 6, theme.accent.packed(), 24, 2);
      continue;
    }
    if (n > 1000 || state.screen.embed) continue;
    const double before = length(vertices[i] - vertices[i == 0 ? n - 1 : i - 1]);
    const double after = length(vertices[i] - vertices[i + 1 == n ? 0 : i + 1]);
    const double room = std::min(before, after) * state.camera.scale;
    if (n <= 40 && room >= 18) {
      list.AddCircleFilled(at, 4, theme.panel.packed(), 24);
      list.AddCircle(at, 4, outline.packed(), 24, 2);
    } else if (room >= 24) {
      list.AddCircleFilled(at, 2.5f, outline.packed(), 12);
    }
  }
}

void draw_edge_offer(const Painter& painter, const CanvasView& view) {
  const AppState& state = view.state;
  const Theme& theme = view.theme;
  if (state.hover.kind != Pick::Kind::edge || state.held.kind != Pick::Kind::none ||
      state.screen.embed)
    return;
  const ImVec2 at = painter.at(state.hover.at);
  painter.list().AddCircleFilled(at, 5, theme.panel.packed(), 24);
  painter.list().AddCircle(at, 5, theme.accent.packed(), 24, 1.5f);
}

// With many robots their marks are smaller.
struct RobotSize {
  float disc, ring;
  bool numbered;
};
constexpr std::size_t most_labelled = 50;
// How many teams of two there are, or would be of so many balanced robots.
std::size_t pairs_of(const std::vector<Team>& teams) { return (count_robots(teams) + 1) / 2; }

RobotSize robot_size(std::size_t teams) {
  if (teams <= 8) return {10.5f, 13.5f, true};
  if (teams <= 16) return {9, 11.5f, true};
  if (teams <= most_labelled) return {8.5f, 10.5f, true};
  return {4, 5.5f, false};
}

// The number of robots in the first of the teams.
std::size_t robots_of(const std::vector<Team>& all, std::size_t teams) {
  return all.empty() ? 0 : teams * all.front().robots.size();
}

// The size of each robot: one that stands too near to another is smaller and has no number.
std::vector<RobotSize> robot_sizes(const CanvasView& view, const std::vector<Team>& all,
                                   std::size_t teams) {
  std::vector<RobotSize> sizes(robots_of(all, teams), robot_size(pairs_of(all)));
  if (pairs_of(all) <= 16 || pairs_of(all) > most_labelled) return sizes;
  Points robots;
  for (std::size_t i = 0; i < teams; ++i)
    for (const Robot& robot : all[i].robots)
      robots.push_back(view.camera.to_screen(robot.point.position));
  for (std::size_t i = 0; i < robots.size(); ++i) {
    for (std::size_t j = 0; j < robots.size(); ++j)
      if (j != i && length(robots[i] - robots[j]) < 17) sizes[i] = {5.5f, 7, false};
  }
  return sizes;
}

// How a robot is drawn besides its size; one that fails is hollow.
struct RobotLook {
  std::size_t number = 1;
  double share = 1;  // of the greatest load
  bool over = false, failed = false;
};

void draw_robot(const Painter& painter, const Theme& theme, const RobotSize& size,
                const Vec2& world, const RobotLook& look) {
  ImDrawList& list = painter.list();
  const ImVec2 at = painter.at(world);
  const float pi = 3.14159265f, start = -pi / 2;
  if (look.failed) {
    list.AddCircleFilled(at, size.ring, theme.object.packed(), 36);
    list.AddCircle(at, size.disc, theme.robot.packed(), 32, 2);
  } else {
    list.AddCircleFilled(at, size.ring + 1.5f, theme.robot_track.packed(), 36);
    list.PathArcTo(at, size.ring, start, start + 2 * pi * static_cast<float>(look.share), 40);
    list.PathStroke((look.over ? theme.amber : theme.robot_ring).packed(), 0,
                    look.over ? 3.0f : 2.0f);
    list.AddCircleFilled(at, size.disc - 1, theme.robot.packed(), 32);
  }
  if (!size.numbered) return;
  const std::string number = std::to_string(look.number);
  const ImVec2 text = text_size(Face::tiny, number);
  draw_text(list, Face::tiny, ImVec2(at.x - text.x / 2, at.y - text.y / 2),
            look.failed ? theme.robot : theme.robot_text, number);
}

// Where the coverage is written, in CSS pixels, if there is room.
std::optional<Rect> coverage_box(const CanvasView& view) {
  const CoveragePlace& place = view.scene.coverage;
  const bool shown = settings(view.state).overlays.lifting_base && view.placement->loads;
  if (!shown || place.room * view.camera.scale < 24) return std::nullopt;
  const Vec2 at = view.camera.to_screen(place.at);
  const ImVec2 text = text_size(Face::verdict, percentage(view.placement->coverage));
  return Rect{at.x() - text.x / 2, at.y() - text.y / 2, at.x() + text.x / 2, at.y() + text.y / 2};
}

void draw_coverage(const Painter& painter, const CanvasView& view) {
  if (const std::optional<Rect> box = coverage_box(view))
    draw_text(painter.list(), Face::verdict, vec(box->left, box->top), view.theme.hull_text,
              percentage(view.placement->coverage));
}

Rect about(const Vec2& middle, double reach) {
  return {middle.x() - reach, middle.y() - reach, middle.x() + reach, middle.y() + reach};
}

// Where the picture is drawn and nothing lies over it.
Rect free_window(const CanvasView& view) {
  const Rect& free = view.layout.free;
  return {std::max(free.left, view.window.left) + 4,
          std::max(free.top, view.window.top) + view.layout.caption + 4,
          std::min(free.right, view.window.right) - 4,
          std::min(free.bottom, view.window.bottom) - 4};
}

// What labels keep clear of: robots, the centre of mass, vertices that can be dragged, the coverage, and lines.
Occupied occupied_by_marks(const CanvasView& view, double reach) {
  const Placement& placement = *view.placement;
  Occupied occupied(free_window(view));
  occupied.box(view.layout.tools);
  for (const Team& team : placement.teams) {
    for (const Robot& robot : team.robots)
      occupied.box(about(view.camera.to_screen(robot.point.position), reach));
    for (const Segment& line : joining_lines(team, placement.centre_of_mass))
      occupied.line(view.camera.to_screen(line.from), view.camera.to_screen(line.to));
  }
  occupied.box(about(view.camera.to_screen(centre_of_mass(view.state)), 12));
  const Points& vertices = placement.vertices();
  const std::size_t n = vertices.size();
  Vec2 last = view.camera.to_screen(vertices[n - 1]);
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 at = view.camera.to_screen(vertices[i]);
    occupied.line(last, at);
    if (n <= 40 && !view.state.screen.embed) occupied.box(about(at, 6));
    last = at;
  }
  if (const std::optional<Rect> coverage = coverage_box(view)) occupied.box(*coverage);
  return occupied;
}

// Writes beside the robots what they bear; nothing at one that fails, nor where nobody bears anything.
void draw_loads(const Painter& painter, const CanvasView& view, const RobotSize& size,
                const std::vector<LoadRange>& loads, double greatest, Occupied& occupied) {
  if (greatest == 0) return;
  const Placement& placement = *view.placement;
  const Vec2 middle = view.camera.to_screen(placement.centre_of_mass);
  const bool few = pairs_of(placement.teams) <= 8;
  std::vector<LabelRequest> requests;
  std::vector<std::string> texts;
  std::vector<bool> over;
  std::size_t number = 0;
  for (const Team& team : placement.teams) {
    for (const Robot& robot : team.robots) {
      const LoadRange& load = loads[number++];
      const bool failed = view.failure() && view.failure()->robot + 1 == number;
      const Vec2 at = view.camera.to_screen(robot.point.position);
      if (failed || !view.window.contains(at)) continue;
      const Vec2 away = at - middle;
      texts.push_back(load_in_words(load.least, load.greatest, greatest, placement.settings.units));
      over.push_back(view.overloads(load.greatest));
      const ImVec2 text = text_size(Face::strong_label, texts.back());
      requests.push_back({at, away / std::max(away.norm(), 1e-9), Vec2(text.x + 12, text.y + 6)});
    }
  }
  // A label may cross a line where there are few of them; of many only those are shown that fit.
  const auto places =
      place_labels(requests, occupied, static_cast<double>(size.ring) + 4, few ? 60 : 8);
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (!places[i]) continue;
    const Rect& box = *places[i];
    painter.list().AddRectFilled(vec(box.left, box.top), vec(box.right, box.bottom),
                                 view.theme.panel.at(0.88f).packed(), 6);
    draw_text(painter.list(), Face::strong_label, vec(box.left + 6, box.top + 3),
              over[i] ? view.theme.amber : view.theme.text, texts[i]);
  }
}

// An arrow from the centre of mass in a direction in which the object can slide, and its name where there is room.
void draw_slide(const Painter& painter, const CanvasView& view, Occupied* occupied) {
  const Closure& closure = view.placement->closure;
  if (!closure.translation_free || !closure.translation || view.placement->teams.empty()) return;
  const Vec2 from = view.camera.to_screen(view.placement->centre_of_mass);
  const Vec2 along(closure.translation->x(), -closure.translation->y());
  const Vec2 tail = from + along * 16, head = from + along * 62;
  ImDrawList& list = painter.list();
  painter.arrow(tail, head, view.theme.object, 7);
  painter.arrow(tail, head, view.theme.amber_on_object, 3);
  if (!occupied) return;
  occupied->line(tail, head);
  const ImVec2 text = text_size(Face::strong_label, "slides");
  const auto place =
      place_labels({{head, along, Vec2(text.x + 12, text.y + 6)}}, *occupied, 4, 60)[0];
  if (!place) return;
  list.AddRectFilled(vec(place->left, place->top), vec(place->right, place->bottom),
                     view.theme.panel.at(0.88f).packed(), 6);
  draw_text(list, Face::strong_label, vec(place->left + 6, place->top + 3), view.theme.amber,
            "slides");
}

// Thousands of robots are dots, and one dot is drawn for all of them in the same spot, so that the
// window bounds what a frame draws.
void draw_swarm(const Painter& painter, const CanvasView& view, std::size_t teams) {
  constexpr double spot = 3;  // CSS pixels
  const Rect& window = view.window;
  const auto across = static_cast<std::size_t>(window.width() / spot) + 1,
             down = static_cast<std::size_t>(window.height() / spot) + 1;
  std::vector<bool> taken(across * down);
  const auto draw = [&](const Vec2& robot, Colour colour) {
    const Vec2 at = view.camera.to_screen(robot);
    if (!window.contains(at)) return;
    const auto column = static_cast<std::size_t>((at.x() - window.left) / spot),
               row = static_cast<std::size_t>((at.y() - window.top) / spot);
    if (taken[row * across + column]) return;
    taken[row * across + column] = true;
    painter.list().AddRectFilled(vec(at.x() - 2, at.y() - 2), vec(at.x() + 2, at.y() + 2),
                                 colour.packed());
  };
  // Overloaded robots come first, so that no other hides them.
  for (const bool over : {true, false}) {
    std::size_t number = 0;
    for (std::size_t i = 0; i < teams; ++i) {
      for (const Robot& robot : view.placement->teams[i].robots) {
        if (view.overloads(view.outlook().loads[number++].greatest) != over) continue;
        draw(robot.point.position, over ? view.theme.amber_on_object : view.theme.robot);
      }
    }
  }
}

// Where a robot stood: its disc, hollow and with its number.
void draw_left(const Painter& painter, const CanvasView& view, const Figure& figure) {
  const ImVec2 at = painter.at(figure.points[0]);
  painter.list().AddCircleFilled(at, 11, view.theme.object.packed(), 32);
  painter.list().AddCircle(at, 10, view.theme.amber_on_object.packed(), 32, 2);
  const std::string number = std::to_string(figure.item.value_or(0) + 1);
  const ImVec2 text = text_size(Face::tiny, number);
  draw_text(painter.list(), Face::tiny, ImVec2(at.x - text.x / 2, at.y - text.y / 2),
            view.theme.amber_on_object, number);
}

// The robots that stay where they are while a question is asked about the others. A ring is where
// one of these comes (canvas_walkthrough.cpp).
void draw_rest_of_question(const Painter& painter, const CanvasView& view) {
  const BalancedDetail& balanced = *view.state.walkthrough.ask->detail.balanced;
  const RobotSize size = robot_size((balanced.robots.size() + 1) / 2);
  const auto stays = [&](const Vec2& place) {
    if (balanced.stand && balanced.stand->position == place) return false;
    return std::any_of(balanced.rest.begin(), balanced.rest.end(),
                       [&](const LiftingPoint& robot) { return robot.position == place; });
  };
  for (std::size_t i = 0; i < balanced.robots.size(); ++i) {
    const Vec2& place = balanced.robots[i].position;
    if (stays(place))
      draw_robot(painter, view.theme, size, place,
                 {.number = balanced.numbers[i] + std::size_t{1}});
  }
}

// The balanced robots of the current step, with their loads from where these are told.
void draw_balanced_of_walkthrough(const Painter& painter, const CanvasView& view) {
  const Walkthrough& walk = view.state.walkthrough;
  if (asks_of_other_robots(view.state)) return draw_rest_of_question(painter, view);
  if (!walk.detail.balanced) return;
  const BalancedDetail& balanced = *walk.detail.balanced;
  const RobotSize size = robot_size((balanced.robots.size() + 1) / 2);
  const Chapter chapter = walk.detail.step.chapter;
  if (chapter == Chapter::loads || chapter == Chapter::grasp) {
    // Somebody may have moved the robots of the document by hand.
    CanvasView found = view;
    found.placement = &walk.trace->placement;
    Occupied occupied = occupied_by_marks(found, static_cast<double>(size.ring) + 2);
    draw_loads(painter, found, size, loads_by(LoadModel::plan, *found.placement, std::nullopt, 0),
               found.placement->loads->max, occupied);
  }
  for (const Figure& figure : walk.figures)
    if (figure.kind == FigureKind::left) draw_left(painter, view, figure);
  for (std::size_t i = balanced.robots.size(); i-- > 0;)
    draw_robot(painter, view.theme, size, balanced.robots[i].position,
               {.number = balanced.numbers[i] + std::size_t{1}});
}

// The robots placed up to the current step; their loads are written once all of them are known.
void draw_robots_of_walkthrough(const Painter& painter, const CanvasView& view) {
  const Placement& placement = *view.placement;
  if (view.state.walkthrough.trace->balanced()) return draw_balanced_of_walkthrough(painter, view);
  const Progress& known = view.state.walkthrough.known;
  if (known.teams > most_single_robots) return draw_swarm(painter, view, known.teams);
  const std::vector<Team>& teams = teams_at(*view.state.walkthrough.trace, known);
  const std::vector<RobotSize> sizes = robot_sizes(view, teams, known.teams);
  if (known.shares > 0 && known.shares == placement.teams.size() && known.shares <= most_labelled) {
    const RobotSize size = robot_size(placement.teams.size());
    Occupied occupied = occupied_by_marks(view, static_cast<double>(size.ring) + 2);
    draw_loads(painter, view, size, loads_by(LoadModel::plan, placement, std::nullopt, 0),
               placement.loads->max, occupied);
  }
  for (std::size_t i = known.teams; i-- > 0;) {
    std::size_t number = robots_of(teams, i);
    for (const Robot& robot : teams[i].robots) {
      const double share = i < known.shares ? robot.load / placement.loads->max : 1;
      draw_robot(painter, view.theme, sizes[number++], robot.point.position, {i + 1, share});
    }
  }
}

void draw_robots(const Painter& painter, const CanvasView& view) {
  const Placement& placement = *view.placement;
  if (placement.teams.empty()) return;
  if (placement.teams.size() > most_single_robots)
    return draw_swarm(painter, view, placement.teams.size());
  const Outlook& outlook = view.outlook();
  const std::vector<RobotSize> sizes = robot_sizes(view, placement.teams, placement.teams.size());
  const bool at_rest = view.scene.progress >= 1;
  if (pairs_of(placement.teams) <= most_labelled && at_rest) {
    const RobotSize size = robot_size(pairs_of(placement.teams));
    Occupied occupied = occupied_by_marks(view, static_cast<double>(size.ring) + 2);
    draw_slide(painter, view, &occupied);
    draw_loads(painter, view, size, outlook.loads, outlook.greatest, occupied);
  } else {
    draw_slide(painter, view, nullptr);
  }
  // Discs of one team have its number; balanced robots, which are a single team, one each, and so do all
  // while one of them fails, since words then speak of single robots.
  const bool alone = placement.settings.method == Method::balanced || view.failure();
  for (std::size_t i = placement.teams.size(); i-- > 0;) {
    std::size_t number = robots_of(placement.teams, i);
    for (const Robot& robot : placement.teams[i].robots) {
      const Vec2& at = robot.point.position;
      RobotSize now = sizes[number];
      if (!at_rest && !stood_there(view.scene, at)) {
        now.disc *= view.scene.progress;
        now.ring *= view.scene.progress;
      }
      const double load = outlook.loads[number].greatest;
      draw_robot(painter, view.theme, now, at,
                 {alone ? number + 1 : i + 1, outlook.greatest > 0 ? load / outlook.greatest : 0,
                  view.overloads(load), view.failure() && view.failure()->robot == number});
      ++number;
    }
  }
}

// Where the robot that is dragged cannot go, up to where it is wanted.
void draw_closed_stretch(const Painter& painter, const CanvasView& view) {
  const AppState& state = view.state;
  const auto robot = static_cast<std::size_t>(state.held.end);
  if (!state.closed_to || view.second || state.held.kind != Pick::Kind::robot) return;
  const Placement& placement = *view.placement;
  const bool balanced = placement.settings.method == Method::balanced;
  const std::size_t team = balanced ? 0 : state.held.index;
  if (team >= placement.teams.size() || robot >= placement.teams[team].robots.size()) return;
  LiftingPoint from = placement.teams[team].robots[robot].point;
  if (placement.stands) from.position = placement.stands->contact(from);
  const Points way = shorter_way(placement.vertices(), from, *state.closed_to);
  painter.outline(way, view.theme.amber_on_object, 5, false);
  const ImVec2 at = painter.at(way.back());
  const Vec2 spot(static_cast<double>(at.x), static_cast<double>(at.y));
  draw_word(painter.list(), spot, view.window, view.theme, view.theme.amber,
            balanced ? "Closed to it: the others cannot follow"
                     : "Closed to it: other robots are in the way");
}

// The edge on whose tip the object balances.
void draw_tip(const Painter& painter, const ImVec2& tip, const Theme& theme, Colour colour) {
  const ImVec2 left(tip.x - 9, tip.y + 15), right(tip.x + 9, tip.y + 15);
  painter.list().AddTriangle(tip, left, right, theme.object.packed(), 5);
  painter.list().AddTriangleFilled(tip, left, right, colour.packed());
}

void draw_centre(const Painter& painter, const CanvasView& view) {
  const AppState& state = view.state;
  const Theme& theme = view.theme;
  const ImVec2 at = painter.at(centre_of_mass(state));
  if (view.placement && view.placement->settings.method == Method::balanced)
    draw_tip(painter, ImVec2(at.x, at.y + 11), theme, theme.robot);
  const bool hovered = is_hovered(state, Pick::Kind::centre, 0);
  if (hovered) painter.list().AddCircleFilled(at, 16, theme.accent.at(0.22f).packed(), 32);
  const bool wrong = state.refusal && state.refusal->place.kind == Place::Kind::centre_of_mass;
  painter.list().AddCircleFilled(at, 11.5f, theme.object.packed(), 32);
  draw_centre_mark(painter.list(), at, 9,
                   wrong     ? theme.amber_on_object
                   : hovered ? theme.accent_on_object
                             : theme.robot,
                   theme.object);
}

// A circle of dashes, as long as candidates have them.
void draw_dashed_circle(ImDrawList& list, ImVec2 at, float radius, Colour colour) {
  const int dashes = std::clamp(static_cast<int>(radius * 0.6f), 12, 120);
  const float turn = 2 * 3.14159265f / static_cast<float>(dashes);
  for (int i = 0; i < dashes; ++i) {
    const float from = turn * static_cast<float>(i);
    list.PathArcTo(at, radius, from, from + turn * 0.6f, 6);
    list.PathStroke(colour.packed(), 0, 1.5f);
  }
}

// How far the centre of mass may be off before the object tips; and, as a ring with a grip, within which distance it is known.
void draw_halo(const Painter& painter, const CanvasView& view) {
  const AppState& state = view.state;
  if (!settings(state).overlays.halo || view.placement->teams.empty()) return;
  const Theme& theme = view.theme;
  ImDrawList& list = painter.list();
  const ImVec2 at = painter.at(centre_of_mass(state));
  const double margin = view.outlook().robustness.tipping_distance,
               known = settings(state).com_radius;
  const auto in_pixels = [&](double length) {
    return static_cast<float>(std::min(length * view.camera.scale, 1e5));
  };
  if (margin > 0) draw_dashed_circle(list, at, in_pixels(margin), theme.hull_text);
  const Colour ring = known < margin ? theme.accent_on_object : theme.amber_on_object;
  if (known > 0) {
    list.AddCircleFilled(at, in_pixels(known), ring.at(0.12f).packed(), 64);
    list.AddCircle(at, in_pixels(known), ring.packed(), 64, 2);
  }
  const std::optional<Vec2> grip = doubt_grip(state);
  if (!grip || view.second) return;
  const ImVec2 spot = vec(grip->x(), grip->y());
  const ImVec2 foot(at.x + in_pixels(known) * 0.70710678f, at.y - in_pixels(known) * 0.70710678f);
  const bool hot = is_hovered(state, Pick::Kind::doubt, 0);
  list.AddLine(foot, spot, ring.packed(), 1.5f);
  if (hot) list.AddCircleFilled(spot, 14, theme.accent.at(0.22f).packed(), 32);
  list.AddCircleFilled(spot, 6, theme.object.packed(), 24);
  list.AddCircle(spot, 6, ring.packed(), 24, 2);
}

// How hard a push under the pointer must be to tip the object.
void draw_push(const Painter& painter, const CanvasView& view) {
  const Pick& hover = view.state.hover;
  const Placement& placement = *view.placement;
  if (hover.kind != Pick::Kind::object || hover.second != view.second || placement.teams.empty())
    return;
  const double force = tipping_force(placement.lifting_base, placement.centre_of_mass,
                                     placement.settings.weight, hover.at);
  const bool safe = std::isinf(force);
  const ImVec2 at = painter.at(hover.at);
  const Colour colour = safe ? view.theme.hull_text : view.theme.amber_on_object;
  painter.list().AddCircle(at, 5, view.theme.panel.packed(), 20, 4);
  painter.list().AddCircle(at, 5, colour.packed(), 20, 2);
  const std::string text =
      safe ? "Safe: no push here tips it"
           : "Tips if pushed down with " +
                 load_in_words(force, placement.settings.weight, placement.settings.units);
  // The box has the panel's colour, on which the lifting base's dark green could not be read.
  draw_word(painter.list(), Vec2(static_cast<double>(at.x), static_cast<double>(at.y)), view.window,
            view.theme, safe ? view.theme.text : view.theme.amber, text);
}

// Writes why a polygon is refused at the place of the fault.
void draw_reason(const Painter& painter, const CanvasView& view) {
  const InputError& error = *view.state.refusal;
  const Points& vertices = view.state.document.vertices;
  const std::size_t n = vertices.size();
  Vec2 spot;
  if (error.place.kind == Place::Kind::vertex && error.place.index < n) {
    spot = vertices[error.place.index];
  } else if (error.place.kind == Place::Kind::edge && error.place.index < n &&
             error.place.other < n) {
    const Vec2 &a = vertices[error.place.index], &b = vertices[(error.place.index + 1) % n];
    const Vec2 &c = vertices[error.place.other], &d = vertices[(error.place.other + 1) % n];
    const double turn = cross(b - a, d - c);
    const double share = turn != 0 ? std::clamp(cross(c - a, d - c) / turn, 0.0, 1.0) : 0.5;
    spot = a + (b - a) * share;
  } else if (error.place.kind == Place::Kind::centre_of_mass) {
    spot = centre_of_mass(view.state);
  } else {
    return;
  }
  draw_word(painter.list(), view.camera.to_screen(spot), view.window, view.theme, view.theme.amber,
            capitalised(error.message));
}

// What a method came to: its loads, its coverage, and where there is room whether the object can move.
std::string result_in_words(const Placement& placement, bool wide) {
  if (!placement.loads) return "no team";
  const LoadSummary& loads = *placement.loads;
  const std::string words =
      load_in_words(loads.min, loads.max, loads.max, placement.settings.units) + " · " +
      percentage(placement.coverage) + " covered";
  return wide ? words + (is_held(placement) ? " · cannot move" : " · can move") : words;
}

// The method's name and result over its picture, while two methods are compared: two lines, or on a narrow screen one.
void draw_caption(const Painter& painter, const CanvasView& view) {
  if (!view.placement) return;
  const bool wide = view.layout.wide;
  const std::string name =
      capitalised(std::string(evenlift::name(view.placement->settings.method)));
  const std::string result = result_in_words(*view.placement, wide);
  const Face face = wide ? Face::strong : Face::strong_label;
  const ImVec2 title = text_size(face, name), text = text_size(Face::label, result);
  const float beside = title.x + 10;  // where the result begins in the same line
  const float width = (wide ? std::max(title.x, text.x) : beside + text.x) + 24;
  const double height = wide ? 46 : 28;
  const ImVec2 low = vec(view.window.middle().x() - static_cast<double>(width) / 2,
                         view.window.top + view.layout.caption - height);
  const ImVec2 high(low.x + width, low.y + static_cast<float>(height));
  painter.list().AddRectFilled(low, high, view.theme.panel.at(0.94f).packed(), 8);
  const ImVec2 name_at(wide ? low.x + (width - title.x) / 2 : low.x + 12, low.y + 5);
  const ImVec2 result_at = wide ? ImVec2(low.x + (width - text.x) / 2, low.y + 26)
                                : ImVec2(name_at.x + beside, name_at.y);
  draw_text(painter.list(), face, name_at, view.theme.text, name);
  draw_text(painter.list(), Face::label, result_at, view.theme.second_text, result);
}

}  // namespace

void draw_marks(const Painter& painter, const CanvasView& view) {
  const AppState& state = view.state;
  if (walkthrough_is_open(state) && view.current() && !view.second) {
    draw_vertices(painter, view);
    draw_robots_of_walkthrough(painter, view);
    draw_centre(painter, view);
    return;
  }
  if (view.current()) {
    draw_stands(painter, view);
    draw_coverage(painter, view);
  }
  if (state.tool == Tool::transform) draw_frame_grips(painter, state, view.theme);
  draw_edge_offer(painter, view);
  draw_vertices(painter, view);
  if (view.current()) {
    draw_halo(painter, view);
    draw_closed_stretch(painter, view);
    draw_robots(painter, view);
  }
  draw_centre(painter, view);
  if (view.current()) draw_push(painter, view);
  if (view.current()) draw_why_unusable(painter, view);
  if (state.refusal) draw_reason(painter, view);
  if (state.second_method) draw_caption(painter, view);
}

}  // namespace evenlift::view
