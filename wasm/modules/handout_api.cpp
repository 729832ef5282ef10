// Steps of the algorithm as plain data for a printed page (web/windows/handout.js), as a WebAssembly module of its own that is
// loaded when it is first asked for.
#include <emscripten/emscripten.h>

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
#include "evenlift/numbers.h"
#include "evenlift/output/trace_words.h"
#include "evenlift/output/words.h"
#include "evenlift/placement.h"
#include "evenlift/trace.h"
#include "page/hand_over.h"

namespace evenlift {

using view::hand_over;

namespace {

// More than this nobody prints, and nobody sees.
constexpr std::size_t most_candidates = 400, most_figures = 400;

// The steps of a lesson, with the teacher's words. Those that this trace does not have are left out.
struct Stop {
  std::uint32_t step;
  std::string words;
};
std::vector<Stop> stops_of(const Trace& trace, const Result<Lesson>& lesson) {
  std::vector<Stop> stops;
  if (lesson) {
    for (const LessonStep& step : lesson->steps)
      if (const auto found = find_step(trace, step.address)) stops.push_back({*found, step.words});
  } else {
    for (const std::uint32_t step : main_steps(trace)) stops.push_back({step, {}});
  }
  return stops;
}

// A teacher's words as part of a line.
std::string in_a_line(std::string words) {
  std::replace(words.begin(), words.end(), '\n', '\v');
  std::replace(words.begin(), words.end(), '\t', ' ');
  return words;
}

std::string in_text(const Points& points) {
  std::string text;
  for (const Vec2& p : points)
    text += (text.empty() ? "" : " ") + shortest(p.x()) + ' ' + shortest(p.y());
  return text;
}

std::string in_text(const Chord& chord) {
  return in_text(Points{chord.r1.position, chord.r2.position});
}

// What is known at this step: the background of its picture.
void append_known(const Trace& trace, const StepDetail& detail, std::string& text) {
  const Placement& placement = trace.placement;
  const Progress known = progress_at(trace, detail.number);
  text += "base\t" + in_text(lifting_base(trace, known)) + '\n';
  std::size_t shown = 0;
  for (std::size_t c = 0; c < placement.candidates.size() && shown < most_candidates; ++c) {
    if (!known.merged && trace.first_source_of_candidate[c] >= known.sources) continue;
    text += "candidate\t" + in_text(placement.candidates[c].chord) + '\n';
    ++shown;
  }
  for (std::uint32_t t = 0; t < known.teams; ++t) {
    const Team& team = teams_at(trace, known)[t];
    text += "team\t" + in_text(chord_of(team));
    if (t < known.shares)
      for (const Robot& robot : team.robots)
        text += '\t' + load_in_words(robot.load, placement.loads->max, placement.settings.units);
    text += '\n';
  }
}

std::string step_text(const Trace& trace, const Stop& stop) {
  const StepDetail detail = look_at(trace, stop.step);
  std::string text = "step\t" + std::to_string(stop.step) + '\t' +
                     std::string(title(detail.step.chapter)) + '\t' + caption(trace, detail) +
                     '\t' + formula(trace, detail) + '\t' + in_a_line(stop.words) + '\n';
  append_known(trace, detail, text);
  std::size_t shown = 0;
  for (const Figure& figure : figures(trace, detail)) {
    if (figure.kind == FigureKind::object) continue;
    if (++shown > most_figures) break;
    text += "figure\t" + std::string(name(figure.kind)) + '\t' +
            (figure.item ? std::to_string(*figure.item) : std::string()) + '\t' +
            shortest(figure.value) + '\t' + in_text(figure.points) + '\n';
  }
  return text;
}

std::string handout(std::string_view link, std::string_view lesson_text) {
  const Result<Document> document = decode_link(link);
  if (!document) return "problem\t" + document.error().message + '\n';
  const Result<Placement> placement = place(*document);
  if (!placement) return "problem\t" + placement.error().message + '\n';
  const Result<Trace> trace = make_trace(*placement);
  if (!trace) return "problem\t" + trace.error().message + '\n';
  std::string text = "polygon\t" + in_text(placement->vertices()) + "\ncentre\t" +
                     in_text(Points{trace->centre}) + '\n';
  const Result<Lesson> lesson = parse_lesson(lesson_text);
  for (const Stop& stop : stops_of(*trace, lesson)) text += step_text(*trace, stop);
  if (lesson && !lesson->question.empty())
    text += "question\t" + in_a_line(lesson->question) + "\nanswer\t" + in_a_line(lesson->answer) +
            '\n';
  return text;
}

}  // namespace
}  // namespace evenlift

extern "C" {

// The steps of a lesson, whose text this is, for a link's document; without a lesson its main ones.
// A line for each thing, with tabs between its parts; coordinates have spaces between them:
//   polygon, centre                               once
//   step NUMBER CHAPTER CAPTION FORMULA WORDS     begins a step; what follows is its picture:
//   base, candidate, team CHORD [LOAD LOAD]       what is known by then; loads in words
//   figure KIND ITEM VALUE POINTS                 what the step is about
//   question WORDS, answer WORDS                  at the end of a lesson that has them
//   problem SENTENCE                              instead of all of it
EMSCRIPTEN_KEEPALIVE const char* handout_steps(const char* link, const char* lesson) {
  return evenlift::hand_over(evenlift::handout(link, lesson));
}

}  // extern "C"
