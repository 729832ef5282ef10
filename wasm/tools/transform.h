// Moves, turns and scales the polygon by the grips of a frame around it.
#pragma once

#include <optional>

#include "state/command.h"
#include "state/state.h"

namespace evenlift::view {

// On the screen, slightly larger than the polygon.
Rect transform_frame(const AppState& state);

// Corners scale, the knob turns, the inside moves.
enum class FrameGrip : std::uint8_t { low_left, low_right, high_left, high_right, turn, inside };
inline constexpr FrameGrip corner_grips[] = {FrameGrip::low_left, FrameGrip::low_right,
                                             FrameGrip::high_left, FrameGrip::high_right};

// In pixels. The knob is above the frame if there is room, else below it, else inside. O(1).
Vec2 grip_place(const AppState& state, const Rect& frame, FrameGrip grip);

// Since the polygon was grabbed. O(n).
struct Transformed {
  double degrees = 0;  // counter-clockwise, in (-180, 180]
  double factor = 1;
};
Transformed since_grip(const AppState& state);

// The corners while the frame is turned, in pixels, in order. O(n).
Points turned_frame(const AppState& state);

// Under the pointer, the nearest first. O(1).
std::optional<FrameGrip> grip_at(const AppState& state, const Vec2& screen);

// After a drag from `from` to `to` (pixels). O(n).
SetPolygon dragged_polygon(const AppState& state, FrameGrip held, const Vec2& from, const Vec2& to);

// By keys: moved by a number of grid dots, turned in steps of 15°, scaled by a factor. O(n).
SetPolygon moved_polygon(const AppState& state, int dots_x, int dots_y);
SetPolygon turned_polygon(const AppState& state, int steps);
SetPolygon scaled_polygon(const AppState& state, double factor);

}  // namespace evenlift::view
