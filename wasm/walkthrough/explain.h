// Explains why a robot stands where it does, and why a candidate was chosen or not.
#pragma once

#include <string>

#include "state/explanation.h"
#include "state/state.h"

namespace evenlift::view {

// Returns the explanation of a robot, a chord or a candidate of one of the two pictures. Costs at
// most as much as make_trace() and look_at_scores().
Explanation explain(const AppState& state, const Pick& pick);

// Returns the explanation as one text, for users who cannot see the card.
std::string in_words(const Explanation& explanation);

}  // namespace evenlift::view
