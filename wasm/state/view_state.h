// The view: explained parts, the walkthrough, and tools.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "evenlift/chords.h"
#include "evenlift/document.h"
#include "evenlift/lesson.h"
#include "evenlift/load_models.h"
#include "evenlift/output/trace_words.h"
#include "evenlift/result.h"
#include "evenlift/task.h"
#include "evenlift/trace.h"
#include "evenlift/vec.h"
#include "evenlift/why_not.h"
#include "state/camera.h"

namespace evenlift::view {

// --- A part of the drawing, and the answer to "why here?" about it.

// A part of the drawing that is under the pointer or held.
struct Pick {
  enum class Kind : std::uint8_t {
    none,
    vertex,
    centre,
    robot,
    chord,
    candidate,
    edge,
    object,
    frame,
    ground,
    uncertainty,  // the grip of the ring for the C uncertainty
    cargo,        // a weight on the object
    left_out      // a support that does not fit (Misplaced in placement.h)
  };
  Kind kind = Kind::none;
  std::size_t index = 0;  // of the vertex, edge, team, candidate, weight, support or frame's grip
  int end = 0;            // of a robot: its index in the team; r1 is 0, and r2 is 1
  Vec2 at;                // in polygon coordinates; on an edge or chord, nearest to the pointer
  bool second = false;    // the part is in the second method's picture
  bool operator==(const Pick&) const = default;
};

// The contents of the card about a robot, a team's chord or a candidate.
struct Explanation {
  struct Row {
    std::string label, value;
  };
  Pick of;
  std::optional<std::size_t> robot;  // the robot's number from 0, in the first picture
  std::string title;
  std::vector<Row> rows;
  std::string reason;
  std::optional<std::uint32_t> step;  // the walkthrough's step that decides on this part
};

// --- The state of the walkthrough, which shows the algorithm step by step. A lesson is a teacher's
// text (evenlift/lesson.h). A script is a lesson whose stops were found in the walkthrough's trace.
//
// These structs are data; walkthrough/walkthrough.h changes them.

// A step at which a lesson stops, and the teacher's words for it.
struct Stop {
  std::uint32_t step;
  std::string words;
};
struct Script {
  Lesson lesson;
  std::vector<Stop> stops;   // the lesson's steps found in the trace; at least one
  std::size_t position = 0;  // the present or last stop
  Document of;               // the lesson's own document
  std::size_t depth = 0;     // History::depth() at the opening; below this, the lesson ends
  bool preview = false;      // the lesson is being written
};

// A question about the choice that the next step shows.
struct Ask {
  std::uint32_t step;  // the step that shows the answer
  StepDetail detail;
  Question question;
  std::string text;
  std::vector<std::uint32_t> choices;  // candidates, even chords, teams, or ends of the edge pair
  std::size_t pointed = 0;             // index of the choice that the stepper shows
};

struct Answered {
  Ask ask;
  std::uint32_t guess;  // one of the choices
};

// A step that was shown, and its caption.
struct Visited {
  std::uint32_t step;
  std::string caption;
};

// The user's guesses since predictions were turned on or another document was opened. Only the
// first guess at each step counts.
struct Guesses {
  std::vector<std::uint32_t> steps;
  std::uint32_t right = 0;
  // The steps about which a question was asked, by QuestionKind.
  std::array<std::vector<std::uint32_t>, question_kind_count> asked;
  std::vector<std::uint32_t> told;  // the steps that showed a choice without a question

  // Returns the number of questions without a guess.
  std::size_t passed_over() const {
    std::size_t all = 0;
    for (const std::vector<std::uint32_t>& of_kind : asked) all += of_kind.size();
    return all - steps.size();
  }
};

struct Walkthrough {
  std::shared_ptr<const Trace> trace;  // of the placement; null while the walkthrough is closed
  std::uint64_t traced = 0;            // the trace's number (Derived::traces)
  std::uint32_t at = 0;                // the present step; kept when the walkthrough is closed
  std::vector<std::uint32_t> main;     // the main steps (evenlift/main_steps.h)
  bool all_steps = false;              // all steps are shown, otherwise only the main steps
  bool resumes = false;                // the walkthrough reopens at the step where it was closed
  StepDetail detail;
  Progress known;                         // the results known at this step
  std::vector<Figure> figures;            // of the present step
  std::optional<std::uint32_t> measured;  // the candidate in detail.scores whose gain is drawn
  std::vector<Figure> gained;             // the figures that show this gain
  Points base;                            // the lifting base known at this step
  std::string caption, formula;
  std::vector<Visited> visited;  // the last steps shown, the newest last

  bool playing = false;
  double speed = 1;
  std::optional<double> turn_at;  // when the next step is due, in seconds

  bool predict = false;
  std::optional<Ask> ask;
  std::optional<Answered> answered;  // the question whose answer this step shows
  std::string verdict;               // whether the last guess was right
  bool was_right = false;
  Guesses guesses;

  std::optional<Chord> asked;  // the chord of the question "why not this one?"
  Points asked_places;     // the place of "why no robot here?", then places where robots would go
  std::string why;         // the answer to either question
  bool why_taken = false;  // the chord belongs to a team, or a robot stands at the place

  std::optional<std::size_t> hovered;  // index of the figure under the pointer
  std::optional<Script> script;
  std::optional<Script> aside;  // the script that is set aside while all steps are shown
  bool of_lesson = false;       // opened as a lesson; valid only while open (in_lesson())
};

// --- The present view and tool. They are neither saved with the document nor undone.

// How far the sheet of a narrow screen is open.
enum class Sheet : std::uint8_t { closed, half, full };

// The sections of settings in the panel (panels/drawers.h), in its order.
enum class Drawer : std::uint8_t {
  object,
  robots,
  carrying,
  weighing,
  show,
  compare,
  end_of_drawers  // counts the drawers; keep it last
};
inline constexpr auto drawer_count = static_cast<std::size_t>(Drawer::end_of_drawers);

// The marks of the picture that explain themselves (tools/picture_marks.h). Where marks overlap, the
// first in this order does.
enum class PictureMark : std::uint8_t {
  robots,
  centre,
  triangle,
  slide,
  coverage,
  base_beyond,  // the part of the lifting base outside the outline
  base,
  clockwise,
  counterclockwise,
  end_of_marks  // counts the marks; keep it last
};

// The tool decides what a press does. In the order of the values, a press grabs a vertex or the
// centre of mass, places a vertex, grabs the whole polygon, marks a no-go part, adds a robot,
// places a hole's vertex, or puts a weight on the object.
enum class Tool : std::uint8_t { parts, draw, transform, mark, robot, hole, weight };

// Returns whether the tool draws a shape or a hole, vertex by vertex.
constexpr bool draws(Tool tool) { return tool == Tool::draw || tool == Tool::hole; }

// Returns whether a click adds a robot or a weight.
constexpr bool adds_by_click(Tool tool) { return tool == Tool::robot || tool == Tool::weight; }

// The polygon or the hole being drawn.
struct Drawing {
  Points points;
  Points undone;                          // points taken back; redo restores the last of them first
  std::optional<Vec2> cursor;             // where the next vertex would go
  std::optional<Vec2> last_cursor;        // the cursor's last place, while the pointer is elsewhere
  std::optional<Vec2> pointer;            // the pointer's place in pixels when it moved the cursor
  bool by_keys = false;                   // keys moved the cursor since the pointer last moved
  std::optional<double> length, degrees;  // of the next edge, as typed
  bool checked = false;                   // whether `refusal` is known
  std::optional<InputError> refusal;      // why the shape cannot be closed
};

// An outline or hole whose drawing was left unfinished: undo goes on with it, until the next edit.
struct LeftDrawing {
  Tool tool = Tool::draw;
  Points points;
  std::uint64_t edits = 0;  // Work::edits() and the history's depth at that time
  std::size_t depth = 0;
};

// The object when the user grabbed it, or a vertex of it, with the robots placed by hand.
struct PolygonGrip {
  Points vertices;
  std::optional<Vec2> centre_of_mass;
  std::vector<Points> holes;
  std::vector<Cargo> cargo;
  Points supports;
};

// The lines and dots to which dragged and drawn points snap.
struct Snap {
  bool grid = false;  // the dots of the grid
  bool axis = false;  // the horizontal and the vertical through a neighbouring point
  bool operator==(const Snap&) const = default;
};

// A request to show something about a robot or a part. The number distinguishes a new request from
// an equal earlier one. A request ends when the robots change.
template <class What>
struct Wanted {
  std::optional<What> of;
  std::uint64_t number = 0;

  void ask(std::optional<What> what) {
    of = std::move(what);
    ++number;
  }
};

// The task that the learner is doing in a lesson.
struct OpenTask {
  Lesson lesson;
  Exercise exercise;
  std::uint64_t number = 1;  // the task's number, as the learner sees it
  bool preview = false;      // the lesson is being written
  // Whether it has a condition on the hold, and one on the effects of failures.
  bool asks_for_hold = false, asks_for_failures = false;
  std::size_t depth = 0;  // History::depth() at the opening; below this, the task ends
};

struct View {
  Tool tool = Tool::parts;
  Drawing drawing;
  std::optional<LeftDrawing> left_drawing;
  PolygonGrip grip;
  Snap snap;
  std::optional<std::size_t> selected;  // number of a handle (handles.h)
  Pick hover, held;
  // The place on the outline to which the user drags a robot that cannot go there.
  std::optional<LiftingPoint> closed_to;
  // The support that the pointer has dragged out of the object.
  std::optional<std::size_t> dragged_out;
  bool erases = false;     // the held brush erases, instead of marking
  bool measuring = false;  // the user chooses two points of the backdrop, to set its scale

  bool challenge = false;  // a challenge or a task is open, so the page hides its own answers
  std::optional<OpenTask> task;

  LoadModel load_model = LoadModel::plan;  // the load model of the shown loads
  Wanted<std::size_t> fails;               // the failed robot's number from 0
  Wanted<Pick> card;                       // the part that the card explains
  Walkthrough walkthrough;
  std::optional<PictureMark> explained;  // for which a key asked
  bool presenting = false;               // presentation mode: enlarged, in full screen

  Camera camera;
  bool camera_follows = true;  // the camera fits the drawing until the user pans or zooms
  bool fit_due = true;         // the camera should be fitted once no drag is under way
  Rect fitted;                 // the area of the last fit
  bool motion = true;          // changes are animated, except with reduced motion

  bool panel_open = true;
  bool formal_open = false;  // the section with the algorithm and a step's formula
  std::array<bool, drawer_count> open_drawers{};
  bool all_loads = false;      // the table of loads has all rows, or else as many as fit
  bool whole_verdict = false;  // the verdict has all lines, or else three
  Sheet sheet = Sheet::closed;
};

}  // namespace evenlift::view
