#include "canvas/canvas_marks.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "canvas/canvas_drawing.h"
#include "canvas/hint.h"
#include "canvas/labels.h"
#include "evenlift/output/words.h"
#include "evenlift/stability.h"
#include "tools/pick.h"
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
  bool numbered, labelled;
};
RobotSize robot_size(std::size_t teams) {
  if (teams <= 8) return {10.5f, 13.5f, true, true};
  if (teams <= 16) return {9, 11.5f, true, true};
  if (teams <= 40) return {7, 9, false, false};
  return {4, 5.5f, false, false};
}

void draw_robot(const Painter& painter, const Theme& theme, const RobotSize& size,
                const Vec2& world, std::size_t team, double share, bool over) {
  ImDrawList& list = painter.list();
  const ImVec2 at = painter.at(world);
  const float pi = 3.14159265f, start = -pi / 2;
  list.AddCircleFilled(at, size.ring + 1.5f, theme.robot_track.packed(), 36);
  list.PathArcTo(at, size.ring, start, start + 2 * pi * static_cast<float>(share), 40);
  list.PathStroke((over ? theme.amber : theme.robot_ring).packed(), 0, over ? 3.0f : 2.0f);
  list.AddCircleFilled(at, size.disc - 1, theme.robot.packed(), 32);
  if (!size.numbered) return;
  const std::string number = std::to_string(team + 1);
  const ImVec2 text = text_size(Face::tiny, number);
  draw_text(list, Face::tiny, ImVec2(at.x - text.x / 2, at.y - text.y / 2), theme.robot_text,
            number);
}

void draw_loads(const Painter& painter, const CanvasView& view, const RobotSize& size) {
  const AppState& state = view.state;
  const Placement& placement = *view.placement;
  const Vec2 middle = view.camera.to_screen(placement.centre_of_mass);
  std::vector<LabelRequest> requests;
  std::vector<std::string> texts;
  std::vector<bool> over;
  for (const Team& team : placement.teams) {
    for (std::size_t end = 0; end < 2; ++end) {
      const Vec2 robot =
          view.camera.to_screen(end == 0 ? team.chord.r1.position : team.chord.r2.position);
      const Vec2 away = robot - middle;
      texts.push_back(kilograms(team.loads[end], placement.loads->max));
      over.push_back(state.capacity && team.loads[end] > *state.capacity);
      const ImVec2 text = text_size(Face::strong_label, texts.back());
      requests.push_back(
          {robot, away / std::max(away.norm(), 1e-9), Vec2(text.x + 12, text.y + 6)});
    }
  }
  const Rect& free = view.layout.free;
  const Rect window{
      std::max(free.left, view.window.left) + 4, std::max(free.top, view.window.top) + 4,
      std::min(free.right, view.window.right) - 4, std::min(free.bottom, view.window.bottom) - 4};
  const auto places = place_labels(requests, window, view.layout.tools, size.ring + 5);
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (!places[i]) continue;
    const Rect& box = *places[i];
    painter.list().AddRectFilled(vec(box.left, box.top), vec(box.right, box.bottom),
                                 view.theme.panel.at(0.88f).packed(), 6);
    draw_text(painter.list(), Face::strong_label, vec(box.left + 6, box.top + 3),
              over[i] ? view.theme.amber : view.theme.text, texts[i]);
  }
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
    for (std::size_t i = 0; i < teams; ++i) {
      const Team& team = view.placement->teams[i];
      for (std::size_t end = 0; end < 2; ++end) {
        if ((view.state.capacity && team.loads[end] > *view.state.capacity) != over) continue;
        draw(end == 0 ? team.chord.r1.position : team.chord.r2.position,
             over ? view.theme.amber : view.theme.robot);
      }
    }
  }
}

// The robots placed up to the current step; their loads are written once all of them are known.
void draw_robots_of_walkthrough(const Painter& painter, const CanvasView& view) {
  const Placement& placement = *view.placement;
  const Progress& known = view.state.walkthrough.known;
  if (known.teams > most_single_robots) return draw_swarm(painter, view, known.teams);
  const RobotSize size = robot_size(placement.teams.size());
  if (known.shares > 0 && known.shares == placement.teams.size() && size.labelled)
    draw_loads(painter, view, size);
  for (std::size_t i = known.teams; i-- > 0;) {
    const Team& team = placement.teams[i];
    for (std::size_t end = 0; end < 2; ++end) {
      const double share = i < known.shares ? team.loads[end] / placement.loads->max : 1;
      draw_robot(painter, view.theme, size,
                 end == 0 ? team.chord.r1.position : team.chord.r2.position, i, share, false);
    }
  }
}

void draw_robots(const Painter& painter, const CanvasView& view) {
  const Placement& placement = *view.placement;
  if (placement.teams.empty()) return;
  if (placement.teams.size() > most_single_robots)
    return draw_swarm(painter, view, placement.teams.size());
  const RobotSize size = robot_size(placement.teams.size());
  const bool at_rest = view.scene.progress >= 1;
  if (size.labelled && at_rest) draw_loads(painter, view, size);
  for (std::size_t i = placement.teams.size(); i-- > 0;) {
    const Team& team = placement.teams[i];
    for (std::size_t end = 0; end < 2; ++end) {
      const Vec2& robot = end == 0 ? team.chord.r1.position : team.chord.r2.position;
      RobotSize now = size;
      if (!at_rest && !stood_there(view.scene, robot)) {
        now.disc *= view.scene.progress;
        now.ring *= view.scene.progress;
      }
      const bool over = view.state.capacity && team.loads[end] > *view.state.capacity;
      draw_robot(painter, view.theme, now, robot, i, team.loads[end] / placement.loads->max, over);
    }
  }
}

void draw_coverage(const Painter& painter, const CanvasView& view) {
  const CoveragePlace& place = view.scene.coverage;
  if (!settings(view.state).overlays.lifting_base || place.room * view.camera.scale < 24) return;
  const std::string share = percentage(view.placement->coverage);
  const ImVec2 at = painter.at(place.at), text = text_size(Face::verdict, share);
  draw_text(painter.list(), Face::verdict, ImVec2(at.x - text.x / 2, at.y - text.y / 2),
            view.theme.hull_text, share);
}

void draw_centre(const Painter& painter, const AppState& state, const Theme& theme) {
  const ImVec2 at = painter.at(centre_of_mass(state));
  const bool hovered = is_hovered(state, Pick::Kind::centre, 0);
  if (hovered) painter.list().AddCircleFilled(at, 16, theme.accent.at(0.22f).packed(), 32);
  const bool wrong = state.refusal && state.refusal->place.kind == Place::Kind::centre_of_mass;
  painter.list().AddCircleFilled(at, 11.5f, theme.object.packed(), 32);
  draw_centre_mark(painter.list(), at, 9,
                   wrong     ? theme.amber
                   : hovered ? theme.accent
                             : theme.robot,
                   theme.object);
}

// An arrow from the centre of mass in a direction in which the object can slide.
void draw_slide(const Painter& painter, const CanvasView& view) {
  const Closure& closure = view.placement->closure;
  if (!closure.translation_free || !closure.translation || view.placement->teams.empty()) return;
  const Vec2 from = view.camera.to_screen(view.placement->centre_of_mass);
  const Vec2 along(closure.translation->x(), -closure.translation->y());
  const Vec2 tail = from + along * 16, head = from + along * 62;
  ImDrawList& list = painter.list();
  painter.arrow(tail, head, view.theme.object, 7);
  painter.arrow(tail, head, view.theme.amber, 3);
  const Vec2 spot = head + along * 4;
  draw_text(list, Face::strong_label, vec(spot.x() + (along.x() < 0 ? -34 : 6), spot.y() - 7),
            view.theme.amber, "slides");
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
  const Colour colour = safe ? view.theme.hull_text : view.theme.amber;
  painter.list().AddCircle(at, 5, view.theme.panel.packed(), 20, 4);
  painter.list().AddCircle(at, 5, colour.packed(), 20, 2);
  const std::string text =
      safe ? "Safe: no push here tips it"
           : "Tips if pushed down with " + kilograms(force, placement.settings.weight);
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

// The method's name and result over its picture, while two methods are compared.
void draw_caption(const Painter& painter, const CanvasView& view) {
  if (!view.placement) return;
  const Placement& p = *view.placement;
  const std::string name = capitalised(std::string(evenlift::name(p.settings.method)));
  std::string numbers = "no team";
  if (p.loads) {
    numbers = kilograms(p.loads->min, p.loads->max, p.loads->max) + " · " + percentage(p.coverage) +
              " covered · " +
              (p.closure.form_closure || p.closure.second_order ? "cannot move" : "can move");
  }
  const ImVec2 title = text_size(Face::strong, name), text = text_size(Face::label, numbers);
  const float width = std::max(title.x, text.x) + 24;
  const double x = view.window.middle().x(), y = view.window.top + (view.layout.wide ? 20 : 6);
  const ImVec2 low = vec(x - static_cast<double>(width) / 2, y), high(low.x + width, low.y + 46);
  painter.list().AddRectFilled(low, high, view.theme.panel.at(0.94f).packed(), 8);
  draw_text(painter.list(), Face::strong, ImVec2(low.x + (width - title.x) / 2, low.y + 5),
            view.theme.text, name);
  draw_text(painter.list(), Face::label, ImVec2(low.x + (width - text.x) / 2, low.y + 26),
            view.theme.second_text, numbers);
}

}  // namespace

void draw_marks(const Painter& painter, const CanvasView& view) {
  const AppState& state = view.state;
  if (walkthrough_is_open(state) && view.current() && !view.second) {
    draw_vertices(painter, view);
    draw_robots_of_walkthrough(painter, view);
    draw_centre(painter, state, view.theme);
    return;
  }
  if (view.current()) draw_coverage(painter, view);
  if (state.tool == Tool::transform) draw_frame_grips(painter, state, view.theme);
  draw_edge_offer(painter, view);
  draw_vertices(painter, view);
  if (view.current()) {
    draw_slide(painter, view);
    draw_robots(painter, view);
  }
  draw_centre(painter, state, view.theme);
  if (view.current()) draw_push(painter, view);
  if (state.refusal) draw_reason(painter, view);
  if (state.second_method) draw_caption(painter, view);
}

}  // namespace evenlift::view
