// The offer on a button: other settings that improve a placement that is not good.
#pragma once

#include "state/state.h"

namespace evenlift::view {

// Renews the offer. If no chord meets the minimum load ratio, the offer is a lower ratio.
// Otherwise, if the placement is not good, the offer is one of a few alternatives: ranges, the goal
// to hold, teams by area, or balanced robots. It is the first of those with the fewest faults, if
// these are fewer than the placement's. There is no alternative for more than 2,000 vertices or 16
// robots, because the search would take long. Costs at most four placements, each as in a drag
// (Haste::drag).
void renew_offer(Derived& facts, const Shown& shown);

}  // namespace evenlift::view
