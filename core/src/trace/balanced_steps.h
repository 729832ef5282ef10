// The data of balanced robots in a trace, and the details of their steps.
#pragma once

#include "evenlift/trace.h"

namespace evenlift {

// Repeats the search and records it. The trace's placement becomes the result of the search.
std::optional<InputError> trace_search(Trace& trace, HistoryLength length);

// Fills in the details of a step of balanced robots.
void look_at_balanced(const Trace& trace, StepDetail& detail);

// The robots at step k: those of the step's own set, or of the last set.
const BalancedSet* balanced_set_at(const Trace& trace, const Step& step);

}  // namespace evenlift
