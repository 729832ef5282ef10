// Texts that steps and questions about swaps share.
#pragma once

#include <array>
#include <string>

#include "evenlift/trace.h"

namespace evenlift {

// As percentages, with enough decimals to show which is larger.
std::array<std::string, 2> told_apart(double a, double b);

// Asks a learner before a swap.
std::string swap_question(const StepDetail& detail, const Question& question);

}  // namespace evenlift
