// Computes the document's placement by its method and, while two methods are compared, by the
// second.
#pragma once

#include "state/state.h"

namespace evenlift::view {

// Takes over the document's placement, or the reason why it was refused.
void adopt(Derived& facts, const Document& document, Result<Placement> placement);

// The placed document with this method and the same number of robots, which is rounded to an even
// number for teams.
Document by_other_method(const Derived& facts, Method method);

// Places the document by the second method, if any. Costs a placement.
void renew_second(Derived& facts, const Work& work, Haste haste);

// The best load ratio of any chord, rounded down to hundredths, if the method chooses among
// candidates but no team was placed; otherwise nullopt. Costs as much as find_candidates().
std::optional<double> best_ratio_if_none(const Placement& placement);

}  // namespace evenlift::view
