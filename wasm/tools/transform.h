// Moves, turns and scales the polygon by the grips of a frame around it.
#pragma once

#include <optional>

#include "state/command.h"
#include "state/state.h"

namespace evenlift::view {

// Returns the frame around the polygon, in pixels, slightly larger than the polygon.
Rect transform_frame(const AppState& state);

// The grips of the frame: corners scale the polygon, the knob turns it, and the inside moves it.
enum class FrameGrip : std::uint8_t { low_left, low_right, high_left, high_right, turn, inside };
inline constexpr FrameGrip corner_grips[] = {FrameGrip::low_left, FrameGrip::low_right,
                                             FrameGrip::high_left, FrameGrip::high_right};

// Returns the place of a grip, in pixels. The knob is above the frame if there is room, else below
// the frame, else inside. O(1).
Vec2 grip_place(const AppState& state, const Rect& frame, FrameGrip grip);

// The turn and the scale factor of the polygon since it was grabbed. O(n).
struct Transformed {
  double degrees = 0;  // counter-clockwise, in (-180, 180]
  double factor = 1;
};
Transformed since_grip(const AppState& state);

// Returns the corners of the frame while the polygon is being turned, in pixels, in order around
// the frame. O(n).
Points turned_frame(const AppState& state);

// Returns the nearest corner or knob within reach of the pointer, or else `inside` if the pointer
// is in the frame; otherwise nothing. O(n).
std::optional<FrameGrip> grip_at(const AppState& state, const Vec2& screen);

// Returns the polygon after a drag of the held grip from `from` to `to` (pixels). O(n).
SetPolygon dragged_polygon(const AppState& state, FrameGrip held, const Vec2& from, const Vec2& to);

// Return the polygon after a key: moved by a number of grid dots; turned once by 15°, clockwise if
// `steps` is negative; or scaled by a factor. O(n).
SetPolygon moved_polygon(const AppState& state, int dots_x, int dots_y);
SetPolygon turned_polygon(const AppState& state, int steps);
SetPolygon scaled_polygon(const AppState& state, double factor);

}  // namespace evenlift::view
