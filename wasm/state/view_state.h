// What somebody looks at, and with which tool in hand: it is neither saved with the document nor
// undone.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "evenlift/chords.h"
#include "evenlift/load_models.h"
#include "evenlift/result.h"
#include "state/camera.h"
#include "state/explanation.h"
#include "state/walkthrough_state.h"

namespace evenlift::view {

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

// What somebody asked for: by its number another time is told from the same. It ends with the next
// other robots.
template <class What>
struct Wanted {
  std::optional<What> of;
  std::uint64_t number = 0;

  void ask(std::optional<What> what) {
    of = std::move(what);
    ++number;
  }
};

struct View {
  Tool tool = Tool::parts;
  Drawing drawing;
  PolygonGrip grip;
  Snap snap;
  std::optional<std::size_t> selected;  // vertex
  Pick hover, held;
  std::optional<LiftingPoint>
      closed_to;           // where the robot that is dragged is wanted, if the others
                           // cannot follow it there
  bool erases = false;     // what the brush does to marks while it is held
  bool measuring = false;  // two points of the picture behind are asked for, to set its scale

  LoadModel load_model = LoadModel::plan;  // whose loads are shown
  Wanted<std::size_t> fails;               // the robot that is to fail, by its number from 0
  Wanted<Pick> card;                       // what the card explains
  Walkthrough walkthrough;
  bool presenting = false;  // the walkthrough is shown to a room

  Camera camera;
  bool camera_follows = true;  // the view fits its window until somebody pans or zooms
  bool fit_due = true;         // the view is to be fitted when no drag is under way
  Rect fitted;                 // the room that the view was fitted to
  bool motion = true;          // changes are animated, except with reduced motion

  bool panel_open = true;
  bool more_open = false;   // the part of the settings that is seldom needed
  bool robot_open = false;  // the part of the settings about the robots' size
  Sheet sheet = Sheet::closed;
};

}  // namespace evenlift::view
