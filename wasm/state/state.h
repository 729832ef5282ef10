// Everything that the view knows. The canvas and the panels read it; only commands change it
// (app/update.h). It does not depend on Dear ImGui.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "evenlift/capacity.h"
#include "evenlift/placement.h"
#include "evenlift/plane.h"
#include "state/camera.h"
#include "state/explanation.h"
#include "state/history.h"
#include "state/outlook.h"
#include "state/walkthrough_state.h"

namespace evenlift::view {

// What the page tells the view about the screen.
struct Screen {
  // Of the canvas, as the browser tells: in CSS pixels, and device pixels per CSS pixel.
  double css_width = 1280, css_height = 800, css_ratio = 1;
  // Before a room everything is enlarged: everything else here and in the view is in pixels that are `zoom` CSS pixels large.
  double zoom = 1;
  double width = 1280, height = 800;
  double ratio = 1;  // device pixels per pixel
  bool dark = false;
  bool reduced_motion = false;
  bool embed = false;   // the page is in an <iframe>, and shows no panels for editing
  bool finger = false;  // the main pointer is a finger, so controls are larger
  bool touch = false;   // the last pointer was a finger, which hovers over nothing
  double foot = 0;      // covered by a card of the page at the foot of the drawing, in pixels
  double card = 0;      // the height of that card
  // What a window of the page covers: at the left, at the right, or from below as wide as the screen.
  double window_left = 0, window_right = 0, window_foot = 0;
  Rect area() const { return {0, 0, width, height}; }
};

// How far the sheet of a narrow screen is pulled up.
enum class Sheet : std::uint8_t { closed, half, full };

// What a press on the drawing does: it takes hold of a vertex or the centre of mass, places a
// vertex, takes hold of the whole polygon, or marks what no robot may touch.
enum class Tool : std::uint8_t { parts, draw, transform, mark };

// The polygon being drawn, vertex by vertex.
struct Drawing {
  Points points;
  Points undone;                    // redo brings back its last point first
  std::optional<Vec2> cursor;       // where the next vertex would go
  std::optional<Vec2> last_cursor;  // and where it was last, when the pointer is elsewhere
  std::optional<Vec2> pointer;      // where the pointer was then, in pixels
  bool by_keys = false;  // the cursor was moved by keys; it stays until the pointer moves
  std::optional<double> length, degrees;  // of the next edge, as typed
  bool checked = false;                   // whether `refusal` is known
  std::optional<InputError> refusal;      // why the shape cannot be closed as it is
};

// The polygon as it was when somebody took hold of it to move, turn or scale it.
struct PolygonGrip {
  Points vertices;
  std::optional<Vec2> centre_of_mass;
};

// What points snap to while they are dragged or drawn.
struct Snap {
  bool grid = false;  // the dots of the grid
  bool axis = false;  // the horizontal and the vertical through a neighbouring point
  bool operator==(const Snap&) const = default;
};

// The search that betters the balanced robots on the screen, and goes on beside the page; and after it the
// count of those that it takes if any one may fail.
struct Search {
  std::uint64_t number = 0;  // of the last one; what an earlier one finds is dropped
  bool due = false;          // the robots on the screen are the start of one
  bool under_way = false;
  bool counting = false;
};

// What the robots' size, the edges that must not be touched and the goal were before a method that has no use for them.
struct SetAside {
  std::optional<RobotSize> robot;
  std::optional<std::vector<EdgePart>> no_go;
  std::optional<Goal> goal;
};

struct Notice {
  enum class Kind : std::uint8_t { info, problem };
  Kind kind = Kind::info;
  std::string text;  // empty: no notice
};

struct AppState {
  Document document;                   // what is being edited; may be refused
  std::optional<InputError> refusal;   // why it is refused, if it is
  std::optional<Placement> placement;  // of the last document that was not refused
  Document placed;                     // that document; links and storage hold it
  History history;
  bool edit_open = false;      // a drag is under way; it will be one step of undo
  std::uint64_t revision = 0;  // grows with every change of the document
  int opened = 0;              // how many documents were opened since the start

  Tool tool = Tool::parts;
  Drawing drawing;
  PolygonGrip grip;
  Snap snap;
  std::optional<Method> second_method;  // the method shown beside the document's
  std::optional<Placement> second;      // its placement, of the same document
  std::optional<CapacityPlan> plan;     // for the capacity; not renewed during a drag
  std::optional<FailurePlan>
      spare;  // for it if any robot may fail; that of balanced robots comes later,
              // since each number of them takes a search (edits/search.h)
  std::optional<double> best_ratio;  // if no chord has the minimum load ratio: the best there is
  bool plan_due = false;             // the plan may have changed
  LoadModel load_model = LoadModel::plan;             // whose loads are shown
  Outlook outlook, second_outlook;                    // of the placement and of the second one
  std::vector<std::optional<RestOfRobots>> failures;  // if one robot of the placement fails; empty
                                                      // while that is not known
  bool failures_due = true;                           // they are to be found out
  std::optional<Failure> failure;                     // the robot that somebody let fail
  bool motion = true;  // changes are animated, except with reduced motion
  Search search;
  SetAside aside;
  std::optional<LiftingPoint>
      closed_to;  // where the robot is wanted that is dragged, if the others
                  // cannot follow it there

  Walkthrough walkthrough;
  std::optional<Explanation> explanation;  // the card that is open beside a robot or chord

  std::optional<Backdrop> backdrop;
  std::uint32_t pictures = 0;  // that were laid behind since the start
  bool measuring = false;      // two points of the picture are asked for, to set its scale

  Camera camera;
  bool camera_follows = true;           // the view fits its window until somebody pans or zooms
  bool fit_due = true;                  // the view is to be fitted when no drag is under way
  Rect fitted;                          // the room that the view was fitted to
  std::optional<std::size_t> selected;  // vertex
  Pick hover, held;

  Screen screen;
  bool presenting = false;  // the walkthrough is shown to a room
  bool panel_open = true;
  bool more_open = false;   // the part of the settings that is seldom needed
  bool robot_open = false;  // the part of the settings about the robots' size
  bool erases = false;      // what the brush does to marks while it is held
  bool list_open = false;   // whether the last frame showed a list of choices
  bool close_list = false;  // the next frame closes it
  Sheet sheet = Sheet::closed;
  double closed_sheet_height = 172;  // in pixels, as measured in the last frame
  double notice_height = 0;          // likewise
  Notice notice;
};

inline bool walkthrough_is_open(const AppState& state) {
  return state.walkthrough.trace.has_value();
}

// Whether it was opened as a lesson: closing it brings back what was open before. O(1).
inline bool in_lesson(const AppState& state) {
  return walkthrough_is_open(state) && state.walkthrough.of_lesson;
}

// The robot that fails in the picture; null if none does. A lesson and a shape that is being drawn or
// refused show none. O(1).
inline const Failure* failing(const AppState& state) {
  const bool shown =
      state.failure && !state.refusal && state.tool != Tool::draw && !walkthrough_is_open(state);
  return shown ? &*state.failure : nullptr;
}

// The placement in one of the two pictures, with a robot that fails, and what its robots bear; there must
// be one. O(1).
inline const Placement& shown_placement(const AppState& state, bool second = false) {
  if (second) return *state.second;
  return failing(state) ? failing(state)->placement : *state.placement;
}
inline const Outlook& shown_outlook(const AppState& state, bool second = false) {
  if (second) return state.second_outlook;
  return failing(state) ? failing(state)->outlook : state.outlook;
}

// Whether somebody moved robots of the first picture from where they were found. O(1).
inline bool by_hand(const AppState& state) {
  return state.placement && state.placement->moved.any();
}

// The settings in force, and what is shown. O(1).
inline const Settings& settings(const AppState& state) { return state.document.settings; }
inline const Shown& shown(const AppState& state) { return state.document.shown; }

}  // namespace evenlift::view
