#include "evenlift/lesson.h"

#include <string>

#include "evenlift/link.h"
#include "evenlift/wording.h"

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

// The message about a step that the trace does not have.
struct Absence {
  const Trace& trace;

  std::string operator()(const at::Kind& address) const {
    const std::string word(address.kind == StepKind::outcome ? std::string_view("pair")
                                                             : name(address.kind));
    const auto step = [&](std::uint32_t number) {
      return "[" + word + " " + std::to_string(number) + "]";
    };
    const std::uint32_t count = trace.count(address.kind), item = address.item + 1;
    if (count == 0)
      return say("there is no step {step} with this polygon and these settings",
                 {"[" + word + "]"});
    if (count == 1)
      return say(
          "there is no step {step}: with this polygon and these settings there is only {only}",
          {step(item), "[" + word + "]"});
    return say(
        "there is no step {step}: with this polygon and these settings there are {first} to {last}",
        {step(item), step(1), step(count)});
  }
  std::string operator()(const at::Vertex& address) const {
    const std::uint32_t vertex = address.vertex + 1;
    if (address.vertex >= trace.polygon().size())
      return say("there is no vertex {vertex}: the polygon has {count} vertices",
                 {vertex, trace.polygon().size()});
    return say("there is no ray from vertex {vertex} with these settings", {vertex});
  }
  std::string operator()(const at::Edges& address) const {
    return say(
        "edges {a} and {b} are not examined together: no chord through the centre of mass joins them",
        {address.a + 1, address.b + 1});
  }
  std::string operator()(const at::Number& address) const {
    return say("there is no step {step}: there are {count}", {address.step + 1, trace.size()});
  }
  std::string operator()(const at::End&) const { return {}; }
};

Result<Document> opened_object(const Lesson& lesson, const Document& sample, std::uint64_t number) {
  if (!lesson.link.empty()) return decode_link(lesson.link);
  if (!lesson.generated) return sample;
  const GeneratedPolygon& polygon = *lesson.generated;
  Result<Points> vertices = generate(polygon.family, polygon.n, polygon.seed.value_or(number));
  if (!vertices) return vertices.error();
  Document document;
  document.vertices = *std::move(vertices);
  return document;
}

}  // namespace

Result<Document> lesson_document(const Lesson& lesson, const Document& sample,
                                 std::uint64_t number) {
  Result<Document> document = opened_object(lesson, sample, number);
  if (!document) return document;
  for (const GivenSetting& given : lesson.settings)
    if (auto error = read_setting(given.setting, given.text, *document))
      return at_line(*std::move(error), lesson);
  return document;
}

InputError at_line(InputError error, const Lesson& lesson) {
  for (const GivenSetting& given : lesson.settings)
    if ((error.place.kind == Place::Kind::centre_of_mass && given.setting == Setting::com) ||
        (error.place.kind == Place::Kind::option && error.place.option == name(given.setting)))
      error.place = {Place::Kind::line, given.line, 0, {}};
  return error;
}

std::optional<std::uint32_t> find_step(const Trace& trace, const StepAddress& address) {
  return std::visit(Finder{trace}, address);
}

std::optional<InputError> check_lesson(const Lesson& lesson, const Trace& trace) {
  for (const LessonStep& step : lesson.steps)
    if (!find_step(trace, step.address))
      return InputError{ErrorCode::bad_syntax,
                        std::visit(Absence{trace}, step.address),
                        {Place::Kind::line, step.line, 0, {}}};
  return std::nullopt;
}

}  // namespace evenlift
