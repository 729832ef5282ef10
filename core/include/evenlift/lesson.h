// Lessons that a teacher writes in a text editor (docs/lessons.md): what to open, and words for the
// steps to show.
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
// First the settings, one to a line. `title` and one of `polygon` (the name of a sample) and `link`
// (a share link) must be there; `teams`, `metric`, `min-ratio`, `com`, `weight` and `seed` are
// those of `evenlift place` and go before what the link carries; `predict: yes` has the learner
// guess. Then, for each step to show in the order of the lesson, its address in brackets and the
// words. Addresses, counted as captions count, from 1:
//   KIND or KIND N   a step's kind as `evenlift trace --json` names it, and its number: "team 2"
//   vertex N         the ray from that vertex
//   pair N           what becomes of that pair of edges
//   edges A B        the same by the edges' numbers
//   step N           by its number in the whole trace: not robust, where the polygon changes
//   end              the last step
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "evenlift/document.h"
#include "evenlift/result.h"
#include "evenlift/settings_text.h"
#include "evenlift/trace.h"

namespace evenlift {

// Bounds; beyond them a clear refusal.
inline constexpr std::size_t max_lesson_bytes = 1u << 16;
inline constexpr std::size_t max_lesson_steps = 200;
inline constexpr std::size_t max_lesson_title = 100;   // bytes
inline constexpr std::size_t max_lesson_words = 1000;  // bytes, of one step

// Where a lesson stops.
struct StepAddress {
  enum class By : std::uint8_t { kind, vertex, edges, number, end };
  By by = By::end;
  StepKind kind = StepKind::polygon;  // with By::kind
  std::uint32_t item = 0;             // from 0: of the kind, vertex, edge a or step
  std::uint32_t other = 0;            // edge b
};

// A setting of the lesson's own, as it is written.
struct GivenSetting {
  Setting setting;
  std::string text;
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
};

// Reads a lesson. Total: any bytes give a lesson or an error, whose place is a line. UTF-8, lines
// ending in \n or \r\n. Whether the link or polygon opens and the steps exist is not asked here.
// O(bytes).
Result<Lesson> parse_lesson(std::string_view text);

// The document that the lesson is about: its link's, or `sample`, the document of the sample that
// it names, which the caller has read; with the lesson's own settings. The errors of decode_link.
Result<Document> lesson_document(const Lesson& lesson, const Document& sample);

// The step's number; nothing if the trace has no such step. O(K) with edges or a vertex, else O(1).
std::optional<std::uint32_t> find_step(const Trace& trace, const StepAddress& address);

// The first step of the lesson that the trace does not have, as an error at its line.
std::optional<InputError> check_lesson(const Lesson& lesson, const Trace& trace);

}  // namespace evenlift
