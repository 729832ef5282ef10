// Lessons that a teacher writes in a text editor (docs/lessons.md): an object, steps, and words for
// each step.
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
// The settings come first, one per line. `title` is required, and so is one of `polygon` (a
// sample's name), `link` (a share link) and `generate` (a family of generate.h). The options of
// `evenlift place` (settings.h) and `overlays` may also be set; they override the settings in the
// link. `predict: yes` makes the learner guess before some choices, `loads` is the model of the
// shown loads (load_models.h), and `failed` is the robot that fails. The steps follow in the order
// in which they are shown. Each step consists of an address in brackets and of words. Numbers in an
// address count from 1, as in captions.
//   KIND or KIND N   the first or the N-th step of a kind of `evenlift trace --json`: "team 2"
//   vertex N         the ray from that vertex
//   pair N           the outcome of that edge pair
//   edges A B        the outcome of the pair of these edges
//   step N           a step by its number in the whole trace, which changes with the polygon
//   end              the last step
// A task (task.h) may follow the steps or replace them: `[task]` and its words. Four of the
// settings at the top, `require`, `move`, `place` and `find`, belong to the task; they state the
// goal and what the learner may change. At the end there may be a `[question]` and its `[answer]`,
// which is shown on request.
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

// Longer lessons are refused.
inline constexpr std::size_t max_lesson_steps = 200;
inline constexpr std::size_t max_lesson_title = 100;     // bytes
inline constexpr std::size_t max_lesson_words = 1000;    // bytes, of one step
inline constexpr std::size_t max_lesson_task = 300;      // bytes
inline constexpr std::size_t max_lesson_question = 300;  // bytes
inline constexpr std::size_t max_lesson_answer = 600;    // bytes

// The addresses of steps listed above, with indices from 0.
namespace at {
struct Kind {
  StepKind kind = StepKind::polygon;
  std::uint32_t item = 0;
  bool operator==(const Kind&) const = default;
};
struct Vertex {
  std::uint32_t vertex = 0;
  bool operator==(const Vertex&) const = default;
};
struct Edges {
  std::uint32_t a = 0, b = 0;
  bool operator==(const Edges&) const = default;
};
struct Number {  // `step N`
  std::uint32_t step = 0;
  bool operator==(const Number&) const = default;
};
struct End {
  bool operator==(const End&) const = default;
};
}  // namespace at
using StepAddress = std::variant<at::Kind, at::Vertex, at::Edges, at::Number, at::End>;

// A setting of the lesson, as written.
struct GivenSetting {
  Setting setting;
  std::string text;
  std::size_t line = 0;  // from 1
};

// `generate: star n=9 seed={number}`: a polygon of generate.h.
struct GeneratedPolygon {
  Family family = Family::convex;
  std::size_t n = 12;
  std::optional<std::uint64_t> seed;  // if not set, the learner's number
};

// The parts that a learner may change to solve a task: places and number of robots; number and
// choice of teams of two; the centre of mass; the outline and its holes; the cargo.
enum class Movable : std::uint8_t { robots, teams, centre, vertices, cargo };
std::string_view name(Movable part);  // "robots"; O(1)

struct Task {
  std::string words;                  // not empty; "\n" separates paragraphs
  std::vector<Condition> conditions;  // empty only if `find_centre` is true
  std::vector<Movable> may;           // at least one, in ascending order
  std::size_t place = 0;              // robots to be placed by hand; 0 keeps the lesson's robots
  bool find_centre = false;           // whether to find the hidden centre of mass from the loads
};

struct LessonStep {
  StepAddress address;
  std::string words;     // not empty; "\n" separates paragraphs
  std::size_t line = 0;  // of the address, from 1
};

struct Lesson {
  std::string title;
  std::string polygon;                        // the name of a sample, or empty
  std::string link;                           // a share link, or empty
  std::optional<GeneratedPolygon> generated;  // exactly one of polygon, link and generated is set
  std::vector<GivenSetting> settings;         // each at most once; read_setting() reads the texts
  bool predict = false;
  std::optional<LoadModel> loads;     // the model of the shown loads
  std::optional<std::size_t> failed;  // the failed robot, from 0; the steps do not show its failure
  std::vector<LessonStep> steps;      // at least one, unless there is a task
  std::optional<Task> task;
  std::string question, answer;  // formatted like the words of a step; both empty or neither
};

// Reads a lesson in UTF-8 with lines that end in \n or \r\n. Any bytes give either a lesson or an
// error. The place of an error is a line, unless the text is too long. Does not check whether the
// link, the polygon and the steps exist. O(bytes).
Result<Lesson> parse_lesson(std::string_view text);

// Returns the lesson's document with the lesson's own settings, for the learner with this number.
// The object is that of the lesson's link, the polygon that the lesson generates, or `sample`: the
// caller reads the sample that the lesson names as its `polygon`. Errors are those of
// decode_link(), generate() and read_setting(). exercise() (task.h) later makes the changes that a
// task asks for.
Result<Document> lesson_document(const Lesson& lesson, const Document& sample,
                                 std::uint64_t number = 1);

// Returns `error`, which comes from lesson_document() or from placing its document. If `error` is
// about one of the lesson's own settings, its place becomes the line of that setting. O(settings).
InputError at_line(InputError error, const Lesson& lesson);

// Returns the number of the step with this address, from 0, if the trace has such a step. O(K) for
// edges, with K edge pairs, and O(n) for a vertex; otherwise O(1).
std::optional<std::uint32_t> find_step(const Trace& trace, const StepAddress& address);

// If the trace lacks any of the lesson's steps, returns an error at the line of the first of these.
// The message says, for instance, which steps of that kind exist. The cost is that of find_step()
// for each step.
std::optional<InputError> check_lesson(const Lesson& lesson, const Trace& trace);

}  // namespace evenlift
