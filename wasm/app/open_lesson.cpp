#include "app/open_lesson.h"

#include <utility>

#include "edits/open_document.h"
#include "edits/undo.h"
#include "evenlift/formats.h"
#include "evenlift/lesson.h"
#include "state/opened.h"
#include "walkthrough/script.h"
#include "walkthrough/walkthrough.h"

namespace evenlift::view {

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
    const std::optional<InputError> problem = join_script(state, std::move(script));
    if (!problem) state.walkthrough.of_lesson = true;
    return problem;
  }
  script.preview = start == LessonStart::preview;
  const std::optional<std::uint32_t> first = find_step(*trace, script.lesson.steps[0].address);
  of_it->placement = trace->placement;  // with balanced robots, what their search came to
  of_it->document.shown.step = first;
  of_it->trace = std::move(trace).value();
  const std::optional<Script>& former = state.walkthrough.script;
  if (script.preview && former && former->preview) {
    show_opened(state, std::move(of_it).value());
  } else {
    leave_lesson_for_another(state);
    open(state, std::move(of_it).value(), Edit::lesson_opened);
  }
  begin_script(state, std::move(script));
  state.walkthrough.of_lesson = true;
  return std::nullopt;
}

}  // namespace evenlift::view
