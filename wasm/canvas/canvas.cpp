#include "canvas/canvas.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "evenlift/candidates.h"
#include "evenlift/moved.h"
#include "marks/marks.h"
#include "picture/canvas_view.h"
#include "picture/painter.h"
#include "tools/pick.h"

namespace evenlift::view {
namespace {

// The dots are 1, 2 or 5 times a power of ten units apart.
void draw_ground(ImDrawList& list, const AppState& state, const Theme& theme) {
  const Camera& camera = state.view.camera;
  const double step = grid_step(camera);
  const Vec2 low = camera.to_world(Vec2(0, state.session.screen.height)),
             high = camera.to_world(Vec2(state.session.screen.width, 0));
  const ImU32 colour = theme.dots.packed();
  const float ratio = static_cast<float>(state.session.screen.ratio);
  const float half = std::max(0.75f, std::round(ratio) / ratio * 0.75f);
  const Vec2 first(std::floor(low.x / step), std::floor(low.y / step));
  const int across = static_cast<int>(std::floor(high.x / step) - first.x),
            up = static_cast<int>(std::floor(high.y / step) - first.y);
  for (int i = 0; i <= across; ++i) {
    for (int j = 0; j <= up; ++j) {
      const Vec2 p = camera.to_screen((first + Vec2(i, j)) * step);
      const float x = static_cast<float>(p.x), y = static_cast<float>(p.y);
      list.AddRectFilled(ImVec2(x - half, y - half), ImVec2(x + half, y + half), colour);
    }
  }
}

bool named(const CanvasView& view, std::optional<std::uint32_t> team) {
  const Pick hover = marked_part(view.state);
  return (hover.kind == Pick::Kind::chord || hover.kind == Pick::Kind::robot) &&
         hover.second == view.second && team == hover.index;
}

// After a change, the old lifting base fades out while the new one fades in.
void draw_hull(const Painter& painter, const CanvasView& view, const Shape& shape) {
  const Theme& theme = view.theme;
  const float come = view.scene.progress;
  if (come < 1 && view.scene.hull_before.size() >= 3) {
    painter.fill_around(view.scene.holes, view.scene.hull_before, theme.hull.at(1 - come));
    painter.outline(view.scene.hull_before, theme.hull_outline.at(1 - come), 2);
  }
  // If the remaining robots cannot carry the object, it falls without a press.
  const bool holds = view.placement->loads.has_value();
  const Colour fill = holds ? theme.hull : theme.amber_on_object.at(0.16f),
               outline = holds ? theme.hull_outline : theme.amber_on_object;
  // Under the heat map, only the outline: green would mix with the map's colours.
  if (!view.scene.shows_heat()) painter.fill_around(view.scene.holes, shape.points, fill.at(come));
  painter.outline(shape.points, outline.at(come), 2);
}

void draw_object(const Painter& painter, const CanvasView& view, const Shape& shape) {
  const Scene& scene = view.scene;
  const RowFill rows =
      scene.triangles.empty() ? painter.rows(shape.points, scene.holes) : RowFill{};
  // A traced picture shows through the object.
  const Colour object = view.theme.object.at(view.state.work.backdrop ? 0.6f : 1);
  painter.fill(scene.corners, scene.triangles, object);
  painter.fill(rows, object);
  if (scene.shows_heat()) painter.heat(scene.heat, rows, view.theme);
  draw_load_region(painter, view);
}

void draw_chord(const Painter& painter, const CanvasView& view, const Shape& shape) {
  const Theme& theme = view.theme;
  // More chords than this are thin and faint, to keep the object visible.
  constexpr std::size_t many = 60;
  const std::size_t teams = view.placement->teams.size();
  // A balanced robot's line to C is not a chord.
  const bool balanced = is_one_team(view.placement->settings.method),
             thin = balanced || teams > many;
  const float width = thin ? 1.0f : 2.0f;
  if (!balanced && named(view, shape.team)) {
    painter.line(shape.points[0], shape.points[1], theme.accent_on_object, width + 1);
    return;
  }
  const float strength =
      teams > many ? std::max(0.08f, static_cast<float>(many) / static_cast<float>(teams)) : 1.0f;
  painter.line(shape.points[0], shape.points[1], theme.chord.at(strength), width);
}

void draw_shape(const Painter& painter, const CanvasView& view, const Shape& shape,
                std::size_t candidates) {
  const Theme& theme = view.theme;
  switch (shape.role) {
    case Role::object:
      draw_object(painter, view, shape);
      break;
    case Role::lifting_base:
      draw_hull(painter, view, shape);
      break;
    case Role::clockwise:
      painter.region(shape.points, theme.clockwise, theme.clockwise_line, true);
      break;
    case Role::counterclockwise:
      painter.region(shape.points, theme.counter, theme.counter_line, false);
      break;
    case Role::candidate:
      painter.candidate(shape.points[0], shape.points[1], theme.candidate, candidates);
      break;
    case Role::chord:
      draw_chord(painter, view, shape);
      break;
    case Role::robot:
    case Role::centre_of_mass:
    case Role::cargo:
    case Role::cargo_lever:
    case Role::own_centre:
      break;  // marks are drawn on top, and do not grow with the zoom
  }
}

// The hovered candidate or team while teams may stand anywhere in their ranges.
std::optional<Chord> chord_in_its_range(const CanvasView& view) {
  const Pick named = view.state.view.held.kind == Pick::Kind::robot ? view.state.view.held
                                                                    : marked_part(view.state);
  const Placement& placement = *view.placement;
  if (!can_move_teams(placement) || named.second != view.second) return std::nullopt;
  return chord_of_part(placement, named);
}

// The robots' ranges: a soft double wedge from C to both edges.
void draw_range(const Painter& painter, const CanvasView& view) {
  const std::optional<Chord> chord = chord_in_its_range(view);
  if (!chord) return;
  const Placement& placement = *view.placement;
  const Vec2& c = placement.centre_of_mass;
  for (const PairRange& range : ranges_of(placement, *chord)) {
    const Chord first = chord_at(c, range, range.first), last = chord_at(c, range, range.last);
    const auto end_on = [](const Chord& each, std::uint32_t edge) {
      return each.r1.edge == edge ? each.r1.position : each.r2.position;
    };
    for (const std::uint32_t edge : {range.a, range.b}) {
      const Vec2 from = end_on(first, edge), to = end_on(last, edge);
      const bool turns_left = cross(from - c, to - c) > 0;
      painter.fill_convex(turns_left ? Points{c, from, to} : Points{c, to, from},
                          view.theme.accent.at(0.16f));
      painter.line(from, to, view.theme.accent, 5);
    }
  }
}

// Among many candidates, the marked one is solid, like a marked chord.
void draw_marked_candidate(const Painter& painter, const CanvasView& view) {
  const Pick marked = marked_part(view.state);
  if (marked.kind != Pick::Kind::candidate || marked.second != view.second) return;
  if (const std::optional<Chord> chord = chord_of_part(*view.placement, marked))
    painter.line(chord->r1.position, chord->r2.position, view.theme.accent_on_object, 3);
}

void draw_picture(const Painter& painter, const CanvasView& view) {
  const std::vector<Shape>& shapes = view.scene.shapes;
  const auto candidates = std::count_if(shapes.begin(), shapes.end(),
                                        [](const Shape& s) { return s.role == Role::candidate; });
  for (const Shape& shape : shapes)
    draw_shape(painter, view, shape, static_cast<std::size_t>(candidates));
  draw_range(painter, view);
  draw_marked_candidate(painter, view);
}

void draw_refused_edges(const Painter& painter, const Points& outline, const Place& place,
                        const Theme& theme) {
  std::vector<NumberedEdge> numbered;
  for (const std::size_t edge : {place.index, place.other}) {
    const Vec2 &from = outline[edge % outline.size()], &to = outline[(edge + 1) % outline.size()];
    painter.line(from, to, theme.amber, 5);
    numbered.push_back({from, to, edge});
  }
  draw_edge_numbers(painter, theme, theme.amber, numbered);
}

// Only the outline can be at fault: holes that do not fit are left out.
void draw_refused(const Painter& painter, const AppState& state, const Theme& theme) {
  const Points& outline = state.work.document().vertices;
  painter.outlines(outline, state.work.document().holes, theme.amber, 2);
  const Place& place = state.derived().refusal->place;
  if (outline.empty()) return;
  if (place.kind == Place::Kind::edge) draw_refused_edges(painter, outline, place, theme);
  if (place.kind == Place::Kind::vertex && place.index < outline.size())
    painter.list().AddCircle(painter.at(outline[place.index]), 11, theme.amber.packed(), 32, 3);
}

// While the picture lags behind a drag, the outline is already new.
void draw_outline(const Painter& painter, const CanvasView& view) {
  const Colour colour = view.theme.object_outline;
  const Document& document = view.state.work.document();
  if (lags(view.state))
    painter.outlines(document.vertices, document.holes, colour, 2);
  else
    painter.outlines(view.placement->vertices(), view.scene.holes, colour, 2);
}

void draw_view(ImDrawList& list, const CanvasView& view) {
  const ImVec2 low(static_cast<float>(view.window.left), static_cast<float>(view.window.top));
  const ImVec2 high(static_cast<float>(view.window.right), static_cast<float>(view.window.bottom));
  list.PushClipRect(low, high, true);
  const bool teaches = walkthrough_is_open(view.state) && view.current() && !view.second;
  if (teaches) {
    draw_walkthrough(Painter(list, view.camera, view.window), view);
  } else if (view.placement) {
    const Painter painter(list, view.camera, view.window, view.current() ? 1.0f : 0.35f);
    draw_picture(painter, view);
    if (view.current()) draw_outline(painter, view);
  }
  const Painter painter(list, view.camera, view.window);
  if (view.state.derived().refusal) draw_refused(painter, view.state, view.theme);
  draw_marks(painter, view);
  list.PopClipRect();
}

// Whether a finger drags something, and so hides it.
bool is_hidden_by_finger(const AppState& state) {
  return state.session.screen.touch && state.work.edit_open &&
         state.view.held.kind != Pick::Kind::none && state.view.held.kind != Pick::Kind::ground;
}

// Shows what is under a finger, larger, in the corner of the drawing that is farther away.
void draw_loupe(ImDrawList& list, const CanvasView& view) {
  constexpr double size = 132, factor = 3;
  if (!is_hidden_by_finger(view.state)) return;
  const Rect& free = view.layout.free;
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const Vec2 finger(mouse.x, mouse.y), held = finger + view.state.view.held.at;
  const double gap = view.layout.margin,
               left = finger.x > free.middle().x ? free.left + gap : free.right - gap - size;
  const Rect window{left, free.top + gap, left + size, free.top + gap + size};
  const Camera camera{view.camera.to_world(held), window.middle(), factor * view.camera.scale};
  const ImVec2 low = vec(window.left, window.top), high = vec(window.right, window.bottom);
  list.AddRectFilled(low, high, view.theme.ground.packed(), 10);
  draw_view(list, {view.state, view.theme, view.layout, view.placement, view.scene, camera, window,
                   view.second});
  list.AddRect(low, high, view.theme.accent.packed(), 10, 0, 2);
}

// With a line between them.
void draw_both(ImDrawList& list, const CanvasView& first, const Scene& second,
               const Layout& layout) {
  CanvasView left = first;
  left.window = layout.first;
  draw_view(list, left);
  Camera camera = first.camera;
  camera.anchor +=
      Vec2(layout.second.left - layout.first.left, layout.second.top - layout.first.top);
  const std::optional<Placement>& placement = first.state.derived().second;
  const CanvasView right{first.state, first.theme, layout,        placement ? &*placement : nullptr,
                         second,      camera,      layout.second, true};
  draw_view(list, right);
  const ImU32 line = first.theme.panel_line.packed();
  const Rect& r = layout.second;
  const ImVec2 from(static_cast<float>(r.left), static_cast<float>(r.top));
  const ImVec2 to(static_cast<float>(layout.wide ? r.left : r.right),
                  static_cast<float>(layout.wide ? r.bottom : r.top));
  list.AddLine(from, to, line, 2);
}

}  // namespace

void draw_canvas(const AppState& state, const Scene& scene, const Scene& second,
                 const Layout& layout) {
  const Theme& colours = theme(state);
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  sharpen(list, state);
  draw_ground(list, state, colours);
  if (state.view.tool == Tool::draw) {
    draw_drawing(Painter(list, state.view.camera, state.session.screen.area()), state, colours,
                 layout.free);
    draw_hint(list, state, layout, colours);
    return;
  }
  const Placement* placement = state.derived().placement ? &shown_placement(state) : nullptr;
  const CanvasView view{
      state, colours, layout, placement, scene, state.view.camera, state.session.screen.area(),
      false};
  if (state.work.second_method)
    draw_both(list, view, second, layout);
  else
    draw_view(list, view);
  draw_loupe(list, view);
  if (state.view.tool == Tool::hole)
    draw_drawing(Painter(list, state.view.camera, state.session.screen.area()), state, colours,
                 layout.free);
  draw_hint(list, state, layout, colours);
  if (placement) draw_explained(list, view);
}

}  // namespace evenlift::view
