// The swaps of the search by the rules alone. evenlift/balanced.h explains them; its functions of
// the same names take a problem.
#pragma once

#include "balanced/rules.h"
#include "evenlift/balanced.h"

namespace evenlift::balanced {

BalancedStep try_next_triple(const Rules& rules, BalancedSearch search);
BalancedSearch finish_search(const Rules& rules, BalancedSearch search);

}  // namespace evenlift::balanced
