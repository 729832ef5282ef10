// The offer on a button: other settings that improve a placement that is not good.
#pragma once

#include "state/state.h"

namespace evenlift::view {

// Renews the offer. If no candidate meets the minimum load ratio, the offer is a lower ratio.
// Otherwise a placement that is not good gets one of a few alternatives: ranges, the goal to hold,
// teams by area, or balanced robots. It is the first with the fewest faults, and has fewer than the
// placement. More than 2,000 vertices or 16 robots get no alternative, which would take long. Costs
// at most four placements, each as in a drag (Haste::drag).
void renew_offer(Derived& facts, const Shown& shown);

}  // namespace evenlift::view
