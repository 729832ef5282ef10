// Balanced robots in a trace.
#pragma once

#include "evenlift/trace.h"

namespace evenlift {

// Repeats and records the search. Its result becomes the trace's placement.
std::optional<InputError> trace_search(Trace& trace, HistoryLength length);

void look_at_balanced(const Trace& trace, StepDetail& detail);

// The step's own set, or the last one.
const BalancedSet* balanced_set_at(const Trace& trace, const Step& step);

}  // namespace evenlift
