#include "canvas_marks.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "format.h"
#include "icons.h"
#include "labels.h"
#include "pick.h"

namespace evenlift::view {
namespace {

ImVec2 vec(double x, double y) { return {static_cast<float>(x), static_cast<float>(y)}; }

bool is_hovered(const AppState& state, Pick::Kind kind, std::size_t index) {
  const Pick& held = state.held;
  if (held.kind != Pick::Kind::none && held.kind != Pick::Kind::ground)
    return held.kind == kind && held.index == index;
  return state.hover.kind == kind && state.hover.index == index;
}

// A ring that can be taken hold of, or a dot; nothing where they would stand so close that they
// hide the shape.
void draw_vertices(const Painter& painter, const AppState& state, const Theme& theme) {
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

void draw_edge_offer(const Painter& painter, const AppState& state, const Theme& theme) {
  if (state.hover.kind != Pick::Kind::edge || state.held.kind != Pick::Kind::none ||
      state.screen.embed)
    return;
  const ImVec2 at = painter.at(state.hover.at);
  painter.list().AddCircleFilled(at, 5, theme.panel.packed(), 24);
  painter.list().AddCircle(at, 5, theme.accent.packed(), 24, 1.5f);
}

// Marks shrink where robots stand close together.
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
                const Vec2& world, std::size_t team, double share) {
  ImDrawList& list = painter.list();
  const ImVec2 at = painter.at(world);
  const float pi = 3.14159265f, start = -pi / 2;
  list.AddCircleFilled(at, size.ring + 1.5f, theme.robot_track.packed(), 36);
  list.PathArcTo(at, size.ring, start, start + 2 * pi * static_cast<float>(share), 40);
  list.PathStroke(theme.robot_ring.packed(), 0, 2);
  list.AddCircleFilled(at, size.disc - 1, theme.robot.packed(), 32);
  if (!size.numbered) return;
  const std::string number = std::to_string(team + 1);
  const ImVec2 text = text_size(Face::tiny, number);
  draw_text(list, Face::tiny, ImVec2(at.x - text.x / 2, at.y - text.y / 2), theme.robot_text,
            number);
}

void draw_loads(const Painter& painter, const AppState& state, const Layout& layout,
                const Theme& theme, const RobotSize& size) {
  const Placement& placement = *state.placement;
  const int decimals = decimals_for(placement.loads->max);
  const Vec2 middle = state.camera.to_screen(placement.centre_of_mass);
  std::vector<LabelRequest> requests;
  std::vector<std::string> texts;
  for (const Team& team : placement.teams) {
    for (std::size_t end = 0; end < 2; ++end) {
      const Vec2 robot =
          state.camera.to_screen(end == 0 ? team.chord.r1.position : team.chord.r2.position);
      const Vec2 away = robot - middle;
      texts.push_back(weight(team.loads[end], decimals));
      const ImVec2 text = text_size(Face::strong_label, texts.back());
      requests.push_back(
          {robot, away / std::max(away.norm(), 1e-9), Vec2(text.x + 12, text.y + 6)});
    }
  }
  const Rect window{layout.free.left + 4, layout.free.top + 4, layout.free.right - 4,
                    layout.free.bottom - 4};
  const auto places = place_labels(requests, window, layout.tools, size.ring + 5);
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (!places[i]) continue;
    const Rect& box = *places[i];
    painter.list().AddRectFilled(vec(box.left, box.top), vec(box.right, box.bottom),
                                 theme.panel.at(0.88f).packed(), 6);
    draw_text(painter.list(), Face::strong_label, vec(box.left + 6, box.top + 3), theme.text,
              texts[i]);
  }
}

void draw_robots(const Painter& painter, const AppState& state, const Layout& layout,
                 const Theme& theme) {
  const Placement& placement = *state.placement;
  if (placement.teams.empty()) return;
  const RobotSize size = robot_size(placement.teams.size());
  if (size.labelled) draw_loads(painter, state, layout, theme, size);
  for (std::size_t i = placement.teams.size(); i-- > 0;) {
    const Team& team = placement.teams[i];
    for (std::size_t end = 0; end < 2; ++end) {
      draw_robot(painter, theme, size, end == 0 ? team.chord.r1.position : team.chord.r2.position,
                 i, team.loads[end] / placement.loads->max);
    }
  }
}

void draw_coverage(const Painter& painter, const AppState& state, const Scene& scene,
                   const Theme& theme) {
  if (!settings(state).overlays.hull || scene.coverage.room * state.camera.scale < 24) return;
  const std::string share = percent(state.placement->coverage);
  const ImVec2 at = painter.at(scene.coverage.at), text = text_size(Face::verdict, share);
  draw_text(painter.list(), Face::verdict, ImVec2(at.x - text.x / 2, at.y - text.y / 2),
            theme.hull_text, share);
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

void draw_hint(const Painter& painter, const AppState& state, const Layout& layout,
               const Theme& theme) {
  const std::string text = hint(state);
  // A phone has neither the room nor the wheel that it speaks of.
  if (text.empty() || !layout.wide || state.screen.finger || state.screen.height < 560) return;
  const ImVec2 size = text_size(Face::label, text);
  const double left = layout.free.middle().x() - size.x / 2,
               top = state.screen.height - layout.margin - 24;
  painter.list().AddRectFilled(vec(left - 10, top - 5), vec(left + size.x + 10, top + size.y + 5),
                               theme.ground.at(0.85f).packed(), 8);
  draw_text(painter.list(), Face::label, vec(left, top), theme.second_text, text);
}

}  // namespace

std::string hint(const AppState& state) {
  if (state.screen.embed) return {};
  const Pick& at = state.held.kind == Pick::Kind::none || state.held.kind == Pick::Kind::ground
                       ? state.hover
                       : state.held;
  const Points& vertices = state.document.vertices;
  switch (at.kind) {
    case Pick::Kind::vertex:
      if (at.index >= vertices.size()) return {};
      return "Vertex " + std::to_string(at.index + 1) + " " + point(vertices[at.index]) +
             " · drag to move, Delete to remove";
    case Pick::Kind::centre:
      return "Centre of mass " + point(centre_of_mass(state)) + " · drag to move";
    case Pick::Kind::edge:
      return "Double-click the edge to add a vertex";
    case Pick::Kind::robot:
    case Pick::Kind::chord: {
      if (!state.placement || at.index >= state.placement->teams.size()) return {};
      const Team& team = state.placement->teams[at.index];
      const int decimals = decimals_for(state.placement->loads->max);
      return "Team " + std::to_string(at.index + 1) + " · load ratio " +
             fixed(team.chord.ratio, 3) + " · " + fixed(team.loads[0], decimals) + " and " +
             weight(team.loads[1], decimals);
    }
    case Pick::Kind::none:
    case Pick::Kind::ground:
      break;
  }
  return "Drag a vertex or the centre of mass · scroll to zoom · ? for keys";
}

void draw_marks(const Painter& painter, const AppState& state, const Scene& scene,
                const Layout& layout, const Theme& theme) {
  const bool current = state.placement && !state.refusal;
  if (current) draw_coverage(painter, state, scene, theme);
  draw_edge_offer(painter, state, theme);
  draw_vertices(painter, state, theme);
  if (current) draw_robots(painter, state, layout, theme);
  draw_centre(painter, state, theme);
  draw_hint(painter, state, layout, theme);
}

}  // namespace evenlift::view
