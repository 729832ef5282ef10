// What would mend a placement that is not good: computed beforehand, for a button that takes it.
#pragma once

#include "state/state.h"

namespace evenlift::view {

// Renews the offer for the placement of the document: the first of a few alternatives (a lower
// minimum ratio, ranges, the goal to hold, teams by area, balanced robots) that has no fault, or
// else the first with fewer faults. None for a good placement, and none if alternatives would take
// long to try: more than 2,000 vertices or 16 robots. Costs at most four placements, each as in a
// drag (Haste::drag).
void renew_offer(Derived& facts, const Shown& shown);

}  // namespace evenlift::view
