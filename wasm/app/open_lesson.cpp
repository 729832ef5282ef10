#include "app/open_lesson.h"

#include <utility>

#include "app/conclude.h"
#include "edits/open_document.h"
#include "edits/undo.h"
#include "evenlift/formats.h"
#include "evenlift/lesson.h"
#include "state/opened.h"
#include "walkthrough/script.h"
#include "walkthrough/timeline.h"
#include "walkthrough/walkthrough.h"

namespace evenlift::view {
namespace {

// Begins a script for the open document, or joins its walkthrough at the present step; otherwise
// returns an error.
std::optional<InputError> join(AppState& state, Script script) {
  if (state.derived().refusal || !state.derived().placement ||
      state.work.document().vertices != script.of.vertices)
    return InputError{ErrorCode::bad_syntax, "it is about another polygon than the link", {}};
  const bool begins = !walkthrough_is_open(state);
  open_walkthrough(state);
  conclude(state);
  if (!walkthrough_is_open(state)) return std::nullopt;  // a notice explains why
  begin_script(state, std::move(script));
  if (begins) go_to_step(state, step_of(state, 0));
  state.view.walkthrough.of_lesson = true;
  return std::nullopt;
}

}  // namespace

std::optional<InputError> open_lesson(AppState& state, const std::string& text,
                                      const std::string& polygon, LessonStart start) {
  Result<Lesson> lesson = parse_lesson(text);
  if (!lesson) return lesson.error();
  Document sample;
  if (lesson->link.empty()) {
    Result<Document> read = read_polygon(polygon);
    if (!read) return read.error();
    sample = std::move(read).value();
  }
  Result<Document> document = lesson_document(*lesson, sample);
  if (!document) return document.error();
  Result<Opened> of_it = opened(std::move(document).value());
  if (!of_it) return at_line(of_it.error(), *lesson);
  Result<Trace> trace = compute_trace(of_it->placement, of_it->document.shown.units);
  if (!trace) return at_line(trace.error(), *lesson);
  if (auto problem = check_lesson(*lesson, *trace)) return problem;
  Script script;
  script.lesson = std::move(lesson).value();
  script.of = of_it->document;
  if (start == LessonStart::join) {
    return join(state, std::move(script));
  }
  script.preview = start == LessonStart::preview;
  const std::optional<std::uint32_t> first = find_step(*trace, script.lesson.steps[0].address);
  of_it->placement = trace->placement;  // for balanced robots, with the result of their search
  of_it->document.shown.step = first;
  of_it->trace = std::move(trace).value();
  const std::optional<Script>& former = state.view.walkthrough.script;
  if (script.preview && former && former->preview) {
    show_opened(state, std::move(of_it).value());
  } else {
    leave_lesson_for_another(state);
    open(state, std::move(of_it).value(), Edit::lesson_opened);
  }
  conclude(state);
  begin_script(state, std::move(script));
  state.view.walkthrough.of_lesson = true;
  conclude(state);
  return std::nullopt;
}

}  // namespace evenlift::view
