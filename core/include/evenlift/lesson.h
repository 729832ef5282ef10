// Lessons that a teacher writes in a text editor (docs/lessons.md). A lesson gives the object, the
// steps to show, and words for each step.
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
//   Which team carries most?
//
//   [answer]
//   None: all carry the same load.
//
// The settings come first, one per line. `title` and one of `polygon` (the name of a sample),
// `link` (a share link) and `generate` (a family of generate.h) are required. The options of
// `evenlift place` (settings.h) and `overlays` override the link; `predict: yes` asks the learner
// to guess, `loads` names the model of the shown loads, and `failed` the robot that fails. The
// steps follow in the order in which they are shown, each with its address in brackets and its
// words. Addresses count from 1, as captions do:
//   KIND or KIND N   a step's kind as in `evenlift trace --json`, and its number: "team 2"
//   vertex N         the ray from that vertex
//   pair N           the outcome of that edge pair
//   edges A B        the outcome of the edge pair with these edges
//   step N           its number in the whole trace, which changes with the polygon
//   end              the last step
// A task (task.h) may follow the steps or replace them: `[task]` and its words; the settings
// `require`, `move`, `place` and `find` say what the learner should reach and how. The lesson may
// end with a question to think about and its answer, which is shown on request.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "evenlift/document.h"
#include "evenlift/generate.h"
#include "evenlift/lesson_link.h"
#include "evenlift/load_models.h"
#include "evenlift/output/requirements.h"
#include "evenlift/result.h"
#include "evenlift/settings.h"
#include "evenlift/trace.h"

namespace evenlift {

// Limits. Longer lessons are refused.
inline constexpr std::size_t max_lesson_steps = 200;
inline constexpr std::size_t max_lesson_title = 100;     // bytes
inline constexpr std::size_t max_lesson_words = 1000;    // bytes, of one step
inline constexpr std::size_t max_lesson_task = 300;      // bytes
inline constexpr std::size_t max_lesson_question = 300;  // bytes
inline constexpr std::size_t max_lesson_answer = 600;    // bytes

// The address of a step in a lesson. All indices count from 0.
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
struct Edges {  // the outcome of the pair of these two edges
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

// A setting in the lesson itself, as written.
struct GivenSetting {
  Setting setting;
  std::string text;
  std::size_t line = 0;  // from 1
};

// `generate: star n=9 seed={number}`: a polygon of generate.h.
struct GeneratedPolygon {
  Family family = Family::convex;
  std::size_t n = 12;
  std::optional<std::uint64_t> seed;  // none means the learner's number
};

// What a learner may change to solve a task: where robots stand, and how many there are; the number
// and the choice of teams of two; the centre of mass; the outline and its holes; the cargo.
enum class Movable : std::uint8_t { robots, teams, centre, vertices, cargo };
std::string_view name(Movable part);  // "robots"; O(1)

struct Task {
  std::string words;                  // not empty; "\n" separates paragraphs
  std::vector<Condition> conditions;  // none only if `find_centre`
  std::vector<Movable> may;           // at least one, in ascending order
  std::size_t place = 0;     // robots that stand ready to be placed; 0 leaves the lesson's own
  bool find_centre = false;  // the centre of mass is hidden, and is to be found from the loads
};

struct LessonStep {
  StepAddress address;
  std::string words;     // not empty; "\n" separates paragraphs
  std::size_t line = 0;  // of the address, from 1
};

struct Lesson {
  std::string title;
  std::string polygon;                        // a sample's name, or empty
  std::string link;                           // a share link, or empty
  std::optional<GeneratedPolygon> generated;  // exactly one of the three is given
  std::vector<GivenSetting> settings;         // each at most once; as read_setting() reads them
  bool predict = false;
  std::optional<LoadModel> loads;     // the model of the loads that are shown
  std::optional<std::size_t> failed;  // the robot that fails, from 0; shown while no step is shown
  std::vector<LessonStep> steps;      // at least one, unless there is a task
  std::optional<Task> task;
  std::string question, answer;  // at the end, formatted like `words`; both empty or neither
};

// Reads a lesson in UTF-8 with lines that end in \n or \r\n. Any bytes give a lesson or an error,
// whose place is a line. Does not check that the link or polygon opens or that the steps exist.
// O(bytes).
Result<Lesson> parse_lesson(std::string_view text);

// The lesson's document with the lesson's own settings, for the learner with this number: the
// document of its link, the polygon that it generates, or else `sample`, the sample that `polygon`
// names, which the caller has read. Errors are those of decode_link() and generate(). A task may
// change more (task.h).
Result<Document> lesson_document(const Lesson& lesson, const Document& sample,
                                 std::uint64_t number = 1);

// Returns an error of lesson_document() or of placing its result, moved to the line of the lesson's
// own setting if the error concerns one. O(settings).
InputError at_line(InputError error, const Lesson& lesson);

// The number of the step in the trace; nothing if the trace has no such step. O(K) for edges and
// vertices, otherwise O(1).
std::optional<std::uint32_t> find_step(const Trace& trace, const StepAddress& address);

// An error at the line of the first step that the trace lacks, with the steps that exist instead;
// nothing if it has all steps. The cost of find_step() for each step.
std::optional<InputError> check_lesson(const Lesson& lesson, const Trace& trace);

}  // namespace evenlift
