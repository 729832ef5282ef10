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

void draw_mark(const Painter& painter, const CanvasView& view, const Object& mark) {
  const Theme& t = view.theme;
  const LessonState& lesson = view.state.lesson;
  const Points& p = mark.points;
  if (p.empty()) return;
  const auto line = [&](Colour colour, float width) {
    if (p.size() >= 2) painter.line(p[0], p[1], colour, width);
  };
  const auto dashes = [&](Colour colour, float width) {
    if (p.size() >= 2) painter.dashes(p[0], p[1], colour, width);
  };
  switch (mark.mark) {
    case Mark::object:
      return painter.outline(p, t.accent, 3);
    case Mark::triangle:
      return draw_area(painter, p, (mark.value < 0 ? t.clockwise_line : t.accent).at(0.10f),
                       t.accent.at(0.6f), 1);
    case Mark::centroid:
    case Mark::centre:
    case Mark::vertex:
      return draw_ring(painter, p[0], t.accent);
    case Mark::contact:
      painter.list().AddCircleFilled(painter.at(p[0]), 5, t.amber.packed(), 20);
      return;
    case Mark::radial_edge:
      return line(t.amber, 5);
    case Mark::ray:
      return dashes(t.accent, 2);
    case Mark::chord:
      return line(t.accent, 2);
    case Mark::edge:
      return line(t.text.at(0.55f), 3);
    case Mark::section:
      return line(t.accent, 7);
    case Mark::reflected:
      return dashes(t.clockwise_line, 3);
    case Mark::section_end:
      return line(t.chord, 2);
    case Mark::bisecting:
      return dashes(t.hull_outline, 2);
    case Mark::chosen:
      return line(t.hull_outline, 4);
    case Mark::candidate:
      return lesson.trace->placement.candidates.size() <= most_dashed ? dashes(t.chord, 1.6f)
                                                                      : line(t.chord, 1);
    case Mark::team:
      return line(t.chord, 2.5f);
    case Mark::robot:
      return;  // with all the others
    case Mark::gain_triangle:
      return draw_area(painter, p, t.hull.at(0.5f), t.hull_outline, 1.5f);
    case Mark::gain_part:
      return draw_area(painter, p, t.hull, t.hull_outline, 0);
    case Mark::gain_circle: {
      const auto radius = static_cast<float>(mark.value * view.camera.scale);
      painter.list().AddCircleFilled(painter.at(p[0]), radius, t.hull.packed(), 64);
      painter.list().AddCircle(painter.at(p[0]), radius, t.hull_outline.packed(), 64, 2);
      return;
    }
    case Mark::arm_before:
      return dashes(t.quiet, 1.5f);
    case Mark::arm_after:
      return line(t.hull_outline, 1.5f);
    case Mark::base_before:
      if (p.size() >= 2) painter.outline(p, t.hull_outline.at(0.6f), 2, p.size() > 2);
      return;
    case Mark::base:
      if (p.size() >= 3) painter.fill_convex(p, t.hull);
      if (p.size() >= 2) painter.outline(p, t.hull_outline, 3, p.size() > 2);
      return;
    case Mark::normal:
      return line(t.amber.at(0.8f), 1.5f);
    case Mark::clockwise:
      return draw_region(painter, p, t.clockwise, t.clockwise_line, true);
    case Mark::counterclockwise:
      return draw_region(painter, p, t.counter, t.counter_line, false);
    case Mark::translation:
      if (p.size() >= 2) draw_arrow(painter, view, p[0], p[1], t.amber);
      return;
  }
}

// A ratio at the middle of its chord's longer arm.
void draw_value(const Painter& painter, const CanvasView& view, const Object& mark) {
  const Vec2 middle = mark.points[0] + (mark.points[1] - mark.points[0]) * 0.75;
  const std::string text = ratio_in_words(mark.value);
  const ImVec2 size = text_size(Face::strong_label, text), at = painter.at(middle);
  const ImVec2 low(at.x - size.x / 2 - 5, at.y - size.y / 2 - 2);
  painter.list().AddRectFilled(low, ImVec2(low.x + size.x + 10, low.y + size.y + 4),
                               view.theme.panel.at(0.9f).packed(), 5);
  draw_text(painter.list(), Face::strong_label, ImVec2(low.x + 5, low.y + 2), view.theme.text,
            text);
}

void draw_values(const Painter& painter, const CanvasView& view) {
  const LessonState& lesson = view.state.lesson;
  std::vector<const Object*> valued;
  for (const Object& mark : lesson.marks) {
    const bool has =
        mark.mark == Mark::section_end || mark.mark == Mark::chosen || mark.mark == Mark::chord;
    if (has && mark.points.size() == 2) valued.push_back(&mark);
  }
  if (valued.size() > most_valued) return;
  for (const Object* mark : valued) draw_value(painter, view, *mark);
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
  for (const Object& mark : lesson.gained) draw_mark(painter, view, mark);
  for (const Object& mark : lesson.marks) draw_mark(painter, view, mark);
  if (lesson.hovered && *lesson.hovered < lesson.marks.size()) {
    const Object& mark = lesson.marks[*lesson.hovered];
    if (mark.points.size() == 2) painter.line(mark.points[0], mark.points[1], view.theme.accent, 4);
    if (mark.points.size() == 1) draw_ring(painter, mark.points[0], view.theme.accent);
  }
  if (lesson.asked) draw_chord(painter, *lesson.asked, view.theme.amber, 4);
  draw_values(painter, view);
  draw_choices(painter, view);
}

}  // namespace evenlift::view
