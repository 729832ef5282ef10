// The user's present view and tool: neither saved with the document nor undone.
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

// The position of a narrow screen's sheet.
enum class Sheet : std::uint8_t { closed, half, full };

// The effect of a press on the drawing: grabs a vertex or the centre of mass, places a vertex,
// grabs the whole polygon, marks a no-go part, adds a robot, places a vertex of a hole, or puts a
// weight on the object.
enum class Tool : std::uint8_t { parts, draw, transform, mark, robot, hole, weight };

// Whether the tool draws a shape or a hole, vertex by vertex.
constexpr bool draws(Tool tool) { return tool == Tool::draw || tool == Tool::hole; }

// Whether a click with the tool adds a robot or a weight.
constexpr bool adds_by_click(Tool tool) { return tool == Tool::robot || tool == Tool::weight; }

// The polygon or the hole being drawn, vertex by vertex.
struct Drawing {
  Points points;
  Points undone;                    // redo brings back its last point first
  std::optional<Vec2> cursor;       // where the next vertex would go
  std::optional<Vec2> last_cursor;  // its last place, for when the pointer is elsewhere
  std::optional<Vec2> pointer;      // the pointer's place at that time, in pixels
  bool by_keys = false;  // the cursor was moved by keys; it stays until the pointer moves
  std::optional<double> length, degrees;  // of the next edge, as typed
  bool checked = false;                   // whether `refusal` is known
  std::optional<InputError> refusal;      // why the present shape cannot be closed
};

// The polygon when the user grabbed it to move, turn or scale it.
struct PolygonGrip {
  Points vertices;
  std::optional<Vec2> centre_of_mass;
  std::vector<Points> holes;
  std::vector<Cargo> cargo;
};

// The snap targets of points that are dragged or drawn.
struct Snap {
  bool grid = false;  // the dots of the grid
  bool axis = false;  // the horizontal and the vertical through a neighbouring point
  bool operator==(const Snap&) const = default;
};

// A request of the user. The number distinguishes a repeated request from an old one. A request
// ends when the robots change.
template <class What>
struct Wanted {
  std::optional<What> of;
  std::uint64_t number = 0;

  void ask(std::optional<What> what) {
    of = std::move(what);
    ++number;
  }
};

// The task of a lesson, while it is open.
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
  // A support that the pointer holds outside the object; meanwhile it is not among the supports.
  struct Away {
    Vec2 at;
    std::optional<double> capacity;
  };
  std::optional<Away> away;
  bool erases = false;     // what the brush does while it is held
  bool measuring = false;  // the user chooses two points of the backdrop, to set its scale

  bool challenge =
      false;  // a challenge or a task is open: the page keeps its own answers to itself
  std::optional<OpenTask> task;

  LoadModel load_model = LoadModel::plan;  // the model of the shown loads
  Wanted<std::size_t> fails;               // the robot that should fail, by its number from 0
  Wanted<Pick> card;                       // the part that the card explains
  Walkthrough walkthrough;
  bool presenting = false;  // presentation mode: enlarged, on the full screen

  Camera camera;
  bool camera_follows = true;  // the view fits its window until the user pans or zooms
  bool fit_due = true;         // the view must be fitted once no drag is under way
  Rect fitted;                 // the area that the view was fitted to
  bool motion = true;          // changes are animated, except with reduced motion

  bool panel_open = true;
  bool carrying_open = false;  // the settings of slopes, uneven ground and a further load are open
  bool formal_open = false;    // the formula of a step and the algorithm are open
  bool more_open = false;      // the seldom-used settings are open
  bool robot_open = false;     // the settings of the robots' size are open
  Sheet sheet = Sheet::closed;
};

}  // namespace evenlift::view
