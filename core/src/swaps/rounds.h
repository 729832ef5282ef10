// One round: the best choice on trial.
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

// The best trial if it is better than the present choice, else nothing. Trials are in order of
// preference.
std::optional<Better> best_trial(Choices& choices, std::vector<Trial> trials, const HoldKeys& now);

}  // namespace evenlift::swaps
