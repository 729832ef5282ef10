// Everything the view knows. Panels and the canvas read it; only update.cpp changes it. No ImGui
// here.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "evenlift/capacity.h"
#include "evenlift/placement.h"
#include "state/camera.h"
#include "state/history.h"
#include "state/lesson_state.h"

namespace evenlift::view {

// What is under the pointer, or held by it.
struct Pick {
  enum class Kind : std::uint8_t {
    none,
    vertex,
    centre,
    robot,
    chord,
    edge,
    object,
    frame,
    ground
  };
  Kind kind = Kind::none;
  std::size_t index = 0;   // of the vertex, the edge, or the team; of the frame its grip
  int end = 0;             // of a robot: 0 for r1, 1 for r2
  Vec2 at = Vec2::Zero();  // polygon coordinates: of an edge the nearest point on it
  bool other = false;      // in the picture of the method that is compared
  bool operator==(const Pick&) const = default;
};

// What the page says about itself.
struct Screen {
  double width = 1280, height = 800;  // of the canvas in CSS pixels
  double ratio = 1;                   // device pixels per CSS pixel
  bool dark = false;
  bool reduced_motion = false;
  bool embed = false;   // in somebody's <iframe>: no editing panels
  bool finger = false;  // its main pointer is a finger: controls are larger
  bool touch = false;   // the last pointer was a finger: nothing hovers
};

// How far the sheet of a narrow screen is pulled up.
enum class Sheet : std::uint8_t { closed, half, full };

// What a press on the drawing does: take hold of a part, place a vertex, or take hold of the whole.
enum class Tool : std::uint8_t { parts, draw, whole };

// The polygon being drawn, vertex by vertex.
struct Drawing {
  Points points;
  Points undone;               // its end is the first to come back
  std::optional<Vec2> cursor;  // where the next one would go
};

// The whole polygon in the hand: moved, turned and scaled from how it was when it was taken.
struct WholeGrip {
  Points vertices;
  std::optional<Vec2> centre_of_mass;
};

// What dragged and drawn points keep to.
struct Snap {
  bool grid = false;  // the dots of the ground
  bool axis = false;  // level with the point before, or upright above it
};

struct Notice {
  enum class Kind : std::uint8_t { info, problem };
  Kind kind = Kind::info;
  std::string text;  // empty: no notice
};

struct AppState {
  Document document;                   // what is being edited; may be refused
  std::optional<InputError> refusal;   // why, if it is
  std::optional<Placement> placement;  // of the last document that was not refused
  Document placed;                     // that document: what links and storage hold
  History history;
  bool edit_open = false;      // a drag or slider is under way: one step of undo
  std::uint64_t revision = 0;  // grows with every change of the document

  Tool tool = Tool::parts;
  Drawing drawing;
  WholeGrip grip;
  Snap snap;
  std::optional<Method> compared;    // the method shown beside the document's
  std::optional<Placement> other;    // its placement, of the same document
  std::optional<double> capacity;    // of one robot, in the unit of the weight
  std::optional<CapacityPlan> plan;  // for it; while something is dragged the one before
  bool plan_due = false;             // the plan is to be made anew
  bool motion = true;                // what changes moves there; never with reduced motion

  LessonState lesson;

  Camera camera;
  bool camera_follows = true;           // until somebody pans or zooms, the view fits its window
  bool fit_due = true;                  // at the next frame, and not while something is dragged
  Rect fitted;                          // the room that it was fitted to
  std::optional<std::size_t> selected;  // vertex
  Pick hover, held;

  Screen screen;
  bool panel_open = true;
  bool help_open = false;
  bool list_open = false;   // a list of choices, as drawn last
  bool close_list = false;  // asked for, and not yet drawn
  Sheet sheet = Sheet::closed;
  double closed_sheet_height = 172;  // what it holds when closed, as drawn last
  Notice notice;
};

inline bool lesson_is_open(const AppState& state) { return state.lesson.trace.has_value(); }

// The settings in force. O(1).
inline const Settings& settings(const AppState& state) { return state.document.settings; }

}  // namespace evenlift::view
