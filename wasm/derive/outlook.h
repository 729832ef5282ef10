// What the robots on the screen bear, and what may go wrong with them.
#pragma once

#include <cstddef>
#include <optional>

#include "evenlift/result.h"
#include "state/state.h"

namespace evenlift::view {

// What the robots of both pictures bear, by the model that is shown. O(m log m + n) for m robots,
// and O(m^3) up to 64 of them if loads other than the plan are shown.
void renew_outlooks(Derived& facts, LoadModel model, double com_radius);

// Finds out what happens if one robot fails, if that is due: for up to this many robots, and if it
// takes long not while robots `move`.
inline constexpr std::size_t most_failures_known = 128;
void renew_failures(Derived& facts, bool move);

// This robot fails; none does if there is no such robot. Places nothing. As much as for one of all
// failures, if those are not known.
void let_fail(Derived& facts, std::size_t robot, double com_radius);

}  // namespace evenlift::view
