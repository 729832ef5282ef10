// The loads of the robots on the screen, and the effects of failures.
#pragma once

#include <cstddef>
#include <optional>

#include "evenlift/result.h"
#include "state/state.h"

namespace evenlift::view {

// Renews the loads in both pictures, by the shown model and under the given conditions, and the
// places for a further load. O(m log m + n) for m robots; O(m^3) up to 64 robots if the shown loads
// are not the plan's.
void renew_outlooks(Derived& facts, LoadModel model, const Shown& shown);

// Renews the effect of each failure, if due. With more than `most_failures_known` robots, no
// effects are computed. If this would take long, it is put off while robots are being moved
// (`move`).
inline constexpr std::size_t most_failures_known = 128;
void renew_failures(Derived& facts, const Shown& shown, bool move);

// Lets this robot fail; if there is no such robot, none fails. The other robots stay where they
// are. If the effects of failures are not known, this costs as much as computing one of them.
void let_fail(Derived& facts, std::size_t robot, const Shown& shown);

}  // namespace evenlift::view
