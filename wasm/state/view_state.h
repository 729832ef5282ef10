// The present view and tool: neither saved with the document nor undone.
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

// On a narrow screen.
enum class Sheet : std::uint8_t { closed, half, full };

// A press grabs a vertex or the centre of mass, places a vertex, grabs the whole polygon, marks a
// no-go part, adds a robot, places a hole's vertex, or puts a weight on the object.
enum class Tool : std::uint8_t { parts, draw, transform, mark, robot, hole, weight };

// A shape or a hole, vertex by vertex.
constexpr bool draws(Tool tool) { return tool == Tool::draw || tool == Tool::hole; }

// Whether a click adds a robot or a weight.
constexpr bool adds_by_click(Tool tool) { return tool == Tool::robot || tool == Tool::weight; }

// The polygon or the hole being drawn.
struct Drawing {
  Points points;
  Points undone;                    // redo brings back the last point first
  std::optional<Vec2> cursor;       // where the next vertex would go
  std::optional<Vec2> last_cursor;  // its last place, while the pointer is elsewhere
  std::optional<Vec2> pointer;      // the pointer's place then, in pixels
  bool by_keys = false;             // keys moved the cursor, which stays until the pointer moves
  std::optional<double> length, degrees;  // of the next edge, as typed
  bool checked = false;                   // whether `refusal` is known
  std::optional<InputError> refusal;      // why the shape cannot be closed
};

// When the user grabbed it to move, turn or scale it.
struct PolygonGrip {
  Points vertices;
  std::optional<Vec2> centre_of_mass;
  std::vector<Points> holes;
  std::vector<Cargo> cargo;
};

// For points that are dragged or drawn.
struct Snap {
  bool grid = false;  // the dots of the grid
  bool axis = false;  // the horizontal and the vertical through a neighbouring point
  bool operator==(const Snap&) const = default;
};

// The number distinguishes a repeated request from an old one. A request ends when the robots
// change.
template <class What>
struct Wanted {
  std::optional<What> of;
  std::uint64_t number = 0;

  void ask(std::optional<What> what) {
    of = std::move(what);
    ++number;
  }
};

struct OpenTask {
  Lesson lesson;
  Exercise exercise;
  std::uint64_t number = 1;  // the learner's
  bool preview = false;      // its lesson is being written
  std::size_t depth = 0;     // edits in the history at its opening; undoing more leaves it
};

struct View {
  Tool tool = Tool::parts;
  Drawing drawing;
  PolygonGrip grip;
  Snap snap;
  std::optional<std::size_t> selected;  // handle (handles.h)
  Pick hover, held;
  std::optional<LiftingPoint>
      closed_to;  // where the dragged robot should go, if the others cannot follow
  // A support that is held outside the object, and meanwhile not among the supports.
  struct Away {
    Vec2 at;
    std::optional<double> capacity;
  };
  std::optional<Away> away;
  bool erases = false;     // what the held brush does
  bool measuring = false;  // two points of the backdrop are chosen, to set its scale

  bool challenge =
      false;  // a challenge or a task is open: the page keeps its own answers to itself
  std::optional<OpenTask> task;

  LoadModel load_model = LoadModel::plan;  // of the shown loads
  Wanted<std::size_t> fails;               // by the robot's number from 0
  Wanted<Pick> card;                       // that the card explains
  Walkthrough walkthrough;
  bool presenting = false;  // enlarged, in full screen

  Camera camera;
  bool camera_follows = true;  // fits its window until the user pans or zooms
  bool fit_due = true;         // once no drag is under way
  Rect fitted;                 // the area of the last fit
  bool motion = true;          // changes are animated, except with reduced motion

  bool panel_open = true;
  bool carrying_open = false;  // slopes, uneven ground and a further load
  bool formal_open = false;    // a step's formula, and the algorithm
  bool more_open = false;      // seldom-used settings
  bool robot_open = false;     // the robots' size
  Sheet sheet = Sheet::closed;
};

}  // namespace evenlift::view
