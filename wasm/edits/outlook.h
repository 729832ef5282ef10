// Computes what the robots on the screen bear and what may go wrong with them, and lets one of them fail.
#pragma once

#include <cstddef>
#include <optional>

#include "evenlift/result.h"
#include "state/state.h"

namespace evenlift::view {

// Call this after a change of the placement, of the second one, of the model of the loads or of the doubt
// about C. O(m log m + n) for m robots, and O(m^3) up to 64 of them if loads other than the plan are shown.
void renew_outlook(AppState& state);

// Call this when the placement has other robots: a robot that failed is back, and what happens if one
// fails is not known any more.
void forget_failures(AppState& state);

// Finds out what happens if one robot fails, if that is not known: for up to this many robots, and if it
// takes long not while a drag or a search goes on.
inline constexpr std::size_t most_failures_known = 128;
void renew_failures(AppState& state);

// Lets the robot with this number, from 0, fail in place of one that failed; or brings that one back.
// Places nothing. Does nothing if there is no such robot or the document is refused.
void let_fail(AppState& state, std::optional<std::size_t> robot);

// Why there is no robot with this number, from 1, in the placement.
std::optional<InputError> check_robot(const Placement& placement, std::uint64_t number);

}  // namespace evenlift::view
