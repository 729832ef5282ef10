// The swaps of the search for balanced robots. evenlift/balanced.h explains the two functions;
// there they take a BalancedProblem, here its Rules.
#pragma once

#include "balanced/rules.h"
#include "evenlift/balanced.h"

namespace evenlift::balanced {

BalancedStep try_next_triple(const Rules& rules, BalancedSearch search);
BalancedSearch finish_search(const Rules& rules, BalancedSearch search);

}  // namespace evenlift::balanced
