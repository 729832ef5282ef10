// Robots that somebody moves by hand.
#pragma once

#include <cstddef>
#include <optional>

#include "state/state.h"

namespace evenlift::view {

// Where the robots come to if one of the first picture is moved: a balanced one to the point of the outline
// that is nearest to `to`, and its two neighbours so that all still bear the same; one of a team along its
// range towards `to`. Nothing if they stay; where others cannot follow the robot that is held, the state
// notes where it is wanted. O(n log n).
std::optional<Moved> moved_by_hand(AppState& state, std::size_t robot, const Vec2& to);

// Notes that the robot that is held cannot go there. O(n).
void refuse_by_hand(AppState& state, const Vec2& to);

// Shows a placement in which this robot was moved, and takes over where its robots are. It ends the search.
void show_moved(AppState& state, std::size_t robot, Placement placement);

}  // namespace evenlift::view
