// Texts that steps and questions about swaps share.
#pragma once

#include <array>
#include <string>

#include "evenlift/trace.h"

namespace evenlift {

// Writes both shares as percentages, with enough decimals, at most six, to show which is larger.
std::array<std::string, 2> told_apart(double a, double b);

// The question that a learner is asked before a swap.
std::string swap_question(const StepDetail& detail, const Question& question);

}  // namespace evenlift
