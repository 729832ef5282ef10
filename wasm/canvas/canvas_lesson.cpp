#include "canvas/canvas_lesson.h"

#include <algorithm>
#include <string>

#include "canvas/canvas_drawing.h"
#include "canvas/canvas_marks.h"
#include "canvas/triangulate.h"
#include "evenlift/output/words.h"
#include "ui/icons.h"
#include "walkthrough/walkthrough.h"

namespace evenlift::view {
namespace {

constexpr std::size_t most_dashed = 300;
constexpr std::size_t most_valued = 12;  // more numbers than that would hide the drawing

void draw_chord(const Painter& painter, const Chord& chord, Colour colour, float width) {
  painter.line(chord.r1.position, chord.r2.position, colour, width);
}

bool knows_candidate(const LessonState& lesson, std::size_t c) {
  return lesson.known.merged || lesson.trace->first_source_of_candidate[c] < lesson.known.sources;
}

// Chords of the rays so far, until they have become candidates.
void draw_rays(const Painter& painter, const CanvasView& view) {
  const LessonState& lesson = view.state.lesson;
  if (lesson.known.merged || lesson.known.rays == 0) return;
  const Trace::Rays& rays = lesson.trace->rays;
  const std::uint32_t end = rays.begins[lesson.known.rays];
  const Colour colour = view.theme.chord.at(end <= most_dashed ? 0.45f : 0.2f);
  for (std::uint32_t i = 0; i < end; ++i) draw_chord(painter, rays.chords[i].chord, colour, 1);
}

void draw_candidates(const Painter& painter, const CanvasView& view) {
  const LessonState& lesson = view.state.lesson;
  const auto& candidates = lesson.trace->placement.candidates;
  const Chapter chapter = lesson.detail.step.chapter;
  if (chapter == Chapter::loads || chapter == Chapter::grasp || !lesson.trace->by_candidates())
    return;
  const bool dash = candidates.size() <= most_dashed;
  for (std::size_t c = 0; c < candidates.size(); ++c) {
    if (!knows_candidate(lesson, c)) continue;
    const Chord& chord = candidates[c].chord;
    if (dash)
      painter.dashes(chord.r1.position, chord.r2.position, view.theme.candidate, 1.2f);
    else
      draw_chord(painter, chord, view.theme.candidate.at(0.5f), 1);
  }
}

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

void draw_region(const Painter& painter, const Points& points, Colour fill, Colour line,
                 bool rising) {
  if (points.size() == 1) {
    painter.list().AddCircle(painter.at(points[0]), 6, line.packed(), 24, 2);
  } else if (points.size() == 2) {
    painter.line(points[0], points[1], line, 3);
  } else {
    painter.fill_convex(points, fill);
    painter.hatch_convex(points, rising, line.at(0.55f));
    painter.outline(points, line.at(0.7f), 1.2f);
  }
}

void draw_ring(const Painter& painter, const Vec2& at, Colour colour) {
  painter.list().AddCircleFilled(painter.at(at), 14, colour.at(0.2f).packed(), 32);
  painter.list().AddCircle(painter.at(at), 8, colour.packed(), 32, 2.5f);
}

// From the centre of mass along a direction that stays free.
void draw_arrow(const Painter& painter, const CanvasView& view, const Vec2& from, const Vec2& to,
                Colour colour) {
  const Vec2 tail = view.camera.to_screen(from), tip = view.camera.to_screen(to);
  const double far = length(tip - tail);
  if (!(far > 0)) return;
  const Vec2 along = (tip - tail) / far, aside(-along.y(), along.x()), head = tail + along * 62;
  const auto at = [](const Vec2& p) {
    return ImVec2(static_cast<float>(p.x()), static_cast<float>(p.y()));
  };
  painter.list().AddLine(at(tail), at(head), colour.packed(), 3);
  const ImVec2 barbs[] = {at(head - along * 11 + aside * 8), at(head),
                          at(head - along * 11 - aside * 8)};
  painter.list().AddPolyline(barbs, 3, colour.packed(), 0, 3);
}

void draw_figure(const Painter& painter, const CanvasView& view, const Figure& figure) {
  const Theme& t = view.theme;
  const LessonState& lesson = view.state.lesson;
  const Points& p = figure.points;
  if (p.empty()) return;
  const auto line = [&](Colour colour, float width) {
    if (p.size() >= 2) painter.line(p[0], p[1], colour, width);
  };
  const auto dashes = [&](Colour colour, float width) {
    if (p.size() >= 2) painter.dashes(p[0], p[1], colour, width);
  };
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
      painter.list().AddCircleFilled(painter.at(p[0]), 5, t.amber.packed(), 20);
      return;
    case FigureKind::radial_edge:
      return line(t.amber, 5);
    case FigureKind::ray:
      return dashes(t.accent, 2);
    case FigureKind::chord:
      return line(t.accent, 2);
    case FigureKind::edge:
      return line(t.text.at(0.55f), 3);
    case FigureKind::section:
      return line(t.accent, 7);
    case FigureKind::reflected:
      return dashes(t.clockwise_line, 3);
    case FigureKind::section_end:
      return line(t.chord, 2);
    case FigureKind::bisecting:
      return dashes(t.hull_outline, 2);
    case FigureKind::chosen:
      return line(t.hull_outline, 4);
    case FigureKind::candidate:
      return lesson.trace->placement.candidates.size() <= most_dashed ? dashes(t.chord, 1.6f)
                                                                      : line(t.chord, 1);
    case FigureKind::team:
      return line(t.chord, 2.5f);
    case FigureKind::robot:
      return;  // with all the others
    case FigureKind::gain_triangle:
      return draw_area(painter, p, t.hull.at(0.5f), t.hull_outline, 1.5f);
    case FigureKind::gain_part:
      return draw_area(painter, p, t.hull, t.hull_outline, 0);
    case FigureKind::gain_circle: {
      const auto radius = static_cast<float>(figure.value * view.camera.scale);
      painter.list().AddCircleFilled(painter.at(p[0]), radius, t.hull.packed(), 64);
      painter.list().AddCircle(painter.at(p[0]), radius, t.hull_outline.packed(), 64, 2);
      return;
    }
    case FigureKind::arm_before:
      return dashes(t.quiet, 1.5f);
    case FigureKind::arm_after:
      return line(t.hull_outline, 1.5f);
    case FigureKind::base_before:
      if (p.size() >= 2) painter.outline(p, t.hull_outline.at(0.6f), 2, p.size() > 2);
      return;
    case FigureKind::base:
      if (p.size() >= 3) painter.fill_convex(p, t.hull);
      if (p.size() >= 2) painter.outline(p, t.hull_outline, 3, p.size() > 2);
      return;
    case FigureKind::normal:
      return line(t.amber.at(0.8f), 1.5f);
    case FigureKind::clockwise:
      return draw_region(painter, p, t.clockwise, t.clockwise_line, true);
    case FigureKind::counterclockwise:
      return draw_region(painter, p, t.counter, t.counter_line, false);
    case FigureKind::translation:
      if (p.size() >= 2) draw_arrow(painter, view, p[0], p[1], t.amber);
      return;
  }
}

// A ratio at the middle of its chord's longer arm.
void draw_value(const Painter& painter, const CanvasView& view, const Figure& figure) {
  const Vec2 middle = figure.points[0] + (figure.points[1] - figure.points[0]) * 0.75;
  const std::string text = ratio_in_words(figure.value);
  const ImVec2 size = text_size(Face::strong_label, text), at = painter.at(middle);
  const ImVec2 low(at.x - size.x / 2 - 5, at.y - size.y / 2 - 2);
  painter.list().AddRectFilled(low, ImVec2(low.x + size.x + 10, low.y + size.y + 4),
                               view.theme.panel.at(0.9f).packed(), 5);
  draw_text(painter.list(), Face::strong_label, ImVec2(low.x + 5, low.y + 2), view.theme.text,
            text);
}

void draw_values(const Painter& painter, const CanvasView& view) {
  const LessonState& lesson = view.state.lesson;
  std::vector<const Figure*> valued;
  for (const Figure& figure : lesson.figures) {
    const bool has = figure.kind == FigureKind::section_end || figure.kind == FigureKind::chosen ||
                     figure.kind == FigureKind::chord;
    if (has && figure.points.size() == 2) valued.push_back(&figure);
  }
  if (valued.size() > most_valued) return;
  for (const Figure* figure : valued) draw_value(painter, view, *figure);
}

// The choices that a question is about, the one pointed at stronger.
void draw_choices(const Painter& painter, const CanvasView& view) {
  const std::optional<Ask>& ask = view.state.lesson.ask;
  if (!ask) return;
  for (std::size_t i = 0; i < ask->choices.size(); ++i) {
    const std::uint32_t choice = ask->choices[i];
    const bool pointed = ask->choices.size() > 3 && i == ask->pointed;
    const Chord& chord = ask->question.kind == QuestionKind::nearer_end
                             ? ask->detail.pair->ends[choice]
                             : view.state.lesson.trace->placement.candidates[choice].chord;
    draw_chord(painter, chord, view.theme.accent.at(pointed ? 1 : 0.45f), pointed ? 4.0f : 2.5f);
    if (ask->choices.size() > most_valued) continue;
    const ImVec2 at = painter.at(chord.r2.position);
    const bool end = ask->question.kind == QuestionKind::nearer_end;
    const std::string name = !end ? std::to_string(choice + 1) : choice == 0 ? "first" : "second";
    draw_text(painter.list(), Face::strong_label, ImVec2(at.x + 8, at.y - 8), view.theme.accent,
              name);
  }
}

}  // namespace

void draw_lesson(const Painter& painter, const CanvasView& view) {
  const LessonState& lesson = view.state.lesson;
  const Placement& placement = lesson.trace->placement;
  painter.fill(placement.vertices, view.scene.triangles, view.theme.object);
  if (lesson.base.size() >= 3) painter.fill_convex(lesson.base, view.theme.hull);
  painter.outline(placement.vertices, view.theme.object_outline, 2);
  if (lesson.base.size() >= 2)
    painter.outline(lesson.base, view.theme.hull_outline, 2, lesson.base.size() > 2);
  draw_rays(painter, view);
  draw_candidates(painter, view);
  for (std::uint32_t i = 0; i < lesson.known.teams; ++i)
    draw_chord(painter, placement.teams[i].chord, view.theme.chord, 2);
  for (const Figure& figure : lesson.gained) draw_figure(painter, view, figure);
  for (const Figure& figure : lesson.figures) draw_figure(painter, view, figure);
  if (lesson.hovered && *lesson.hovered < lesson.figures.size()) {
    const Figure& figure = lesson.figures[*lesson.hovered];
    if (figure.points.size() == 2)
      painter.line(figure.points[0], figure.points[1], view.theme.accent, 4);
    if (figure.points.size() == 1) draw_ring(painter, figure.points[0], view.theme.accent);
  }
  if (lesson.asked) draw_chord(painter, *lesson.asked, view.theme.amber, 4);
  draw_values(painter, view);
  draw_choices(painter, view);
}

}  // namespace evenlift::view
