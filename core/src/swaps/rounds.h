// A round of swaps, which finds the best of the choices on trial.
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

// Returns the best trial if it is better than the present choice, otherwise nullopt. If trials tie
// in all keys, the first is chosen.
std::optional<Better> best_trial(Choices& choices, std::vector<Trial> trials, const HoldKeys& now);

}  // namespace evenlift::swaps
