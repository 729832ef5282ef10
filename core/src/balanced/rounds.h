// The swaps of the search, for the rules alone (evenlift/balanced.h has them for a problem).
#pragma once

#include "balanced/rules.h"
#include "evenlift/balanced.h"

namespace evenlift::balanced {

BalancedStep try_next_triple(const Rules& rules, BalancedSearch search);
BalancedSearch finish_search(const Rules& rules, BalancedSearch search);

}  // namespace evenlift::balanced
