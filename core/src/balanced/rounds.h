// The swaps of the search for balanced robots, given only its Rules. evenlift/balanced.h explains
// them; there, the functions of the same names take a BalancedProblem instead.
#pragma once

#include "balanced/rules.h"
#include "evenlift/balanced.h"

namespace evenlift::balanced {

BalancedStep try_next_triple(const Rules& rules, BalancedSearch search);
BalancedSearch finish_search(const Rules& rules, BalancedSearch search);

}  // namespace evenlift::balanced
