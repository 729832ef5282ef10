#include "canvas/walkthrough_figures.h"

#include <cstddef>
#include <iterator>

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

struct Brush {
  const Painter& painter;
  const CanvasView& view;
  Colour colour;
  float width;
  const Theme& theme() const { return view.theme; }
};

void draw_line(const Brush& brush, const Figure& figure) {
  const Points& p = figure.points;
  if (p.size() >= 2) brush.painter.line(p[0], p[1], brush.colour, brush.width);
}

void draw_dashes(const Brush& brush, const Figure& figure) {
  const Points& p = figure.points;
  if (p.size() >= 2) brush.painter.dashes(p[0], p[1], brush.colour, brush.width);
}

void draw_outline(const Brush& brush, const Figure& figure) {
  brush.painter.outline(figure.points, brush.colour, brush.width);
}

// In its outline's colour, but light enough to show what is below.
template <int percent>
void draw_light_area(const Brush& brush, const Figure& figure) {
  draw_area(brush.painter, figure.points, brush.colour.at(percent / 100.0f), brush.colour,
            brush.width);
}

void draw_ring(const Brush& brush, const Figure& figure) {
  draw_ring(brush.painter, figure.points[0], brush.colour);
}

void draw_dot(const Brush& brush, const Figure& figure) {
  brush.painter.list().AddCircleFilled(brush.painter.at(figure.points[0]), brush.width,
                                       brush.colour.packed(), 20);
}

// Very many candidates are thin lines.
void draw_candidate(const Brush& brush, const Figure& figure) {
  const Placement& placement = brush.view.state.view.walkthrough.trace->placement;
  if (placement.candidates.size() <= most_dashed) return draw_dashes(brush, figure);
  Brush thin = brush;
  thin.width = 1;
  draw_line(thin, figure);
}

void draw_triangle(const Brush& brush, const Figure& figure) {
  const Theme& t = brush.theme();
  draw_area(brush.painter, figure.points,
            (figure.value < 0 ? t.clockwise_line : t.accent).at(0.10f), t.accent.at(0.6f),
            brush.width);
}

void draw_gain(const Brush& brush, const Figure& figure) {
  const std::vector<Points>& holes = brush.view.scene.holes;
  const Colour line = brush.theme().hull_outline;
  if (holes.empty())
    return draw_area(brush.painter, figure.points, brush.colour, line, brush.width);
  // A part of an object with holes touches itself, so it is filled by rows.
  if (figure.kind == FigureKind::gain_part)
    return brush.painter.fill(brush.painter.rows(figure.points), brush.colour);
  brush.painter.fill_around(holes, figure.points, brush.colour);
  brush.painter.outline(figure.points, line, brush.width);
}

void draw_circle_gained(const Brush& brush, const Figure& figure) {
  const auto radius = static_cast<float>(figure.value * brush.view.camera.scale);
  const ImVec2 middle = brush.painter.at(figure.points[0]);
  brush.painter.list().AddCircleFilled(middle, radius, brush.theme().hull.packed(), 64);
  brush.painter.list().AddCircle(middle, radius, brush.colour.packed(), 64, brush.width);
}

// A polygon, or a segment after the first team.
void draw_base_line(const Brush& brush, const Figure& figure) {
  const Points& base = figure.points;
  if (base.size() >= 2) brush.painter.outline(base, brush.colour, brush.width, base.size() > 2);
}

void draw_base(const Brush& brush, const Figure& figure) {
  if (figure.points.size() >= 3)
    brush.painter.fill_around(brush.view.scene.holes, figure.points, brush.theme().hull);
  draw_base_line(brush, figure);
}

void draw_free_turns(const Brush& brush, const Figure& figure) {
  const bool clockwise = figure.kind == FigureKind::clockwise;
  brush.painter.region(figure.points, clockwise ? brush.theme().clockwise : brush.theme().counter,
                       brush.colour, clockwise);
}

// An arrow that ends `before_end` pixels early, to spare what is drawn there.
void draw_way(const Brush& brush, const Points& p, double before_end) {
  const Vec2 tail = brush.view.camera.to_screen(p[0]),
             way = brush.view.camera.to_screen(p[1]) - tail;
  const double length_shown = length(way) - before_end;
  if (length_shown > 0)
    brush.painter.arrow(tail, tail + way / length(way) * length_shown, brush.colour, brush.width);
}

void draw_way(const Brush& brush, const Figure& figure) { draw_way(brush, figure.points, 15); }

// From C in a direction in which the object can slide.
void draw_slide(const Brush& brush, const Figure& figure) {
  if (figure.points.size() < 2) return;
  constexpr double arrow_length = 62;  // pixels
  const Vec2 tail = brush.view.camera.to_screen(figure.points[0]),
             way = brush.view.camera.to_screen(figure.points[1]) - tail;
  if (length(way) > 0)
    brush.painter.arrow(tail, tail + way / length(way) * arrow_length, brush.colour, brush.width);
}

// From C to a robot: an arrow if the step is about the arms, else a thin line.
void draw_arm(const Brush& brush, const Figure& figure) {
  const Points& p = figure.points;
  if (brush.view.state.view.walkthrough.detail.step.kind == StepKind::many)
    draw_way(brush, p, 13);
  else
    brush.painter.line(p[0], p[1], brush.colour, 1);
}

// The arms end to end, each with an arrowhead.
void draw_sum(const Brush& brush, const Figure& figure) {
  const Points& p = figure.points;
  for (std::size_t i = 0; i < p.size(); ++i)
    brush.painter.arrow(brush.view.camera.to_screen(p[i]),
                        brush.view.camera.to_screen(p[i + 1 == p.size() ? 0 : i + 1]), brush.colour,
                        brush.width);
}

void draw_middle(const Brush& brush, const Figure& figure) {
  draw_middle(brush.painter, brush.view, figure.points[0]);
}

// Amber if the robot does not fit.
Brush for_robot(const Brush& brush, const Figure& figure) {
  Brush own = brush;
  if (figure.item) own.colour = brush.theme().amber;
  return own;
}

void draw_hand(const Brush& brush, const Figure& figure) {
  draw_light_area<30>(for_robot(brush, figure), figure);
}

void draw_body(const Brush& brush, const Figure& figure) {
  const Colour colour = for_robot(brush, figure).colour;
  const auto radius = static_cast<float>(figure.value * brush.view.camera.scale);
  const ImVec2 middle = brush.painter.at(figure.points[0]);
  brush.painter.list().AddCircleFilled(middle, radius, colour.at(0.2f).packed(), 64);
  brush.painter.list().AddCircle(middle, radius, colour.packed(), 64, brush.width);
}

// Drawn with the rest of the picture.
void draw_elsewhere(const Brush&, const Figure&) {}

struct Look {
  FigureKind kind;
  void (*draw)(const Brush& brush, const Figure& figure);
  Colour Theme::*colour;
  float width = 1;
  float opacity = 1;
};

// clang-format off
constexpr Look looks[] = {
    {FigureKind::object,           draw_outline,        &Theme::accent, 3},
    {FigureKind::triangle,         draw_triangle,       &Theme::accent, 1},
    {FigureKind::centroid,         draw_ring,           &Theme::accent},
    {FigureKind::centre,           draw_ring,           &Theme::accent},
    {FigureKind::vertex,           draw_ring,           &Theme::accent},
    {FigureKind::radial_edge,      draw_line,           &Theme::amber, 5},
    {FigureKind::ray,              draw_dashes,         &Theme::accent, 2},
    {FigureKind::chord,            draw_line,           &Theme::accent, 2},
    {FigureKind::edge,             draw_line,           &Theme::text, 3, 0.55f},
    {FigureKind::section,          draw_line,           &Theme::accent, 7},
    {FigureKind::reflected,        draw_dashes,         &Theme::clockwise_line, 3},
    {FigureKind::section_end,      draw_line,           &Theme::chord, 2},
    {FigureKind::bisecting,        draw_dashes,         &Theme::hull_outline, 2},
    {FigureKind::chosen,           draw_line,           &Theme::hull_outline, 4},
    {FigureKind::candidate,        draw_candidate,      &Theme::chord, 1.6f},
    {FigureKind::team,             draw_line,           &Theme::chord, 2.5f},
    {FigureKind::robot,            draw_elsewhere,      &Theme::robot},
    {FigureKind::gain_triangle,    draw_gain,           &Theme::hull, 1.5f, 0.5f},
    {FigureKind::gain_part,        draw_gain,           &Theme::hull, 0},
    {FigureKind::gain_circle,      draw_circle_gained,  &Theme::hull_outline, 2},
    {FigureKind::arm_before,       draw_dashes,         &Theme::quiet, 1.5f},
    {FigureKind::arm_after,        draw_line,           &Theme::hull_outline, 1.5f},
    {FigureKind::base_before,      draw_base_line,      &Theme::hull_outline, 2, 0.6f},
    {FigureKind::base,             draw_base,           &Theme::hull_outline, 3},
    {FigureKind::contact,          draw_dot,            &Theme::amber, 5},
    {FigureKind::normal,           draw_line,           &Theme::amber, 1.5f, 0.8f},
    {FigureKind::clockwise,        draw_free_turns,     &Theme::clockwise_line},
    {FigureKind::counterclockwise, draw_free_turns,     &Theme::counter_line},
    {FigureKind::translation,      draw_slide,          &Theme::amber_on_object, 3},
    {FigureKind::lever,            draw_line,           &Theme::hull_outline, 4},
    {FigureKind::side,             draw_dashes,         &Theme::chord, 2},
    {FigureKind::arm,              draw_arm,            &Theme::chord, 2},
    {FigureKind::sum,              draw_sum,            &Theme::accent_on_object, 2.5f},
    {FigureKind::middle,           draw_middle,         &Theme::accent_on_object},
    {FigureKind::stand,            draw_ring,           &Theme::amber_on_object},
    {FigureKind::mirrored,         draw_light_area<8>,  &Theme::clockwise_line, 2},
    {FigureKind::even_chord,       draw_dashes,         &Theme::chord, 1.6f},
    {FigureKind::left,             draw_elsewhere,      &Theme::quiet},
    {FigureKind::way,              draw_way,            &Theme::amber_on_object, 2.5f},
    {FigureKind::range,            draw_light_area<14>, &Theme::accent, 0},
    {FigureKind::range_end,        draw_line,           &Theme::chord, 2},
    {FigureKind::former,           draw_dashes,         &Theme::quiet, 2},
    {FigureKind::unusable,         draw_elsewhere,      &Theme::amber},
    {FigureKind::body,             draw_body,           &Theme::robot, 1.5f},
    {FigureKind::hand,             draw_hand,           &Theme::robot, 1.5f},
    {FigureKind::share,            draw_light_area<12>, &Theme::accent, 1.5f},
    {FigureKind::level,            draw_dashes,         &Theme::chord, 1.2f},
    {FigureKind::sinks,            draw_way,            &Theme::amber_on_object, 3},
    {FigureKind::hole,             draw_outline,        &Theme::accent, 3},
    {FigureKind::hole_part,        draw_triangle,       &Theme::accent, 1},
    {FigureKind::cargo,            draw_ring,           &Theme::amber_on_object},
    {FigureKind::old_centre,       draw_ring,           &Theme::quiet},
};
// clang-format on

// Each kind's row is at its number.
constexpr bool in_order() {
  for (std::size_t i = 0; i < std::size(looks); ++i)
    if (looks[i].kind != static_cast<FigureKind>(i)) return false;
  return std::size(looks) == figure_kind_count;
}
static_assert(in_order());

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
  if (figure.points.empty()) return;
  const Look& look = looks[static_cast<std::size_t>(figure.kind)];
  const Colour colour = (view.theme.*look.colour).at(look.opacity);
  look.draw({painter, view, colour, look.width}, figure);
}

}  // namespace evenlift::view
