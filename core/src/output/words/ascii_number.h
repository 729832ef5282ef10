// Rounds as words.h does, but for programs: the minus sign is "-".
#pragma once

#include <string>

namespace evenlift {

// Exactly `decimals` (0 .. 9) digits after the point; never "-0". From 1e15 on as shortest().
std::string ascii_fixed(double value, int decimals);

}  // namespace evenlift
