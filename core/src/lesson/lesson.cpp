#include "evenlift/lesson.h"

#include "evenlift/link.h"

namespace evenlift {
namespace {

bool on_edges(const EdgePair& pair, std::uint32_t a, std::uint32_t b) {
  return (pair.a == a && pair.b == b) || (pair.a == b && pair.b == a);
}

}  // namespace

Result<Document> lesson_document(const Lesson& lesson, const Document& sample) {
  Result<Document> document =
      lesson.link.empty() ? Result<Document>(sample) : decode_link(lesson.link);
  if (!document) return document;
  for (const GivenSetting& given : lesson.settings)
    if (auto error = read_setting(given.setting, given.text, *document)) return *error;
  return document;
}

std::optional<std::uint32_t> find_step(const Trace& trace, const StepAddress& address) {
  switch (address.by) {
    case StepAddress::By::kind:
      return trace.find(address.kind, address.item);
    case StepAddress::By::vertex:
      for (std::uint32_t i = 0; i < trace.rays.vertices.size(); ++i)
        if (trace.rays.vertices[i] == address.item) return trace.find(StepKind::ray, i);
      return std::nullopt;
    case StepAddress::By::edges:
      for (std::uint32_t i = 0; i < trace.pairs.size(); ++i)
        if (on_edges(trace.pairs[i], address.item, address.other))
          return trace.find(StepKind::outcome, i);
      return std::nullopt;
    case StepAddress::By::number:
      if (address.item < trace.size()) return address.item;
      return std::nullopt;
    case StepAddress::By::end:
      break;
  }
  return trace.size() - 1;
}

std::optional<InputError> check_lesson(const Lesson& lesson, const Trace& trace) {
  for (const LessonStep& step : lesson.steps)
    if (!find_step(trace, step.address))
      return InputError{ErrorCode::bad_syntax,
                        "the polygon's trace has no such step",
                        {Place::Kind::line, step.line, 0, {}}};
  return std::nullopt;
}

}  // namespace evenlift
