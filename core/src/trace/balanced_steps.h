// What a trace holds of balanced robots, and what one of their steps shows.
#pragma once

#include "evenlift/trace.h"

namespace evenlift {

// Searches once more and notes what the search did. The trace's placement becomes what it came to.
std::optional<InputError> trace_search(Trace& trace, HistoryLength length);

// Fills in what a step of balanced robots shows.
void look_at_balanced(const Trace& trace, StepDetail& detail);

// The robots that stand at step k: those of the set that it is about, or of the last one.
const BalancedSet* balanced_set_at(const Trace& trace, const Step& step);

}  // namespace evenlift
