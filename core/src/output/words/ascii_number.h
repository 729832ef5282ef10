// Rounds numbers as words.h does, but writes them for programs: the minus sign is "-".
#pragma once

#include <string>

namespace evenlift {

// Writes exactly `decimals` (0 .. 9) digits after the point, and never "-0". From 1e15 on, it
// writes the same as shortest() (numbers.h).
std::string ascii_fixed(double value, int decimals);

}  // namespace evenlift
