// Takes the results of the search for balanced robots (web/page/search.js), and of choosing teams
// while a large object is dragged (web/page/choosing.js).
#include <emscripten/emscripten.h>
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/app.h"
#include "app/opening.h"
#include "evenlift/lesson.h"
#include "evenlift/lesson_link.h"
#include "evenlift/output/json_text.h"
#include "evenlift/output/words.h"
#include "evenlift/wording.h"
#include "page/page_api.h"
#include "state/derived.h"
#include "walkthrough/walkthrough.h"

using namespace evenlift::view;

extern "C" {

// The robots, or their count, found by the search with this number, and whether it has ended: 2 if a
// limit of work ended it.
EMSCRIPTEN_KEEPALIVE void page_take_robots(double number, const char* robots, int ended) {
  carry_out({TakeRobots{static_cast<std::uint64_t>(number), robots, ended != 0, ended == 2}});
}

// The search with this number cannot continue.
EMSCRIPTEN_KEEPALIVE void page_search_failed(double number) {
  carry_out({TakeRobots{static_cast<std::uint64_t>(number), std::nullopt}});
}

// The choice for the document with this number: `size` bytes of doubles, 0 if it is refused.
EMSCRIPTEN_KEEPALIVE void page_take_choice(double number, const unsigned char* bytes,
                                           std::size_t size) {
  std::vector<double> choice(size / sizeof(double));
  if (!choice.empty()) std::memcpy(choice.data(), bytes, choice.size() * sizeof(double));
  carry_out({TakeChoice{static_cast<std::uint64_t>(number), std::move(choice)}});
}

// No choice is possible for the document with this number.
EMSCRIPTEN_KEEPALIVE void page_choice_failed(double number) {
  carry_out({TakeChoice{static_cast<std::uint64_t>(number), std::nullopt}});
}

}  // extern "C"

// --- Translations for the page (web/page/language.js).

extern "C" {

// `english` is a text or a pattern.
EMSCRIPTEN_KEEPALIVE void words_translate(const char* english, const char* translated) {
  evenlift::add_translation(english, translated);
}
}

// --- For the page's windows about lessons.

using namespace evenlift::view;
namespace json = evenlift::json;

namespace {

const evenlift::Lesson* open_lesson_or_task() {
  const View& view = app().state.view;
  if (view.walkthrough.script) return &view.walkthrough.script->lesson;
  return view.task ? &view.task->lesson : nullptr;
}

std::string text_or_problem(const evenlift::Result<std::string>& text) {
  return text ? json::object({{"text", json::text(*text)}})
              : json::object({{"problem", json::text(sentence(text.error()))}});
}

// Whether the document is as at the beginning of its task, however it is shown.
bool is_as_begun(const evenlift::Document& document, const evenlift::Document& start) {
  return document.vertices == start.vertices && document.holes == start.holes &&
         document.centre_of_mass == start.centre_of_mass && document.settings == start.settings &&
         document.moved == start.moved;
}

}  // namespace

extern "C" {

// The sample named in a lesson, whose text page_open_lesson() needs. Empty if the lesson has a link
// instead, or cannot be read.
EMSCRIPTEN_KEEPALIVE const char* page_lesson_polygon(const char* text) {
  const evenlift::Result<evenlift::Lesson> lesson = evenlift::parse_lesson(text);
  return hand_over(lesson ? lesson->polygon : std::string());
}

// `number` is the learner's, `start` a LessonStart. Returns why the lesson cannot be opened, or an
// empty text.
EMSCRIPTEN_KEEPALIVE const char* page_open_lesson(const char* text, const char* polygon, int start,
                                                  double number) {
  const auto most = static_cast<double>(evenlift::max_learner);
  const std::optional<evenlift::InputError> problem =
      open_lesson(app().state, text, polygon, static_cast<LessonStart>(start),
                  static_cast<std::uint64_t>(std::clamp(number, 0.0, most)));
  if (problem) return hand_over(sentence(*problem));
  carried_out();
  return hand_over({});
}

// The link to a lesson, and the lesson of a link: {"text"}, or {"problem"} if there is none.
EMSCRIPTEN_KEEPALIVE const char* page_lesson_link(const char* text) {
  return hand_over(text_or_problem(evenlift::encode_lesson_link(text)));
}
EMSCRIPTEN_KEEPALIVE const char* page_linked_lesson(const char* link) {
  return hand_over(text_or_problem(evenlift::decode_lesson_link(link)));
}

// For each step of the lesson, whether the algorithm takes it on the open polygon. Empty without a
// trace, or if the lesson cannot be read.
EMSCRIPTEN_KEEPALIVE const char* page_steps_that_exist(const char* text) {
  const evenlift::Result<evenlift::Lesson> lesson = evenlift::parse_lesson(text);
  const evenlift::Result<evenlift::Trace> trace =
      compute_trace(*app().state.derived().placement, {});
  if (!lesson || !trace) return hand_over({});
  std::vector<std::string> found;
  for (const evenlift::LessonStep& step : lesson->steps)
    found.push_back(json::boolean(evenlift::find_step(*trace, step.address).has_value()));
  return hand_over(json::array(found));
}

// `stop` counts from 0.
EMSCRIPTEN_KEEPALIVE void page_go_to_stop(int stop) {
  carry_out({GoToStep{step_of(app().state, static_cast<std::uint32_t>(std::max(stop, 0)))}});
}

// Opens it where the user left it or, with `predict`, as a challenge from the first step.
EMSCRIPTEN_KEEPALIVE void page_begin_walkthrough(int predict) {
  carry_out({OpenWalkthrough{}});
  Commands commands{LeaveScript{}, SetPredict{predict != 0}};
  if (predict) {
    commands.push_back(ShowAllSteps{false});
    commands.push_back(GoToStep{0});
  }
  carry_out(std::move(commands));
}

// Presentation mode, and its enlargement.
EMSCRIPTEN_KEEPALIVE int page_presenting() { return app().state.view.presenting ? 1 : 0; }
EMSCRIPTEN_KEEPALIVE double page_zoom() { return app().state.session.screen.zoom; }

// The user left full screen.
EMSCRIPTEN_KEEPALIVE void page_end_presenting() {
  if (app().state.view.presenting) carry_out({SetPresenting{false}});
}

// Asks for a prediction before each choice.
EMSCRIPTEN_KEEPALIVE void page_predict() { carry_out({SetPredict{true}}); }

EMSCRIPTEN_KEEPALIVE int page_walkthrough_is_open() {
  return walkthrough_is_open(app().state) ? 1 : 0;
}

// 0 without an open lesson, 1 if its polygon was edited, otherwise 2.
EMSCRIPTEN_KEEPALIVE int page_script() {
  const AppState& state = app().state;
  return !state.view.walkthrough.script ? 0 : script_is_true(state) ? 2 : 1;
}

// The progress of the walkthrough: the position from 0 ("at"); the number of stops ("count"), of
// guesses, and of right guesses; the number of the step; the number of choices shown without a
// question, because three of their kind had been asked ("told"), and of questions without a guess
// ("passed"). Empty without a walkthrough.
EMSCRIPTEN_KEEPALIVE const char* page_lesson() {
  const AppState& state = app().state;
  if (!walkthrough_is_open(state)) return hand_over({});
  const Timeline now = timeline(state);
  const Guesses& guesses = state.view.walkthrough.guesses;
  return hand_over(json::object({{"at", std::to_string(now.at)},
                                 {"count", std::to_string(now.count)},
                                 {"guesses", std::to_string(guesses.steps.size())},
                                 {"right", std::to_string(guesses.right)},
                                 {"step", std::to_string(state.view.walkthrough.at)},
                                 {"told", std::to_string(guesses.told.size())},
                                 {"passed", std::to_string(guesses.passed_over())}}));
}

// The question at the end of the open lesson or task, and its answer, in paragraphs separated by
// "\n". Empty without a question.
EMSCRIPTEN_KEEPALIVE const char* page_lesson_question() {
  const evenlift::Lesson* lesson = open_lesson_or_task();
  return hand_over(lesson ? lesson->question : std::string());
}

EMSCRIPTEN_KEEPALIVE const char* page_lesson_answer() {
  const evenlift::Lesson* lesson = open_lesson_or_task();
  return hand_over(lesson ? lesson->answer : std::string());
}

// The open task and its goals: {"title", "words", "may", "goals": [{"words", "value",
// "kept"}], "changed", "kept", "begun", "number", "numbered"}. `begun` is whether the learner has
// changed anything. If `numbered`, another number of the learner makes another task. Empty without a
// task.
EMSCRIPTEN_KEEPALIVE const char* page_task() {
  const AppState& state = app().state;
  if (!state.view.task) return hand_over({});
  const OpenTask& open = *state.view.task;
  const evenlift::Task& task = *open.lesson.task;
  const evenlift::Attempt attempt = state.derived().attempt.value_or(evenlift::Attempt());
  std::vector<std::string> goals, changed;
  for (const evenlift::Goalpost& goal : attempt.goals)
    goals.push_back(json::object({{"words", json::text(goal.words)},
                                  {"value", json::text(goal.value)},
                                  {"kept", json::boolean(goal.kept)}}));
  for (const std::string& each : attempt.changed) changed.push_back(json::text(each));
  return hand_over(json::object(
      {{"title", json::text(open.lesson.title)},
       {"words", json::text(task.words)},
       {"may", json::text(evenlift::movable_in_words(task))},
       {"goals", json::array(goals)},
       {"changed", json::array(changed)},
       {"kept", json::boolean(attempt.kept)},
       {"begun", json::boolean(!is_as_begun(state.work.document(), open.exercise.start))},
       {"number", std::to_string(open.number)},
       {"numbered", json::boolean(evenlift::is_numbered(open.lesson))}}));
}

EMSCRIPTEN_KEEPALIVE int page_task_is_open() { return app().state.view.task ? 1 : 0; }
EMSCRIPTEN_KEEPALIVE void page_close_task() { carry_out({CloseTask{}}); }

}  // extern "C"
