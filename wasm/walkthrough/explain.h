// Why a robot stands where it does, and why a candidate was chosen or not.
#pragma once

#include <string>

#include "state/explanation.h"
#include "state/state.h"

namespace evenlift::view {

// For a robot, a chord or a candidate of one of the two pictures. Costs as much as make_trace() and
// look_at_scores().
Explanation explain(const AppState& state, const Pick& pick);

// For users who cannot see the card.
std::string in_words(const Explanation& explanation);

}  // namespace evenlift::view
