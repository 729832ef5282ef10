// Steps of the algorithm for a printed page (web/lessons/handout.js).
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "evenlift/lesson.h"
#include "evenlift/link.h"
#include "evenlift/main_steps.h"
#include "evenlift/output/json_text.h"
#include "evenlift/output/trace_words.h"
#include "evenlift/placement.h"
#include "evenlift/report.h"
#include "evenlift/trace.h"
#include "evenlift/uncertainty.h"
#include "evenlift/wording.h"
#include "modules/cases.h"
#include "modules/handout_paper.h"
#include "modules/kinds.h"

namespace evenlift::view {
namespace {

// More would be neither printed nor visible.
constexpr std::size_t most_candidates = 400, most_figures = 400;

// A step to print, with the teacher's words.
struct PrintedStop {
  std::uint32_t step;
  std::string words;
};
std::vector<PrintedStop> stops_of(const Trace& trace, const Result<Lesson>& lesson) {
  std::vector<PrintedStop> stops;
  if (lesson) {
    for (const LessonStep& step : lesson->steps)
      if (const auto found = find_step(trace, step.address)) stops.push_back({*found, step.words});
  } else {
    for (const std::uint32_t step : main_steps(trace)) stops.push_back({step, {}});
  }
  return stops;
}

std::string in_json(const Points& points) {
  std::vector<std::string> all;
  for (const Vec2& p : points) all.push_back(json::pair(p));
  return json::array(all);
}

Points ends_of(const Chord& chord) { return {chord.r1.position, chord.r2.position}; }

// Everything known at a step: the background of its picture.
struct Known {
  Points base;
  std::vector<std::string> candidates, teams;  // chords
};
Known known_at(const Paper& paper, const Trace& trace, const StepDetail& detail) {
  const Placement& placement = trace.placement;
  const Progress known = progress_at(trace, detail.number);
  Known all{lifting_base(trace, known), {}, {}};
  for (std::size_t c = 0;
       c < placement.candidates.size() && all.candidates.size() < most_candidates; ++c) {
    if (!known.merged && trace.first_source_of_candidate[c] >= known.sources) continue;
    all.candidates.push_back(in_json(paper(ends_of(placement.candidates[c].chord))));
  }
  for (std::uint32_t t = 0; t < known.teams && !trace.balanced(); ++t)
    all.teams.push_back(in_json(paper(ends_of(chord_of(teams_at(trace, known)[t])))));
  return all;
}

std::vector<Figure> figures_on_paper(const Trace& trace, const StepDetail& detail) {
  std::vector<Figure> shown = figures(trace, detail);
  std::erase_if(shown, [](const Figure& figure) {
    return figure.kind == FigureKind::object || figure.points.empty();
  });
  if (shown.size() > most_figures) shown.resize(most_figures);
  return shown;
}

std::string figure_json(const Paper& paper, const Figure& figure) {
  return json::object({{"kind", json::text(name(figure.kind))},
                       {"number", figure.item ? std::to_string(*figure.item + 1) : "null"},
                       {"value", json::number(paper.length(figure.value))},
                       {"points", in_json(paper(figure.points))}});
}

std::string step_json(const Paper& paper, const Trace& trace, const PrintedStop& stop) {
  const StepDetail detail = look_at(trace, stop.step);
  const Known known = known_at(paper, trace, detail);
  const std::vector<Figure> shown = figures_on_paper(trace, detail);
  std::vector<std::string> about, robots, words;
  for (const Figure& figure : shown) about.push_back(figure_json(paper, figure));
  for (const PaperRobot& robot : robots_on_paper(paper, trace, detail))
    robots.push_back(
        json::object({{"number", std::to_string(robot.number)}, {"at", json::pair(robot.middle)}}));
  for (const PaperWords& each : words_on_paper(paper, trace, detail, shown))
    words.push_back(
        json::object({{"text", json::text(each.text)}, {"at", json::pair(each.middle)}}));
  return json::object({{"chapter", json::text(translated(title(detail.step.chapter)))},
                       {"caption", json::text(caption(trace, detail))},
                       {"formula", json::text(formula(trace, detail))},
                       {"in_words", json::text(stop.words)},
                       {"base", in_json(paper(known.base))},
                       {"candidates", json::array(known.candidates)},
                       {"teams", json::array(known.teams)},
                       {"figures", json::array(about)},
                       {"robots", json::array(robots)},
                       {"words", json::array(words)}});
}

Points shown_points(const Placement& placement) {
  Points all = placement.vertices();
  for (const Cargo& item : placement.settings.cargo) all.push_back(item.at);
  return all;
}

std::string cargo_json(const Paper& paper, const Trace& trace) {
  std::vector<std::string> cargo;
  for (const PaperCargo& item : cargo_on_paper(paper, trace))
    cargo.push_back(
        json::object({{"at", json::pair(item.middle)}, {"radius", json::number(item.radius)}}));
  return json::array(cargo);
}

std::string holes_json(const Paper& paper, const Placement& placement) {
  std::vector<std::string> holes;
  for (const Points& hole : placement.object.rings_of_holes())
    holes.push_back(in_json(paper(hole)));
  return json::array(holes);
}

// The cases of loading, if anything is given that they show.
std::string cases_of(const Placement& placement, const Shown& shown) {
  const Reported of(placement, shown);
  const bool is_given = disturbance_of(of.shown).any() || of.report.has_capacities;
  return is_given && cases_fit_on_paper(placement) ? table_of_cases(of) : "null";
}

}  // namespace

// Returns the steps of this lesson for a link's document; without a lesson, the main steps. Places
// are on the paper:
//   width, height, disc     of a picture; `disc` is a robot's radius
//   polygon, holes, centre
//   cargo                   for each weight: at, radius of its disc
//   own_centre              of the object without its cargo
//   steps                   chapter, caption, formula, in_words (the teacher's), and the picture:
//     base, candidates, teams   known at this step
//     figures                   kind, number, points, and `value`, such as a radius
//     robots, words             known at this step: number or text, at
//   cases                   of loading (cases.h), without a lesson; null if nothing is given for them
//   question, answer        of a lesson that has them
//   problem                 a sentence, instead of all the above
std::string handout(const RequestMembers& members) {
  const Result<Document> document = decode_link(members.text("link"));
  if (!document) return problem(document.error().message);
  const Result<Placement> placement = place(*document, Effort::whole, Misfitting::left_out);
  if (!placement) return problem(placement.error().message);
  const Result<Trace> trace = make_trace(*placement, HistoryLength::whole, document->shown.units);
  if (!trace) return problem(trace.error().message);
  const Paper paper(shown_points(*placement));
  const Result<Lesson> lesson = parse_lesson(members.text("lesson"));
  std::vector<std::string> steps;
  for (const PrintedStop& stop : stops_of(*trace, lesson))
    steps.push_back(step_json(paper, *trace, stop));
  const bool asks = lesson && !lesson->question.empty();
  return json::object({{"width", json::number(Paper::width)},
                       {"height", json::number(Paper::height)},
                       {"disc", json::number(Paper::disc)},
                       {"polygon", in_json(paper(placement->vertices()))},
                       {"holes", holes_json(paper, *placement)},
                       {"cargo", cargo_json(paper, *trace)},
                       {"own_centre", json::pair(paper(placement->own_centre))},
                       {"centre", json::pair(paper(trace->centre))},
                       {"steps", json::array(steps)},
                       {"cases", lesson ? "null" : cases_of(*placement, document->shown)},
                       {"question", json::text(asks ? lesson->question : "")},
                       {"answer", json::text(asks ? lesson->answer : "")}});
}

}  // namespace evenlift::view
