#include "app/opening.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/update.h"
#include "derive/derive.h"
#include "edits/undo.h"
#include "evenlift/formats.h"
#include "evenlift/lesson.h"
#include "evenlift/link.h"
#include "evenlift/output/words.h"
#include "evenlift/wording.h"
#include "state/derived.h"
#include "state/screen.h"
#include "walkthrough/walkthrough.h"

namespace evenlift::view {

namespace {

std::optional<Document> work_before(std::string_view work) {
  Result<Document> before = parse_document(work);
  if (!before) return std::nullopt;
  return std::move(before).value();
}

bool open_work(AppState& state, const LastVisit& visit) {
  if (visit.work.empty()) return false;
  Result<Opened> work = read_document(visit.work);
  if (!work) return false;
  start_with(state, std::move(work).value(), std::nullopt);
  conclude(state);
  if (Result<Document> draft = decode_link(visit.draft)) {
    resume_draft(state, std::move(draft).value());
    conclude(state);
  }
  return true;
}

}  // namespace

std::string open_page(AppState& state, const LastVisit& visit, std::string_view sample) {
  std::string problem;
  if (!visit.link.empty()) {
    if (Result<Opened> linked = read_link(visit.link)) {
      start_with(state, std::move(linked).value(), work_before(visit.work));
      conclude(state);
      return {};
    } else {
      problem = sentence(linked.error());
    }
  }
  if (!open_work(state, visit)) {
    start_with(state, std::move(read_document(sample)).value(), std::nullopt);
    conclude(state);
  }
  return problem;
}

namespace {

// Begins a script for the open document, or joins its walkthrough at the present step.
std::optional<InputError> join(AppState& state, Script script) {
  if (state.derived().refusal || !state.derived().placement ||
      state.work.document().vertices != script.of.vertices)
    return InputError{ErrorCode::bad_syntax, "it is about another polygon than the link"};
  const bool begins = !walkthrough_is_open(state);
  open_walkthrough(state);
  conclude(state);
  if (!walkthrough_is_open(state)) return std::nullopt;  // a notice explains why
  begin_script(state, std::move(script));
  if (begins) go_to_step(state, step_of(state, 0));
  state.view.walkthrough.of_lesson = true;
  return std::nullopt;
}

// A preview replaces the previous one.
void open_anew(AppState& state, Opened of_it, bool preview) {
  const std::optional<Script>& script = state.view.walkthrough.script;
  const std::optional<OpenTask>& task = state.view.task;
  if (preview && ((script && script->preview) || (task && task->preview))) {
    show_opened(state, std::move(of_it));
  } else {
    leave_lesson_for_another(state);
    open(state, std::move(of_it), Edit::lesson_opened);
  }
  conclude(state);
}

// The lesson's settings that no document contains.
void show_as(AppState& state, const Lesson& lesson) {
  if (lesson.loads) state.view.load_model = *lesson.loads;
  if (lesson.failed) state.view.fails.ask(lesson.failed);
}

void begin_task(AppState& state, OpenTask task) {
  for (const Condition& each : task.lesson.task->conditions) {
    task.asks_for_hold |= each.quantity == "held" || each.quantity == "margin";
    task.asks_for_failures |= each.quantity == "steady" || each.quantity == "max_after_failure";
  }
  task.depth = state.work.history.depth();
  if (state.view.presenting) state.view.panel_open = false;
  state.view.task = std::move(task);
}

// Hides the regions of free turns in a task that asks for no hold, unless the lesson shows them.
void show_only_asked(AppState& state) {
  const std::vector<GivenSetting>& own = state.view.task->lesson.settings;
  const bool chosen = std::any_of(own.begin(), own.end(), [](const GivenSetting& each) {
    return each.setting == Setting::overlays;
  });
  if (chosen || is_about_hold(state)) return;
  Overlays& overlays = state.work.show().overlays;
  overlays.clockwise = overlays.counterclockwise = false;
}

// A lesson without steps: its object and its task. A joined task must be about the open document's
// shape, unless that may be changed.
std::optional<InputError> open_task(AppState& state, OpenTask task, Opened of_it,
                                    LessonStart start) {
  const std::vector<Movable>& may = task.lesson.task->may;
  const bool same_shape = state.work.document().vertices == of_it.document.vertices;
  const bool other_shape = std::find(may.begin(), may.end(), Movable::vertices) != may.end();
  if (start == LessonStart::join && !same_shape && !other_shape)
    return InputError{ErrorCode::bad_syntax, "it is about another polygon than the link"};
  if (start != LessonStart::join) {
    open_anew(state, std::move(of_it), task.preview);
    show_as(state, task.lesson);
  }
  begin_task(state, std::move(task));
  if (start != LessonStart::join) show_only_asked(state);
  state.view.challenge = true;
  return std::nullopt;
}

}  // namespace

std::optional<InputError> open_lesson(AppState& state, const std::string& text,
                                      const std::string& polygon, LessonStart start,
                                      std::uint64_t number) {
  Result<Lesson> lesson = parse_lesson(text);
  if (!lesson) return lesson.error();
  Document sample;
  if (!lesson->polygon.empty()) {
    Result<Document> read = read_polygon(polygon);
    if (!read) return read.error();
    sample = std::move(read).value();
  }
  Result<Exercise> begun = exercise(*lesson, sample, number);
  if (!begun) return at_line(begun.error(), *lesson);
  Result<Opened> of_it = opened(begun->start);
  if (!of_it) return at_line(of_it.error(), *lesson);
  const bool preview = start == LessonStart::preview;
  if (lesson->steps.empty())
    return open_task(state, {*std::move(lesson), *std::move(begun), number, preview},
                     *std::move(of_it), start);
  Result<Trace> trace = compute_trace(of_it->placement, of_it->document.shown.units);
  if (!trace) return at_line(trace.error(), *lesson);
  if (auto problem = check_lesson(*lesson, *trace)) return problem;
  Script script;
  script.lesson = std::move(lesson).value();
  script.of = of_it->document;
  std::optional<OpenTask> task;
  if (script.lesson.task) task = {script.lesson, *std::move(begun), number, preview};
  if (start == LessonStart::join) {
    if (auto problem = join(state, std::move(script))) return problem;
    if (task) begin_task(state, *std::move(task));
    return std::nullopt;
  }
  script.preview = preview;
  const std::optional<std::uint32_t> first = find_step(*trace, script.lesson.steps[0].address);
  of_it->placement = trace->placement;  // for balanced robots, with the result of their search
  of_it->document.shown.step = first;
  of_it->trace = std::move(trace).value();
  open_anew(state, *std::move(of_it), preview);
  show_as(state, script.lesson);
  begin_script(state, std::move(script));
  state.view.walkthrough.of_lesson = true;
  if (task) begin_task(state, *std::move(task));
  conclude(state);
  return std::nullopt;
}

}  // namespace evenlift::view
