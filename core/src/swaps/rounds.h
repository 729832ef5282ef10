// One round: the best of all choices on trial.
#pragma once

#include <optional>
#include <vector>

#include "swaps/choices.h"

namespace evenlift::swaps {

struct Better {
  Trial trial;
  HoldKeys keys;
  HoldKey decided_by = HoldKey::level;
};

// The best of the trials that are better than the present choice; nothing if there is none. Trials
// are in their order of preference.
std::optional<Better> best_trial(Choices& choices, std::vector<Trial> trials, const HoldKeys& now);

}  // namespace evenlift::swaps
