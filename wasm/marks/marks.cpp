#include "marks/marks.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "evenlift/loads.h"
#include "evenlift/output/words.h"
#include "evenlift/stability.h"
#include "evenlift/wording.h"
#include "tools/drawing.h"
#include "tools/pick.h"
#include "ui/controls.h"
#include "ui/theme.h"

namespace evenlift::view {
namespace {

// Draws vertices as rings or, if there are many, as dots; nothing where these would hide the shape.
void draw_ring(const Painter& painter, const CanvasView& view, const Points& ring,
               std::size_t first) {
  const AppState& state = view.state;
  const Theme& theme = view.theme;
  const std::size_t n = ring.size();
  const Colour outline = state.derived().refusal ? theme.amber : theme.object_outline;
  ImDrawList& list = painter.list();
  for (std::size_t i = 0; i < n; ++i) {
    const ImVec2 at = painter.at(ring[i]);
    if (is_hovered(state, Pick::Kind::vertex, first + i) || state.view.selected == first + i) {
      list.AddCircleFilled(at, 18, theme.accent.at(0.22f).packed(), 36);
      list.AddCircleFilled(at, 6, theme.panel.packed(), 24);
      list.AddCircle(at, 6, theme.accent.packed(), 24, 2);
      continue;
    }
    if (n > 1000 || state.session.screen.embed) continue;
    const double before = length(ring[i] - ring[i == 0 ? n - 1 : i - 1]);
    const double after = length(ring[i] - ring[i + 1 == n ? 0 : i + 1]);
    const double room = std::min(before, after) * state.view.camera.scale;
    if (n <= 40 && room >= 18) {
      list.AddCircleFilled(at, 4, theme.panel.packed(), 24);
      list.AddCircle(at, 4, outline.packed(), 24, 2);
    } else if (room >= 24) {
      list.AddCircleFilled(at, 2.5f, outline.packed(), 12);
    }
  }
}

void draw_vertices(const Painter& painter, const CanvasView& view) {
  if (view.state.view.tool == Tool::transform) return;  // the frame has the grips
  for_each_ring(view.state.work.document(), [&](const Points& ring, std::size_t first) {
    draw_ring(painter, view, ring, first);
  });
}

void draw_edge_offer(const Painter& painter, const CanvasView& view) {
  const AppState& state = view.state;
  const Theme& theme = view.theme;
  if (state.view.hover.kind != Pick::Kind::edge || state.view.held.kind != Pick::Kind::none ||
      state.session.screen.embed)
    return;
  const ImVec2 at = painter.at(state.view.hover.at);
  painter.list().AddCircleFilled(at, 5, theme.panel.packed(), 24);
  painter.list().AddCircle(at, 5, theme.accent.packed(), 24, 1.5f);
}

// The path closed to the dragged robot, up to where it should go.
void draw_closed_stretch(const Painter& painter, const CanvasView& view) {
  const AppState& state = view.state;
  const auto robot = static_cast<std::size_t>(state.view.held.end);
  if (!state.view.closed_to || view.second || state.view.held.kind != Pick::Kind::robot) return;
  const Placement& placement = *view.placement;
  const bool balanced = is_one_team(placement.settings.method);
  const std::size_t team = balanced ? 0 : state.view.held.index;
  if (team >= placement.teams.size() || robot >= placement.teams[team].robots.size()) return;
  LiftingPoint from = placement.teams[team].robots[robot].point;
  if (placement.stands) from.position = placement.stands->contact(from);
  const Points way = shorter_way(placement.vertices(), from, *state.view.closed_to);
  painter.outline(way, view.theme.amber_on_object, 5, false);
  const ImVec2 at = painter.at(way.back());
  const Vec2 spot(static_cast<double>(at.x), static_cast<double>(at.y));
  draw_word(painter.list(), spot, view.uncovered(), view.theme, view.theme.amber,
            closed_in_words(placement, team * placement.teams[team].robots.size() + robot));
}

// Supports that are left out, hollow and with their numbers, and the outlines of holes.
void draw_left_out(const Painter& painter, const CanvasView& view) {
  if (view.second || !view.current()) return;
  const AppState& state = view.state;
  const Theme& theme = view.theme;
  constexpr float radius = 12;
  for (const Misplaced& each : view.placement->left_out) {
    if (each.kind == Misplaced::Kind::hole) {
      painter.outline(state.work.document().holes[each.index], theme.amber, 2, true);
      continue;
    }
    const ImVec2 at = painter.at(view.placement->settings.supports[each.index]);
    const bool marked = is_hovered(state, Pick::Kind::left_out, each.index);
    painter.list().AddCircleFilled(at, radius, theme.panel.packed(), 32);
    painter.list().AddCircle(at, radius, theme.amber.packed(), 32, marked ? 3.0f : 2.0f);
    const std::string number = std::to_string(each.index + 1);
    const ImVec2 text = text_size(Face::tiny, number);
    draw_text(painter.list(), Face::tiny, ImVec2(at.x - text.x / 2, at.y - text.y / 2), theme.amber,
              number);
    const bool held = holds_support(state) && state.view.held.kind == Pick::Kind::left_out &&
                      state.view.held.index == each.index;
    if (!held && !marked) continue;
    const Vec2 spot(static_cast<double>(at.x), static_cast<double>(at.y));
    draw_word(painter.list(), spot, view.uncovered(), theme, held ? theme.second_text : theme.amber,
              held && state.view.dragged_out
                  ? say("Let go to take it away")
                  : say(each.in_hole ? "Robot {robot} is in a hole" : "Robot {robot} is outside",
                        {each.index + 1}));
  }
}

// Marks where a click would add a robot, where the held robot would be even with another, and,
// outside the object, the held robot.
void draw_support_help(const Painter& painter, const CanvasView& view) {
  const AppState& state = view.state;
  const Theme& theme = view.theme;
  const Pick& over = state.view.hover;
  const bool adds = state.view.tool == Tool::robot && state.view.held.kind == Pick::Kind::none &&
                    (over.kind == Pick::Kind::edge || over.kind == Pick::Kind::object ||
                     over.kind == Pick::Kind::vertex);
  if (adds && !view.second && view.current())
    if (const auto spot = support_spot(state, over.at, std::nullopt))
      painter.list().AddCircle(painter.at(*spot), 10, theme.accent_on_object.packed(), 32, 2);
  if (view.second || !holds_support(state)) return;
  if (state.view.held.kind == Pick::Kind::left_out) return;
  constexpr double ghost_reach = 60;  // pixels
  const auto robot = static_cast<std::size_t>(state.view.held.end);
  const std::vector<Robot>& robots = view.placement->teams[0].robots;
  if (robot >= robots.size()) return;
  const auto even = even_spot(state, robots[robot].point.position, robot, ghost_reach);
  if (!even) return;
  painter.list().AddCircle(painter.at(*even), 10, theme.accent_on_object.packed(), 32, 1.5f);
  painter.list().AddCircleFilled(painter.at(*even), 3, theme.accent_on_object.packed(), 16);
}

// The least press down at the pointer that tips the object.
void draw_push(const Painter& painter, const CanvasView& view) {
  const Pick& hover = view.state.view.hover;
  const Placement& placement = *view.placement;
  if (hover.kind != Pick::Kind::object || hover.second != view.second || placement.teams.empty())
    return;
  const double force = tipping_force({placement, shown(view.state)}, hover.at);
  const bool safe = std::isinf(force);
  const ImVec2 at = painter.at(hover.at);
  const Colour colour = safe ? view.theme.hull_text : view.theme.amber_on_object;
  painter.list().AddCircle(at, 5, view.theme.panel.packed(), 20, 4);
  painter.list().AddCircle(at, 5, colour.packed(), 20, 2);
  const std::string text =
      safe ? "A press down here does not tip it"
           : say("A press down of {force} here tips it",
                 {with_weight_unit(amount(force, placement.weight(), Toward::down),
                                   shown(view.state).units)});
  // On the box, which has the panel's colour, the lifting base's dark green would be illegible.
  draw_word(painter.list(), Vec2(static_cast<double>(at.x), static_cast<double>(at.y)),
            view.uncovered(), view.theme, safe ? view.theme.text : view.theme.amber, text);
}

// Writes the reason at the place of the fault.
void draw_reason(const Painter& painter, const CanvasView& view) {
  const InputError& error = *view.state.derived().refusal;
  const Points& outline = view.state.work.document().vertices;  // holes are left out, not refused
  const Place& place = error.place;
  const std::size_t n = outline.size();
  Vec2 spot;
  if (place.kind == Place::Kind::vertex && place.index < n) {
    spot = outline[place.index];
  } else if (place.kind == Place::Kind::edge && place.index < n && place.other < n) {
    const Vec2 &a = outline[place.index], &b = outline[(place.index + 1) % n];
    const Vec2 &c = outline[place.other], &d = outline[(place.other + 1) % n];
    const double turn = cross(b - a, d - c);
    const double share = turn != 0 ? std::clamp(cross(c - a, d - c) / turn, 0.0, 1.0) : 0.5;
    spot = a + (b - a) * share;
  } else if (place.kind == Place::Kind::centre_of_mass) {
    spot = centre_of_mass(view.state);
  } else {
    return;
  }
  Rect window = view.uncovered();
  for (const Control& control : controls())  // the vertex's bar, at its place of the last frame
    if (control.card == "tool bar" && control.window.left < window.right)
      window.top = std::max(window.top, control.window.bottom);
  draw_word(painter.list(), view.camera.to_screen(spot), window, view.theme, view.theme.amber,
            capitalised(std::string(translated(error.message))));
}

constexpr float gap_in_caption = 10;

// The loads and, if `further` is 1 or 2, the coverage; if 2, also whether the object is held.
std::string result_in_words(const Reported& of, std::size_t further) {
  const Placement& placement = of.placement;
  const Units& units = of.shown.units;
  if (!placement.loads) return "no team";
  double least = of.report.greatest;
  for (const LoadRange& load : of.report.loads) least = std::min(least, load.least);
  std::string words =
      load_in_words(LoadRange{least, of.report.greatest}, of.report.greatest, units);
  if (further == 0) return words;
  return say(further == 1     ? "{loads} · coverage {coverage}"
             : of.report.held ? "{loads} · coverage {coverage} · held"
                              : "{loads} · coverage {coverage} · not held",
             {words, percentage(placement.coverage)});
}

std::string name_in_caption(const Placement& placement) {
  return say(capitalised(method_in_words(placement.settings.method))) + ", " +
         count_of(count_robots(placement.teams), "robot", "robots");
}

// A fact in only one of the captions could not be compared, so both must have room for it.
std::size_t further_in_captions(const CanvasView& view, float room) {
  const auto fits = [&](const Reported& of, std::size_t further) {
    const float taken =
        view.layout.wide
            ? 0
            : text_size(Face::strong_label, name_in_caption(of.placement)).x + gap_in_caption;
    return taken + text_size(Face::label, result_in_words(of, further)).x <= room;
  };
  const Derived& facts = view.state.derived();
  std::size_t further = 2;
  for (const bool second : {false, true})
    while (further > 0 && (second ? facts.second : facts.placement) &&
           !fits(reported(view.state, second), further))
      --further;
  return further;
}

// The method's name and result over its picture in a comparison: two lines, or one on a narrow
// screen.
void draw_caption(const Painter& painter, const CanvasView& view) {
  if (!view.placement) return;
  const bool wide = view.layout.wide;
  const float room = static_cast<float>(view.window.width()) - 40;
  const std::string name = name_in_caption(*view.placement);
  const Face face = wide ? Face::strong : Face::strong_label;
  const ImVec2 title = text_size(face, name);
  const float beside = title.x + gap_in_caption;  // where the result begins in a single line
  const std::string result =
      result_in_words(reported(view.state, view.second), further_in_captions(view, room));
  const ImVec2 text = text_size(Face::label, result);
  const float width = (wide ? std::max(title.x, text.x) : beside + text.x) + 24;
  const double height = wide ? 46 : 28;
  double top = view.window.top + view.layout.caption - height;
  for (const Control& control : controls())  // below the tool's bar, at its place of the last frame
    if (control.card == "tool bar" && control.window.left < view.layout.free.right)
      top = std::max(top, control.window.bottom + 6);
  const ImVec2 low = vec(view.window.middle().x - static_cast<double>(width) / 2, top);
  const ImVec2 high(low.x + width, low.y + static_cast<float>(height));
  painter.list().AddRectFilled(low, high, view.theme.panel.at(0.94f).packed(), 8);
  const ImVec2 name_at(wide ? low.x + (width - title.x) / 2 : low.x + 12, low.y + 5);
  const ImVec2 result_at = wide ? ImVec2(low.x + (width - text.x) / 2, low.y + 26)
                                : ImVec2(name_at.x + beside, name_at.y);
  draw_text(painter.list(), face, name_at, view.theme.text, name);
  draw_text(painter.list(), Face::label, result_at, view.theme.second_text, result);
}

// While the user marks no-go edges, for typing them. A short edge has no room for a number.
void draw_numbers_to_type(const Painter& painter, const CanvasView& view) {
  constexpr double least = 44, reach = 14;  // pixels: of an edge, and of a robot's mark
  const Points& vertices = view.state.work.document().vertices;
  std::vector<NumberedEdge> numbered;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const Vec2 &a = vertices[i], &b = vertices[i + 1 == vertices.size() ? 0 : i + 1];
    const bool seen = view.window.contains(view.camera.to_screen((a + b) / 2));
    if (seen && length(b - a) * view.camera.scale >= least) numbered.push_back({a, b, i});
  }
  std::vector<Rect> robots;
  if (view.current())
    for (const LiftingPoint& robot : lifting_points(view.placement->teams)) {
      const Vec2 at = view.camera.to_screen(robot.position);
      robots.push_back({at.x - reach, at.y - reach, at.x + reach, at.y + reach});
    }
  draw_edge_numbers(painter, view.theme, view.theme.second_text, numbered, std::move(robots));
}

}  // namespace

void draw_marks(const Painter& painter, const CanvasView& view) {
  const AppState& state = view.state;
  if (walkthrough_is_open(state) && view.current() && !view.second) {
    draw_vertices(painter, view);
    draw_cargo(painter, view);
    draw_own_centre(painter, view);
    draw_centre(painter, view);  // it cannot be grabbed here, and must not hide robots
    draw_robots_of_walkthrough(painter, view);
    return;
  }
  if (view.current()) {
    draw_stands(painter, view);
    draw_coverage(painter, view);
  }
  if (state.view.tool == Tool::transform) draw_frame_grips(painter, view);
  draw_edge_offer(painter, view);
  draw_vertices(painter, view);
  draw_cargo(painter, view);
  if (view.current()) {
    draw_halo(painter, view);
    draw_tilt(painter, view);
    draw_closed_stretch(painter, view);
    draw_support_help(painter, view);
    draw_robots(painter, view);
    draw_ratio(painter, view);
  }
  if (state.view.tool == Tool::mark && !view.second) draw_numbers_to_type(painter, view);
  draw_own_centre(painter, view);
  draw_centre(painter, view);
  // Words that explain a mark stand alone.
  if (view.current() && !rested_mark(view) && !draw_carrying_here(painter, view))
    draw_push(painter, view);
  if (view.current()) draw_why_unusable(painter, view);
  draw_left_out(painter, view);
  if (state.derived().refusal) draw_reason(painter, view);
  if (state.work.second_method) draw_caption(painter, view);
}

}  // namespace evenlift::view
