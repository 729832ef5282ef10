// What would mend a placement that is not good, for a button that takes it.
#pragma once

#include "state/state.h"

namespace evenlift::view {

// Renews the offer: the first of a few alternatives (a lower minimum ratio, ranges, the goal to
// hold, teams by area, balanced robots) without a fault, or else the first with fewer faults. There
// is none for a good placement, and none for more than 2,000 vertices or 16 robots, which would
// take long. Costs at most four placements, each as in a drag (Haste::drag).
void renew_offer(Derived& facts, const Shown& shown);

}  // namespace evenlift::view
