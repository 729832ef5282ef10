// Texts shared by the steps and the questions about swaps of teams.
#pragma once

#include <array>
#include <string>

#include "evenlift/trace.h"

namespace evenlift {

// Two shares of 1 as percentages, with enough decimals to show which is larger.
std::array<std::string, 2> told_apart(double a, double b);

// The question for a learner before a swap.
std::string swap_question(const StepDetail& detail, const Question& question);

}  // namespace evenlift
