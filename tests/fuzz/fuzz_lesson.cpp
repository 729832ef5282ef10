// Any bytes as a lesson: refused with a line, or within the bounds of lesson.h and opened on a
// sample.
#include <string>

#include "evenlift/lesson.h"
#include "evenlift/placement.h"
#include "fuzz/fuzz.h"

namespace {

using namespace evenlift;

// Replaces the sample that a lesson names.
Document sample() {
  Document document;
  document.vertices = {{0, 0}, {400, 0}, {400, 150}, {150, 150}, {150, 300}, {0, 300}};
  return document;
}

void require_refusal(const InputError& error) { fuzz::require(!error.message.empty()); }

void check_bounds(const Lesson& lesson) {
  fuzz::require(!lesson.title.empty() && lesson.title.size() <= max_lesson_title);
  fuzz::require(!lesson.polygon.empty() + !lesson.link.empty() + lesson.generated.has_value() == 1);
  fuzz::require((lesson.task || !lesson.steps.empty()) && lesson.steps.size() <= max_lesson_steps);
  if (lesson.task) {
    fuzz::require(!lesson.task->words.empty() && lesson.task->words.size() <= max_lesson_task);
    fuzz::require(lesson.task->find_centre || !lesson.task->conditions.empty());
    fuzz::require(!lesson.task->may.empty());
  }
  for (const LessonStep& step : lesson.steps)
    fuzz::require(!step.words.empty() && step.words.size() <= max_lesson_words);
  fuzz::require(lesson.question.empty() == lesson.answer.empty());
  fuzz::require(lesson.question.size() <= max_lesson_question);
  fuzz::require(lesson.answer.size() <= max_lesson_answer);
}

void open(const Lesson& lesson) {
  // More vertices would take most of the time.
  if (lesson.generated && lesson.generated->n > 40) return;
  const Result<Document> document = lesson_document(lesson, sample());
  if (!document) return require_refusal(document.error());
  if (document->vertices.size() > 40) return;
  const Result<Placement> placement = place(*document);
  if (!placement) return require_refusal(placement.error());
  const Result<Trace> trace = make_trace(*placement);
  if (!trace) return require_refusal(trace.error());
  const std::optional<InputError> missing = check_lesson(lesson, *trace);
  if (missing) return require_refusal(*missing);
  for (const LessonStep& step : lesson.steps) {
    const std::optional<std::uint32_t> number = find_step(*trace, step.address);
    fuzz::require(number.has_value());
    look_at(*trace, *number);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const Result<Lesson> lesson = parse_lesson(fuzz::text_of(data, size));
  if (!lesson) {
    require_refusal(lesson.error());
    fuzz::require(lesson.error().place.kind == Place::Kind::line);
    return 0;
  }
  check_bounds(*lesson);
  open(*lesson);
  return 0;
}
