#pragma once

#include "evenlift/report.h"

namespace evenlift {

// How far robots may be off (accuracy.h). Of the report, everything but capacities' radii, accuracy
// and further loads is known. O(m^2 + m h) for m robots of up to 1,000, of which a few are computed
// again some 50 times, and O(m) for more; with bodies O(m^2).
Accuracy accuracy_of(const ShownPlacement& of, const Report& known);

}  // namespace evenlift
