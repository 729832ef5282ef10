// Lessons that a teacher writes in a text editor (docs/lessons.md). A lesson says what to open,
// which steps to show, and what to say at each.
//
//   # a comment
//   title: Equal arms, equal loads
//   polygon: trapezium
//   teams: 2
//
//   [centre]
//   A sentence or two about this step. Lines are
//   joined; an empty line begins a new paragraph.
//
//   [team 2]
//   And so on.
//
//   [question]
//   Which team bears most?
//
//   [answer]
//   None: each bears the same.
//
// First the settings, one to a line. `title` and one of `polygon` (the name of a sample) and `link`
// (a share link) must be there; the settings that are options of `evenlift place` (settings.h)
// override what the link carries, and so do `overlays`; `predict: yes` makes the learner guess. The
// steps follow in the order in which the lesson shows them, each with its address in brackets and
// its words. Addresses count from 1, as captions do:
//   KIND or KIND N   a step's kind as `evenlift trace --json` names it, and its number: "team 2"
//   vertex N         the ray from that vertex
//   pair N           what becomes of that pair of edges
//   edges A B        the same by the edges' numbers
//   step N           its number in the whole trace, which changes with the polygon
//   end              the last step
// A question to think about may stand at the end, and then its answer, which is shown when it is
// asked for.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "evenlift/document.h"
#include "evenlift/result.h"
#include "evenlift/settings.h"
#include "evenlift/trace.h"

namespace evenlift {

// Bounds. What is beyond them is refused.
inline constexpr std::size_t max_lesson_bytes = 1u << 16;
inline constexpr std::size_t max_lesson_steps = 200;
inline constexpr std::size_t max_lesson_title = 100;     // bytes
inline constexpr std::size_t max_lesson_words = 1000;    // bytes, of one step
inline constexpr std::size_t max_lesson_question = 300;  // bytes
inline constexpr std::size_t max_lesson_answer = 600;    // bytes

// Where a lesson stops. All indices count from 0.
namespace at {
struct Kind {
  StepKind kind = StepKind::polygon;
  std::uint32_t item = 0;
  bool operator==(const Kind&) const = default;
};
struct Vertex {  // the ray from that vertex
  std::uint32_t vertex = 0;
  bool operator==(const Vertex&) const = default;
};
struct Edges {  // what becomes of the pair of these two edges
  std::uint32_t a = 0, b = 0;
  bool operator==(const Edges&) const = default;
};
struct Number {  // in the whole trace
  std::uint32_t step = 0;
  bool operator==(const Number&) const = default;
};
struct End {
  bool operator==(const End&) const = default;
};
}  // namespace at
using StepAddress = std::variant<at::Kind, at::Vertex, at::Edges, at::Number, at::End>;

// A setting of the lesson's own, as it is written.
struct GivenSetting {
  Setting setting;
  std::string text;
  std::size_t line = 0;  // from 1
};

struct LessonStep {
  StepAddress address;
  std::string words;     // not empty; paragraphs are parted by "\n"
  std::size_t line = 0;  // of the address, from 1
};

struct Lesson {
  std::string title;
  std::string polygon;                 // a sample's name, or
  std::string link;                    // a share link; the other one is empty
  std::vector<GivenSetting> settings;  // each at most once; what read_setting() takes
  bool predict = false;
  std::vector<LessonStep> steps;  // at least one
  std::string question, answer;   // at the end, in words as those of a step; both empty or neither
};

// Reads a lesson in UTF-8 with lines that end in \n or \r\n. Any bytes give a lesson or an error,
// whose place is a line. Does not check that the link or polygon opens or that the steps exist.
// O(bytes).
Result<Lesson> parse_lesson(std::string_view text);

// The document that the lesson is about, with the lesson's own settings: its link's document, or
// else `sample`, which the caller has read by the lesson's `polygon`. The errors are decode_link's.
Result<Document> lesson_document(const Lesson& lesson, const Document& sample);

// An error of that document, or of what follows from it: where it is about a setting that the
// lesson gives itself, at that line. O(settings).
InputError at_line(InputError error, const Lesson& lesson);

// The number of the step in the trace; nothing if the trace has no such step. O(K) for edges and
// vertices, otherwise O(1).
std::optional<std::uint32_t> find_step(const Trace& trace, const StepAddress& address);

// An error at the line of the first step that the trace does not have, which says what there is
// instead; nothing if it has them all. As find_step for each step.
std::optional<InputError> check_lesson(const Lesson& lesson, const Trace& trace);

}  // namespace evenlift
