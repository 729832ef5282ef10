// The document placed, by its method and by the second one.
#pragma once

#include "state/state.h"

namespace evenlift::view {

// Takes over the placement of the document, or why it is refused.
void adopt(Derived& facts, const Document& document, Result<Placement> placement);

// Places the document by the second method, if there is one. Costs a placement.
void renew_second(Derived& facts, const Work& work, Haste haste);

// If no chord is even enough, the best load ratio that there is. Costs as much as
// find_candidates().
std::optional<double> best_ratio_if_none(const Placement& placement);

}  // namespace evenlift::view
