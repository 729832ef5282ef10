#include "canvas/canvas_walkthrough.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "canvas/part_names.h"
#include "canvas/walkthrough_figures.h"
#include "evenlift/output/words.h"
#include "marks/boxed_text.h"
#include "marks/carrying.h"
#include "marks/load_labels.h"
#include "marks/stands.h"
#include "marks/walkthrough_robots.h"
#include "ui/vec.h"
#include "walkthrough/questions.h"

namespace evenlift::view {
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

}  // namespace

namespace {

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
