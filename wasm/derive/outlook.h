// The loads of the robots on the screen, and the effects of failures.
#pragma once

#include <cstddef>
#include <optional>

#include "evenlift/result.h"
#include "state/state.h"

namespace evenlift::view {

// Renews the loads in both pictures and the places for a further load. `model` is the shown load
// model, and `shown` has conditions such as slopes. O(m log m + n) for m robots; O(m^3) up to 64
// robots if the model is not the plan, or if there is a disturbance (uncertainty.h).
void renew_outlooks(Derived& facts, LoadModel model, const Shown& shown);

// Renews the effect of each robot's failure, if due. With more than `most_failures_known` robots,
// computes no effects. If the computation would take long, puts it off while `move` is true, that
// is, while robots are moved by hand or by a search.
inline constexpr std::size_t most_failures_known = 128;
void renew_failures(Derived& facts, const Shown& shown, bool move);

// Marks the robot with this number, from 0, as failed; if there is no such robot, marks none. The
// other robots stay where they are. If the effects of failures are not known, this costs as much as
// computing one of them.
void let_fail(Derived& facts, std::size_t robot, const Shown& shown);

}  // namespace evenlift::view
