#include "canvas/walkthrough_figures.h"

#include <optional>

#include "picture/triangulate.h"

namespace evenlift::view {
namespace {

void draw_area(const Painter& painter, const Points& points, Colour fill, Colour line,
               float width) {
  if (points.size() == 2) return painter.line(points[0], points[1], line, width + 1);
  if (points.size() < 3) return;
  if (points.size() > most_triangulated)
    painter.fill(painter.rows(points), fill);
  else
    painter.fill(points, triangulate(points), fill);
  if (width > 0) painter.outline(points, line, width);
}

// An arrow from the centre of mass in a direction in which the object can slide.
void draw_arrow(const Painter& painter, const CanvasView& view, const Vec2& from, const Vec2& to) {
  constexpr double arrow_length = 62;  // pixels
  const Vec2 tail = view.camera.to_screen(from), way = view.camera.to_screen(to) - tail;
  if (length(way) > 0)
    painter.arrow(tail, tail + way / length(way) * arrow_length, view.theme.amber_on_object, 3);
}

// How a figure that is a segment is drawn.
struct Stroke {
  Colour colour;
  float width;
  bool dashed = false;
};

// The stroke of a figure of this kind; nothing if it is not a segment. `count` is the number of
// candidates.
std::optional<Stroke> stroke_of(FigureKind kind, const Theme& t, std::size_t count) {
  constexpr bool dashed = true;
  switch (kind) {
    case FigureKind::radial_edge:
      return Stroke{t.amber, 5};
    case FigureKind::ray:
      return Stroke{t.accent, 2, dashed};
    case FigureKind::chord:
      return Stroke{t.accent, 2};
    case FigureKind::edge:
      return Stroke{t.text.at(0.55f), 3};
    case FigureKind::section:
      return Stroke{t.accent, 7};
    case FigureKind::reflected:
      return Stroke{t.clockwise_line, 3, dashed};
    case FigureKind::section_end:
    case FigureKind::range_end:
      return Stroke{t.chord, 2};
    case FigureKind::former:
      return Stroke{t.quiet, 2, dashed};
    case FigureKind::bisecting:
      return Stroke{t.hull_outline, 2, dashed};
    case FigureKind::chosen:
      return Stroke{t.hull_outline, 4};
    case FigureKind::candidate:
      return count <= most_dashed ? Stroke{t.chord, 1.6f, dashed} : Stroke{t.chord, 1};
    case FigureKind::team:
      return Stroke{t.chord, 2.5f};
    case FigureKind::arm_before:
      return Stroke{t.quiet, 1.5f, dashed};
    case FigureKind::arm_after:
      return Stroke{t.hull_outline, 1.5f};
    case FigureKind::normal:
      return Stroke{t.amber.at(0.8f), 1.5f};
    case FigureKind::lever:
      return Stroke{t.hull_outline, 4};
    case FigureKind::side:
      return Stroke{t.chord, 2, dashed};
    case FigureKind::even_chord:
      return Stroke{t.chord, 1.6f, dashed};
    case FigureKind::object:
    case FigureKind::triangle:
    case FigureKind::centroid:
    case FigureKind::centre:
    case FigureKind::vertex:
    case FigureKind::contact:
    case FigureKind::robot:
    case FigureKind::gain_triangle:
    case FigureKind::gain_part:
    case FigureKind::gain_circle:
    case FigureKind::base_before:
    case FigureKind::base:
    case FigureKind::clockwise:
    case FigureKind::counterclockwise:
    case FigureKind::translation:
    case FigureKind::arm:
    case FigureKind::sum:
    case FigureKind::middle:
    case FigureKind::stand:
    case FigureKind::mirrored:
    case FigureKind::left:
    case FigureKind::way:
    case FigureKind::range:
    case FigureKind::unusable:
    case FigureKind::body:
    case FigureKind::hand:
      break;
  }
  return std::nullopt;
}

void draw_circle_gained(const Painter& painter, const CanvasView& view, const Figure& figure) {
  const auto radius = static_cast<float>(figure.value * view.camera.scale);
  const ImVec2 middle = painter.at(figure.points[0]);
  painter.list().AddCircleFilled(middle, radius, view.theme.hull.packed(), 64);
  painter.list().AddCircle(middle, radius, view.theme.hull_outline.packed(), 64, 2);
}

// The lifting base before or after a team: a polygon, or a segment after the first team.
void draw_base(const Painter& painter, const Points& base, Colour fill, Colour line, float width) {
  if (base.size() >= 3 && fill.opacity > 0) painter.fill_convex(base, fill);
  if (base.size() >= 2) painter.outline(base, line, width, base.size() > 2);
}

// From C to a robot: an arrow where the arms are what the step is about, otherwise a thin line.
void draw_arm(const Painter& painter, const CanvasView& view, const Points& p) {
  if (view.state.view.walkthrough.detail.step.kind != StepKind::many)
    return painter.line(p[0], p[1], view.theme.chord, 1);
  constexpr double before_robot = 13;  // pixels
  const Vec2 tail = view.camera.to_screen(p[0]), way = view.camera.to_screen(p[1]) - tail;
  const double length_shown = length(way) - before_robot;
  if (length_shown > 0)
    painter.arrow(tail, tail + way / length(way) * length_shown, view.theme.chord, 2);
}

// The arms laid end to end, each with its head.
void draw_sum(const Painter& painter, const CanvasView& view, const Points& p) {
  for (std::size_t i = 0; i < p.size(); ++i)
    painter.arrow(view.camera.to_screen(p[i]),
                  view.camera.to_screen(p[i + 1 == p.size() ? 0 : i + 1]),
                  view.theme.accent_on_object, 2.5f);
}

// A robot's way, which ends before the robot that is drawn over its end.
void draw_way(const Painter& painter, const CanvasView& view, const Points& p) {
  constexpr double before_robot = 15;  // pixels
  const Vec2 tail = view.camera.to_screen(p[0]), way = view.camera.to_screen(p[1]) - tail;
  const double length_shown = length(way) - before_robot;
  if (length_shown > 0)
    painter.arrow(tail, tail + way / length(way) * length_shown, view.theme.amber_on_object, 2.5f);
}

// A robot that fits, or that does not.
void draw_robot_shape(const Painter& painter, const CanvasView& view, const Figure& figure) {
  const Colour colour = figure.item ? view.theme.amber : view.theme.robot;
  if (figure.kind == FigureKind::hand)
    return draw_area(painter, figure.points, colour.at(0.3f), colour, 1.5f);
  const auto radius = static_cast<float>(figure.value * view.camera.scale);
  const ImVec2 middle = painter.at(figure.points[0]);
  painter.list().AddCircleFilled(middle, radius, colour.at(0.2f).packed(), 64);
  painter.list().AddCircle(middle, radius, colour.packed(), 64, 1.5f);
}

// A figure that is not a segment.
void draw_shape(const Painter& painter, const CanvasView& view, const Figure& figure) {
  const Theme& t = view.theme;
  const Points& p = figure.points;
  switch (figure.kind) {
    case FigureKind::object:
      return painter.outline(p, t.accent, 3);
    case FigureKind::triangle:
      return draw_area(painter, p, (figure.value < 0 ? t.clockwise_line : t.accent).at(0.10f),
                       t.accent.at(0.6f), 1);
    case FigureKind::centroid:
    case FigureKind::centre:
    case FigureKind::vertex:
      return draw_ring(painter, p[0], t.accent);
    case FigureKind::contact:
      return painter.list().AddCircleFilled(painter.at(p[0]), 5, t.amber.packed(), 20);
    case FigureKind::gain_triangle:
      return draw_area(painter, p, t.hull.at(0.5f), t.hull_outline, 1.5f);
    case FigureKind::gain_part:
      return draw_area(painter, p, t.hull, t.hull_outline, 0);
    case FigureKind::range:
      return draw_area(painter, p, t.accent.at(0.14f), t.accent, 0);
    case FigureKind::gain_circle:
      return draw_circle_gained(painter, view, figure);
    case FigureKind::body:
    case FigureKind::hand:
      return draw_robot_shape(painter, view, figure);
    case FigureKind::base_before:
      return draw_base(painter, p, t.hull.at(0), t.hull_outline.at(0.6f), 2);
    case FigureKind::base:
      return draw_base(painter, p, t.hull, t.hull_outline, 3);
    case FigureKind::clockwise:
      return painter.region(p, t.clockwise, t.clockwise_line, true);
    case FigureKind::counterclockwise:
      return painter.region(p, t.counter, t.counter_line, false);
    case FigureKind::translation:
      if (p.size() >= 2) draw_arrow(painter, view, p[0], p[1]);
      return;
    case FigureKind::arm:
      return draw_arm(painter, view, p);
    case FigureKind::sum:
      return draw_sum(painter, view, p);
    case FigureKind::middle:
      return draw_middle(painter, view, p[0]);
    case FigureKind::stand:
      return draw_ring(painter, p[0], t.amber_on_object);
    case FigureKind::mirrored:
      return draw_area(painter, p, t.clockwise_line.at(0.08f), t.clockwise_line, 2);
    case FigureKind::way:
      return draw_way(painter, view, p);
    // These are drawn with all that is known.
    case FigureKind::robot:
    case FigureKind::left:
    case FigureKind::unusable:
    // These are segments (stroke_of).
    case FigureKind::radial_edge:
    case FigureKind::ray:
    case FigureKind::chord:
    case FigureKind::edge:
    case FigureKind::section:
    case FigureKind::reflected:
    case FigureKind::section_end:
    case FigureKind::bisecting:
    case FigureKind::chosen:
    case FigureKind::candidate:
    case FigureKind::team:
    case FigureKind::arm_before:
    case FigureKind::arm_after:
    case FigureKind::normal:
    case FigureKind::lever:
    case FigureKind::side:
    case FigureKind::even_chord:
    case FigureKind::range_end:
    case FigureKind::former:
      break;
  }
}

}  // namespace

void draw_ring(const Painter& painter, const Vec2& at, Colour colour) {
  painter.list().AddCircleFilled(painter.at(at), 14, colour.at(0.2f).packed(), 32);
  painter.list().AddCircle(painter.at(at), 8, colour.packed(), 32, 2.5f);
}

void draw_middle(const Painter& painter, const CanvasView& view, const Vec2& world) {
  const ImVec2 at = painter.at(world), text = text_size(Face::strong_label, "M");
  painter.list().AddCircleFilled(at, 6, view.theme.object.packed(), 24);
  painter.list().AddCircle(at, 5, view.theme.accent_on_object.packed(), 24, 2);
  painter.list().AddCircleFilled(at, 2, view.theme.accent_on_object.packed(), 12);
  draw_text(painter.list(), Face::strong_label, ImVec2(at.x + 9, at.y - text.y - 1),
            view.theme.accent_on_object, "M");
}

void draw_figure(const Painter& painter, const CanvasView& view, const Figure& figure) {
  const Points& p = figure.points;
  if (p.empty()) return;
  const std::size_t candidates = view.state.view.walkthrough.trace->placement.candidates.size();
  const std::optional<Stroke> stroke = stroke_of(figure.kind, view.theme, candidates);
  if (!stroke) return draw_shape(painter, view, figure);
  if (p.size() < 2) return;
  if (stroke->dashed)
    painter.dashes(p[0], p[1], stroke->colour, stroke->width);
  else
    painter.line(p[0], p[1], stroke->colour, stroke->width);
}

}  // namespace evenlift::view
