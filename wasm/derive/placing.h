// Places the document, by its method and by the second one.
#pragma once

#include "state/state.h"

namespace evenlift::view {

// Takes over the placement of the document, or the reason for its refusal.
void adopt(Derived& facts, const Document& document, Result<Placement> placement);

// The placed document by another method, with the same number of robots.
Document by_other_method(const Derived& facts, Method method);

// Places the document by the second method, if any. Costs a placement.
void renew_second(Derived& facts, const Work& work, Haste haste);

// If no chord meets the minimum ratio, the best load ratio of any chord. Costs the same as
// find_candidates().
std::optional<double> best_ratio_if_none(const Placement& placement);

}  // namespace evenlift::view
