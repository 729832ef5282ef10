#include "canvas/canvas.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "evenlift/output/words.h"
#include "marks/marks.h"
#include "picture/triangulate.h"
#include "ui/theme.h"
#include "walkthrough/walkthrough.h"

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

namespace {

constexpr std::size_t most_valued = 12;  // more numbers would hide the drawing

void draw_chord(const Painter& painter, const Chord& chord, Colour colour, float width) {
  painter.line(chord.r1.position, chord.r2.position, colour, width);
}

bool knows_candidate(const Walkthrough& walk, std::size_t c) {
  return walk.known.merged || walk.trace->first_source_of_candidate[c] < walk.known.sources;
}

// The chords of the rays so far, until they become candidates.
void draw_rays(const Painter& painter, const CanvasView& view) {
  const Walkthrough& walk = view.state.view.walkthrough;
  if (walk.known.merged || walk.known.rays == 0) return;
  const Trace::Rays& rays = walk.trace->rays;
  const std::uint32_t end = rays.begins[walk.known.rays];
  const Colour colour = view.theme.chord.at(end <= most_dashed ? 0.45f : 0.2f);
  for (std::uint32_t i = 0; i < end; ++i) draw_chord(painter, rays.chords[i].chord, colour, 1);
}

void draw_candidates(const Painter& painter, const CanvasView& view) {
  const Walkthrough& walk = view.state.view.walkthrough;
  const auto& candidates = walk.trace->placement.candidates;
  const Chapter chapter = walk.detail.step.chapter;
  if (chapter == Chapter::loads || chapter == Chapter::grasp || !walk.trace->by_candidates())
    return;
  for (std::size_t c = 0; c < candidates.size(); ++c) {
    if (!knows_candidate(walk, c)) continue;
    const Chord& chord = candidates[c].chord;
    painter.candidate(chord.r1.position, chord.r2.position, view.theme.candidate,
                      candidates.size());
  }
}

// Writes a text at the first place along a chord that is clear of the texts `before`, if any.
void draw_value(const Painter& painter, const CanvasView& view, const Figure& figure,
                const std::string& text, std::vector<Rect>& before) {
  constexpr SharesOfLine off_middle = {0.75, 0.25, 0.87, 0.13, 0.63, 0.37};
  const ImVec2 size = text_size(Face::strong_label, text);
  const auto place = clear_box_on_line(view.camera.to_screen(figure.points[0]),
                                       view.camera.to_screen(figure.points[1]),
                                       Vec2(size.x + 10, size.y + 4), off_middle, before);
  if (!place) return;
  const ImVec2 low = vec(place->left, place->top);
  painter.list().AddRectFilled(low, vec(place->right, place->bottom),
                               view.theme.panel.at(0.9f).packed(), 5);
  draw_text(painter.list(), Face::strong_label, ImVec2(low.x + 5, low.y + 2), view.theme.text,
            text);
}

// A chord's load ratio, or its number among several even chords.
std::string value_of(const Figure& figure, bool balanced) {
  if (figure.points.size() != 2) return {};
  if (figure.kind == FigureKind::even_chord) return std::to_string(figure.item.value_or(0) + 1);
  const bool has = figure.kind == FigureKind::section_end || figure.kind == FigureKind::chosen ||
                   figure.kind == FigureKind::chord;
  return has && !balanced ? ratio_in_words(figure.value) : std::string();
}

void draw_values(const Painter& painter, const CanvasView& view, Occupied& occupied) {
  const Walkthrough& walk = view.state.view.walkthrough;
  if (walk.ask && walk.trace->balanced()) return;  // the choices have other numbers
  std::vector<std::pair<const Figure*, std::string>> valued;
  const auto has_value = [&](const Figure& figure) {  // the chosen end is drawn twice
    return std::any_of(valued.begin(), valued.end(), [&](const auto& before) {
      const Points& p = before.first->points;
      return p == figure.points || p == Points{figure.points[1], figure.points[0]};
    });
  };
  for (const Figure& figure : walk.figures)
    if (std::string text = value_of(figure, walk.trace->balanced());
        !text.empty() && !has_value(figure))
      valued.emplace_back(&figure, std::move(text));
  if (valued.size() > most_valued) return;
  constexpr double mark = 13;  // pixels from C to just beyond its mark's rim
  const Vec2 c = view.camera.to_screen(view.placement->centre_of_mass);
  std::vector<Rect> before = {{c.x - mark, c.y - mark, c.x + mark, c.y + mark}};
  for (const auto& [figure, text] : valued) draw_value(painter, view, *figure, text, before);
  for (const Rect& taken : before) occupied.box(taken);
}

// The step's own drawings, which names should not cover.
void add_lines_of_step(const CanvasView& view, Occupied& occupied) {
  for (const Figure& figure : view.state.view.walkthrough.figures)
    if (figure.points.size() == 2)
      occupied.line(view.camera.to_screen(figure.points[0]),
                    view.camera.to_screen(figure.points[1]));
}

// The subject of a question about even chords: the place that one robot would take, and M.
void draw_asked_completion(const Painter& painter, const CanvasView& view, const Ask& ask) {
  if (ask.question.kind != QuestionKind::even_chord) return;
  const BalancedDetail& balanced = *ask.detail.balanced;
  if (balanced.stand) draw_ring(painter, balanced.stand->position, view.theme.amber_on_object);
  draw_middle(painter, view, balanced.middle);
}

// The robots' places if one stood at the place in question.
void draw_asked_places(const Painter& painter, const CanvasView& view) {
  for (const Vec2& place : view.state.view.walkthrough.asked_places)
    draw_ring(painter, place, view.theme.amber_on_object);
}

std::string name_of_choice(const Ask& ask, std::uint32_t choice) {
  if (ask.question.kind != QuestionKind::nearer_end) return std::to_string(choice + 1);
  return choice == 0 ? "first" : "second";
}

// The choices' numbers, beyond their ends, clear of robots and of each other.
void draw_names_of_choices(const Painter& painter, const CanvasView& view, const Ask& ask,
                           double reach, Occupied& occupied) {
  const Vec2 middle = view.camera.to_screen(view.placement->centre_of_mass);
  std::vector<LabelRequest> requests;
  for (const std::uint32_t choice : ask.choices) {
    const Chord& chord =
        chord_of_choice(*view.state.view.walkthrough.trace, ask.detail, ask.question, choice);
    const Vec2 at = view.camera.to_screen(chord.r2.position), away = at - middle;
    const ImVec2 text = text_size(Face::strong_label, name_of_choice(ask, choice));
    requests.push_back({at, away / std::max(length(away), 1e-9), Vec2(text.x + 10, text.y + 4)});
  }
  if (ask.question.kind == QuestionKind::even_chord)  // it concerns M, whose name is beside it
    occupied.disc(view.camera.to_screen(ask.detail.balanced->middle), 24);
  const auto places = place_labels(requests, occupied, reach + 3, 1000);
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (!places[i]) continue;
    const ImVec2 low = vec(places[i]->left, places[i]->top),
                 high = vec(places[i]->right, places[i]->bottom);
    painter.list().AddRectFilled(low, high, view.theme.panel.at(0.9f).packed(), 5);
    draw_text(painter.list(), Face::strong_label, ImVec2(low.x + 5, low.y + 2), view.theme.accent,
              name_of_choice(ask, ask.choices[i]));
  }
}

void draw_wrong_guess(const Painter& painter, const CanvasView& view) {
  const std::optional<Answered>& answered = view.state.view.walkthrough.answered;
  if (!answered || answered->guess == answered->ask.question.answer) return;
  draw_chord(painter,
             chord_of_choice(*view.state.view.walkthrough.trace, answered->ask.detail,
                             answered->ask.question, answered->guess),
             view.theme.amber_on_object, 3);
}

// The numbers stay after a guess, so that the user finds the answer and the guess.
void draw_answered(const Painter& painter, const CanvasView& view, double reach,
                   Occupied& occupied) {
  const std::optional<Answered>& answered = view.state.view.walkthrough.answered;
  if (!answered) return;
  // The step may not draw the even chords that the numbers name.
  if (answered->ask.question.kind == QuestionKind::even_chord)
    for (const std::uint32_t choice : answered->ask.choices)
      draw_chord(painter,
                 chord_of_choice(*view.state.view.walkthrough.trace, answered->ask.detail,
                                 answered->ask.question, choice),
                 view.theme.accent_on_object.at(0.45f), 1.5f);
  draw_names_of_choices(painter, view, answered->ask, reach, occupied);
}

// Where the words refer to candidates by number, the best of them have numbers.
void draw_ranked(const Painter& painter, const CanvasView& view, double reach, Occupied& occupied) {
  const Walkthrough& walk = view.state.view.walkthrough;
  const std::optional<TeamScores>& scores = walk.detail.scores;
  if (!scores || walk.ask || walk.answered) return;
  Ask ranked;
  ranked.detail = walk.detail;
  ranked.question.kind = QuestionKind::winning_chord;
  ranked.choices = best_ranked(*scores);
  draw_names_of_choices(painter, view, ranked, reach, occupied);
}

// The one selected by the buttons is stronger.
void draw_choices(const Painter& painter, const CanvasView& view, double reach,
                  Occupied& occupied) {
  const std::optional<Ask>& ask = view.state.view.walkthrough.ask;
  if (!ask) return;
  draw_asked_completion(painter, view, *ask);
  const auto chord = [&](std::size_t i) -> const Chord& {
    return chord_of_choice(*view.state.view.walkthrough.trace, ask->detail, ask->question,
                           ask->choices[i]);
  };
  for (std::size_t i = 0; i < ask->choices.size(); ++i)
    draw_chord(painter, chord(i), view.theme.accent_on_object.at(0.45f), 2.5f);
  if (ask->choices.size() > 3)
    draw_chord(painter, chord(ask->pointed), view.theme.accent_on_object, 4);
  draw_names_of_choices(painter, view, *ask, reach, occupied);
}

// The step's figures, over everything known so far.
void draw_step(const Painter& painter, const CanvasView& view) {
  const Walkthrough& walk = view.state.view.walkthrough;
  const std::vector<Team>& teams = teams_at(*walk.trace, walk.known);
  if (walk.base.size() >= 2)
    painter.outline(walk.base, view.theme.hull_outline, 2, walk.base.size() > 2);
  draw_rays(painter, view);
  draw_candidates(painter, view);
  for (std::uint32_t i = 0; i < walk.known.teams; ++i)
    draw_chord(painter, chord_of(teams[i]), view.theme.chord, 2);
  for (const Figure& figure : walk.gained) draw_figure(painter, view, figure);
  for (const Figure& figure : walk.figures) draw_figure(painter, view, figure);
  if (walk.hovered && *walk.hovered < walk.figures.size()) {
    const Figure& figure = walk.figures[*walk.hovered];
    if (figure.points.size() == 2)
      painter.line(figure.points[0], figure.points[1], view.theme.accent_on_object, 4);
    if (figure.points.size() == 1)
      draw_ring(painter, figure.points[0], view.theme.accent_on_object);
  }
}

}  // namespace

void draw_walkthrough(const Painter& painter, const CanvasView& view) {
  const Walkthrough& walk = view.state.view.walkthrough;
  const Placement& placement = walk.trace->placement;
  const bool shows_step = !asks_of_other_robots(view.state);
  const Scene& scene = view.scene;
  const RowFill rows =
      scene.triangles.empty() ? painter.rows(placement.vertices(), scene.holes) : RowFill{};
  painter.fill(scene.corners, scene.triangles, view.theme.object);
  painter.fill(rows, view.theme.object);
  const bool knows = knows_base(view.state), heat = knows && scene.shows_heat();
  if (heat) painter.heat(scene.heat, rows, view.theme);
  if (knows) draw_load_region(painter, view);
  if (walk.base.size() >= 3 && shows_step && !heat)
    painter.fill_around(scene.holes, walk.base, view.theme.hull);
  painter.outlines(placement.vertices(), scene.holes, view.theme.object_outline, 2);
  if (walk.known.stands) draw_unusable(painter, placement, view.theme);
  if (shows_step) draw_step(painter, view);
  if (knows) draw_tilt(painter, view);
  if (walk.asked) draw_chord(painter, *walk.asked, view.theme.amber_on_object, 4);
  draw_wrong_guess(painter, view);
  draw_asked_places(painter, view);
  // As far out as if a robot stood at each end: nearer numbers would give the answer away.
  const double reach = static_cast<double>(mark_radius(view.placement->teams));
  Occupied occupied = occupied_by_marks(view, reach);
  draw_values(painter, view, occupied);
  draw_choices(painter, view, reach, occupied);
  draw_answered(painter, view, reach, occupied);
  draw_ranked(painter, view, reach, occupied);
  add_lines_of_step(view, occupied);
  const std::vector<LoadLabel> loads = loads_of_walkthrough(view);
  for (const LoadLabel& load : loads) occupied.box(load.box);
  draw_part_names(painter, view, occupied);
  draw_loads(painter, view, loads);
}

}  // namespace evenlift::view
