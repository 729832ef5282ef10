#include "canvas.h"

#include <algorithm>
#include <cmath>

#include "canvas_marks.h"
#include "painter.h"

namespace evenlift::view {
namespace {

constexpr std::size_t most_dashed =
    300;  // beyond that, thin lines: dashes by the ten thousand are slow

Rect window_of(const AppState& state) { return {0, 0, state.screen.width, state.screen.height}; }

// A grid of dots at 1, 2 or 5 times a power of ten units, so that zooming can be felt.
void draw_ground(ImDrawList& list, const AppState& state, const Theme& theme) {
  const Camera& camera = state.camera;
  const double wanted = 22 / camera.scale, power = std::pow(10.0, std::floor(std::log10(wanted)));
  double step = power;
  for (double nice : {1.0, 2.0, 5.0, 10.0}) {
    step = nice * power;
    if (step >= wanted) break;
  }
  const Vec2 low = camera.to_world(Vec2(0, state.screen.height)),
             high = camera.to_world(Vec2(state.screen.width, 0));
  const ImU32 colour = theme.dots.packed();
  const float half = std::max(0.75f, std::round(static_cast<float>(state.screen.ratio)) /
                                         static_cast<float>(state.screen.ratio) * 0.75f);
  for (double i = std::floor(low.x() / step); i * step <= high.x(); ++i) {
    for (double j = std::floor(low.y() / step); j * step <= high.y(); ++j) {
      const Vec2 p = camera.to_screen(Vec2(i * step, j * step));
      const float x = static_cast<float>(p.x()), y = static_cast<float>(p.y());
      list.AddRectFilled(ImVec2(x - half, y - half), ImVec2(x + half, y + half), colour);
    }
  }
}

void draw_region(const Painter& painter, const Shape& shape, Colour fill, Colour line,
                 bool rising) {
  if (shape.points.size() == 1) {
    painter.list().AddCircle(painter.at(shape.points[0]), 6, line.packed(), 24, 2);
  } else if (shape.points.size() == 2) {
    painter.line(shape.points[0], shape.points[1], line, 3);
  } else {
    painter.fill_convex(shape.points, fill);
    painter.hatch_convex(shape.points, rising, line.at(0.55f));
    painter.outline(shape.points, line.at(0.7f), 1.2f);
  }
}

void draw_shape(const Painter& painter, const AppState& state, const Scene& scene,
                const Shape& shape, const Theme& theme, bool dash) {
  switch (shape.role) {
    case Role::object:
      painter.fill(shape.points, scene.triangles, theme.object);
      break;
    case Role::hull:
      painter.fill_convex(shape.points, theme.hull);
      painter.outline(shape.points, theme.hull_outline, 2);
      break;
    case Role::clockwise:
      draw_region(painter, shape, theme.clockwise, theme.clockwise_line, true);
      break;
    case Role::counterclockwise:
      draw_region(painter, shape, theme.counter, theme.counter_line, false);
      break;
    case Role::candidate:
      if (dash)
        painter.dashes(shape.points[0], shape.points[1], theme.candidate, 1.2f);
      else
        painter.line(shape.points[0], shape.points[1], theme.candidate.at(0.5f), 1);
      break;
    case Role::chord: {
      const bool named =
          (state.hover.kind == Pick::Kind::chord || state.hover.kind == Pick::Kind::robot) &&
          static_cast<std::int32_t>(state.hover.index) == shape.team;
      painter.line(shape.points[0], shape.points[1], named ? theme.accent : theme.chord,
                   named ? 3.0f : 2.0f);
      break;
    }
    case Role::robot:
    case Role::centre_of_mass:
      break;  // marks: they come on top, and do not grow with the view
  }
}

void draw_picture(const Painter& painter, const AppState& state, const Scene& scene,
                  const Theme& theme) {
  const auto candidates = std::count_if(scene.shapes.begin(), scene.shapes.end(),
                                        [](const Shape& s) { return s.role == Role::candidate; });
  const bool dash = static_cast<std::size_t>(candidates) <= most_dashed;
  for (const Shape& shape : scene.shapes) draw_shape(painter, state, scene, shape, theme, dash);
}

// The outline of what is being edited, and where it is wrong.
void draw_refused(const Painter& painter, const AppState& state, const Theme& theme) {
  const Points& vertices = state.document.vertices;
  painter.outline(vertices, theme.amber, 2);
  if (vertices.empty()) return;
  const Place& place = state.refusal->place;
  const auto mark_edge = [&](std::size_t edge) {
    painter.line(vertices[edge % vertices.size()], vertices[(edge + 1) % vertices.size()],
                 theme.amber, 5);
  };
  if (place.kind == Place::Kind::edge) {
    mark_edge(place.index);
    mark_edge(place.other);
  }
  if (place.kind == Place::Kind::vertex && place.index < vertices.size()) {
    painter.list().AddCircle(painter.at(vertices[place.index]), 11, theme.amber.packed(), 32, 3);
  }
}

}  // namespace

void draw_canvas(const AppState& state, const Scene& scene, const Layout& layout) {
  const Theme& colours = theme(state);
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  sharpen(list, state);
  draw_ground(list, state, colours);
  const bool current = !state.refusal;
  if (state.placement) {
    const Painter painter(list, state.camera, window_of(state), current ? 1.0f : 0.35f);
    draw_picture(painter, state, scene, colours);
    if (current) painter.outline(state.placement->vertices, colours.object_outline, 2);
  }
  const Painter painter(list, state.camera, window_of(state));
  if (!current) draw_refused(painter, state, colours);
  draw_marks(painter, state, scene, layout, colours);
}

}  // namespace evenlift::view
