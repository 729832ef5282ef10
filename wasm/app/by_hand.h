// Balanced robots that somebody moves by hand.
#pragma once

#include <cstddef>

#include "state/state.h"

namespace evenlift::view {

// Moves a robot of the first picture to the point of the outline that is nearest to `to`, and its two
// neighbours so that all still bear the same. Where they cannot follow nothing moves. It ends the
// search. O(n log n).
void move_by_hand(AppState& state, std::size_t robot, const Vec2& to);

}  // namespace evenlift::view
