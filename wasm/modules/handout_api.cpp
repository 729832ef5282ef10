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
#include "evenlift/placement.h"
#include "evenlift/trace.h"
#include "modules/handout_paper.h"
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

Points ends_of(const Chord& chord) { return {chord.r1.position, chord.r2.position}; }

// What is known at this step: the background of its picture.
void append_known(const Paper& paper, const Trace& trace, const StepDetail& detail,
                  std::string& text) {
  const Placement& placement = trace.placement;
  const Progress known = progress_at(trace, detail.number);
  text += "base\t" + in_text(paper(lifting_base(trace, known))) + '\n';
  std::size_t shown = 0;
  for (std::size_t c = 0; c < placement.candidates.size() && shown < most_candidates; ++c) {
    if (!known.merged && trace.first_source_of_candidate[c] >= known.sources) continue;
    text += "candidate\t" + in_text(paper(ends_of(placement.candidates[c].chord))) + '\n';
    ++shown;
  }
  for (std::uint32_t t = 0; t < known.teams && !trace.balanced(); ++t)
    text += "team\t" + in_text(paper(ends_of(chord_of(teams_at(trace, known)[t])))) + '\n';
}

// What the step is about.
std::vector<Figure> figures_on_paper(const Trace& trace, const StepDetail& detail) {
  std::vector<Figure> shown = figures(trace, detail);
  std::erase_if(shown, [](const Figure& figure) {
    return figure.kind == FigureKind::object || figure.points.empty();
  });
  if (shown.size() > most_figures) shown.resize(most_figures);
  return shown;
}

std::string step_text(const Paper& paper, const Trace& trace, const Stop& stop) {
  const StepDetail detail = look_at(trace, stop.step);
  std::string text = "step\t" + std::to_string(stop.step) + '\t' +
                     std::string(title(detail.step.chapter)) + '\t' + caption(trace, detail) +
                     '\t' + formula(trace, detail) + '\t' + in_a_line(stop.words) + '\n';
  append_known(paper, trace, detail, text);
  const std::vector<Figure> shown = figures_on_paper(trace, detail);
  for (const Figure& figure : shown)
    text += "figure\t" + std::string(name(figure.kind)) + '\t' +
            (figure.item ? std::to_string(*figure.item + 1) : std::string()) + '\t' +
            shortest(paper.length(figure.value)) + '\t' + in_text(paper(figure.points)) + '\n';
  for (const PaperRobot& robot : robots_on_paper(paper, trace, detail))
    text += "robot\t" + std::to_string(robot.number) + '\t' + in_text(Points{robot.middle}) + '\n';
  for (const PaperWords& words : words_on_paper(paper, trace, detail, shown))
    text += "words\t" + words.text + '\t' + in_text(Points{words.middle}) + '\n';
  return text;
}

std::string handout(std::string_view link, std::string_view lesson_text) {
  const Result<Document> document = decode_link(link);
  if (!document) return "problem\t" + document.error().message + '\n';
  const Result<Placement> placement = place(*document);
  if (!placement) return "problem\t" + placement.error().message + '\n';
  const Result<Trace> trace = make_trace(*placement, HistoryLength::whole, document->shown.units);
  if (!trace) return "problem\t" + trace.error().message + '\n';
  const Paper paper(placement->vertices());
  std::string text = "paper\t" + shortest(Paper::width) + '\t' + shortest(Paper::height) + '\t' +
                     shortest(Paper::disc) + "\npolygon\t" + in_text(paper(placement->vertices())) +
                     "\ncentre\t" + in_text(Points{paper(trace->centre)}) + '\n';
  const Result<Lesson> lesson = parse_lesson(lesson_text);
  for (const Stop& stop : stops_of(*trace, lesson)) text += step_text(paper, *trace, stop);
  if (lesson && !lesson->question.empty())
    text += "question\t" + in_a_line(lesson->question) + "\nanswer\t" + in_a_line(lesson->answer) +
            '\n';
  return text;
}

}  // namespace
}  // namespace evenlift

extern "C" {

// The steps of a lesson, whose text this is, for a link's document; without a lesson its main ones.
// A line for each thing, with tabs between its parts; places have spaces between them, and are those on the paper:
//   paper WIDTH HEIGHT DISC                       once; DISC is the radius of a robot
//   polygon, centre                               once
//   step NUMBER CHAPTER CAPTION FORMULA WORDS     begins a step; what follows is its picture:
//   base, candidate, team CHORD                   what is known by then
//   figure KIND NUMBER VALUE POINTS               what the step is about; a radius is VALUE long on the paper
//   robot NUMBER MIDDLE                           the robots that are known by then
//   words TEXT MIDDLE                             what is written into the picture
//   question WORDS, answer WORDS                  at the end of a lesson that has them
//   problem SENTENCE                              instead of all of it
EMSCRIPTEN_KEEPALIVE const char* handout_steps(const char* link, const char* lesson) {
  return evenlift::hand_over(evenlift::handout(link, lesson));
}

}  // extern "C"
