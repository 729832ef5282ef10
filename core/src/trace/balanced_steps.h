// Balanced robots in a trace.
#pragma once

#include "evenlift/trace.h"

namespace evenlift {

// Repeats the search for balanced robots and records it in the trace. The result becomes the
// trace's placement. A whole search that is too long to show is refused; a start that is too
// long is left out.
std::optional<InputError> trace_search(Trace& trace, HistoryLength length);

void look_at_balanced(const Trace& trace, StepDetail& detail);

// The step's own set of balanced robots, or the last one. Null for the steps about the object, and
// if no set was found.
const BalancedSet* balanced_set_at(const Trace& trace, const Step& step);

}  // namespace evenlift
