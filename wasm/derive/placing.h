// Places the document, by its method and by the second one.
#pragma once

#include "state/state.h"

namespace evenlift::view {

// Takes over the document's placement, or why it was refused.
void adopt(Derived& facts, const Document& document, Result<Placement> placement);

// The placed document, with the same number of robots.
Document by_other_method(const Derived& facts, Method method);

// By the second method, if any. Costs a placement.
void renew_second(Derived& facts, const Work& work, Haste haste);

// The best load ratio of any chord, if none meets the minimum. Costs as much as find_candidates().
std::optional<double> best_ratio_if_none(const Placement& placement);

}  // namespace evenlift::view
