#pragma once

#include "output/trace_words/pseudo_code.h"

namespace evenlift {

// The statement that a step executes. O(1).
Statement statement_of(const Trace& trace, const StepDetail& detail);

}  // namespace evenlift
