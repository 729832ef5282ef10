// Balanced robots in a trace.
#pragma once

#include "evenlift/trace.h"

namespace evenlift {

// Repeats the search for balanced robots and records it in the trace. The result becomes the
// trace's placement. If the search is too long to show, the function returns an error for
// HistoryLength::whole, and records nothing for HistoryLength::start.
std::optional<InputError> trace_search(Trace& trace, HistoryLength length);

void look_at_balanced(const Trace& trace, StepDetail& detail);

// The set of balanced robots that the step shows: its own or, if it has none, the final set of the
// search. Null for the steps about the object, and if there is no such set.
const BalancedSet* balanced_set_at(const Trace& trace, const Step& step);

}  // namespace evenlift
