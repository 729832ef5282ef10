// The present view and tool. They are neither saved with the document nor undone.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "evenlift/chords.h"
#include "evenlift/document.h"
#include "evenlift/load_models.h"
#include "evenlift/result.h"
#include "evenlift/task.h"
#include "state/camera.h"
#include "state/explanation.h"
#include "state/walkthrough_state.h"

namespace evenlift::view {

// How far the sheet of a narrow screen is open.
enum class Sheet : std::uint8_t { closed, half, full };

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

// The polygon when the user grabbed it to move, turn or scale it.
struct PolygonGrip {
  Points vertices;
  std::optional<Vec2> centre_of_mass;
  std::vector<Points> holes;
  std::vector<Cargo> cargo;
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
  std::size_t depth = 0;     // History::depth() at the opening; below this, the task ends
};

struct View {
  Tool tool = Tool::parts;
  Drawing drawing;
  PolygonGrip grip;
  Snap snap;
  std::optional<std::size_t> selected;  // number of a handle (handles.h)
  Pick hover, held;
  // The place on the outline to which the user drags a robot that cannot go there.
  std::optional<LiftingPoint> closed_to;
  // A support that is held outside the object; meanwhile it is not among the supports.
  struct Away {
    Vec2 at;
    std::optional<double> capacity;
  };
  std::optional<Away> away;
  bool erases = false;     // the held brush erases, instead of marking
  bool measuring = false;  // the user chooses two points of the backdrop, to set its scale

  bool challenge = false;  // a challenge or a task is open, so the page hides its own answers
  std::optional<OpenTask> task;

  LoadModel load_model = LoadModel::plan;  // the load model of the shown loads
  Wanted<std::size_t> fails;               // the failed robot's number from 0
  Wanted<Pick> card;                       // the part that the card explains
  Walkthrough walkthrough;
  bool presenting = false;  // presentation mode: enlarged, in full screen

  Camera camera;
  bool camera_follows = true;  // the camera fits the drawing until the user pans or zooms
  bool fit_due = true;         // the camera should be fitted once no drag is under way
  Rect fitted;                 // the area of the last fit
  bool motion = true;          // changes are animated, except with reduced motion

  bool panel_open = true;
  bool carrying_open = false;  // the section about slopes, uneven ground and a further load
  bool formal_open = false;    // the section with the algorithm and a step's formula
  bool more_open = false;      // the section of seldom-used settings
  bool robot_open = false;     // the section about the robots' size
  Sheet sheet = Sheet::closed;
};

}  // namespace evenlift::view
