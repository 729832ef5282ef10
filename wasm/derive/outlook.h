// The loads of the robots on the screen, and what may go wrong with them.
#pragma once

#include <cstddef>
#include <optional>

#include "evenlift/result.h"
#include "state/state.h"

namespace evenlift::view {

// The loads in both pictures, by the shown model and under the given conditions, and the places for
// a further load. O(m log m + n) for m robots; O(m^3) up to 64 robots if the shown loads are not
// the plan's.
void renew_outlooks(Derived& facts, LoadModel model, const Shown& shown);

// The effect of each failure, if due: for at most this number of robots and, if it takes long, not
// while robots `move`.
inline constexpr std::size_t most_failures_known = 128;
void renew_failures(Derived& facts, const Shown& shown, bool move);

// Without such a robot, none fails. Places nothing. If the failures are unknown, costs as much as
// one of them.
void let_fail(Derived& facts, std::size_t robot, const Shown& shown);

}  // namespace evenlift::view
