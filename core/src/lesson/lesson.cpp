#include "evenlift/lesson.h"

#include "evenlift/link.h"

namespace evenlift {
namespace {

bool on_edges(const EdgePair& pair, std::uint32_t a, std::uint32_t b) {
  return (pair.a == a && pair.b == b) || (pair.a == b && pair.b == a);
}

struct Finder {
  const Trace& trace;

  std::optional<std::uint32_t> operator()(const at::Kind& address) const {
    return trace.find(address.kind, address.item);
  }
  std::optional<std::uint32_t> operator()(const at::Vertex& address) const {
    for (std::uint32_t i = 0; i < trace.rays.vertices.size(); ++i)
      if (trace.rays.vertices[i] == address.vertex) return trace.find(StepKind::ray, i);
    return std::nullopt;
  }
  std::optional<std::uint32_t> operator()(const at::Edges& address) const {
    for (std::uint32_t i = 0; i < trace.pairs.size(); ++i)
      if (on_edges(trace.pairs[i], address.a, address.b)) return trace.find(StepKind::outcome, i);
    return std::nullopt;
  }
  std::optional<std::uint32_t> operator()(const at::Number& address) const {
    if (address.step < trace.size()) return address.step;
    return std::nullopt;
  }
  std::optional<std::uint32_t> operator()(const at::End&) const { return trace.size() - 1; }
};

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
  return std::visit(Finder{trace}, address);
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
