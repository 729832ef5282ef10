// Words that the steps and the questions of exchanges of teams share.
#pragma once

#include <array>
#include <string>

#include "evenlift/trace.h"

namespace evenlift {

// Two shares of 1 as percentages, with as many decimals as tell them apart.
std::array<std::string, 2> told_apart(double a, double b);

// What a learner is asked before an exchange.
std::string swap_question(const StepDetail& detail, const Question& question);

}  // namespace evenlift
