// Numbers and errors in words for people.
#pragma once

#include <string>

#include "evenlift/result.h"
#include "evenlift/vec.h"

namespace evenlift::view {

// With so many decimals, no -0, "−" for minus.
std::string fixed(double value, int decimals);

// With the fewest digits that read back to the same number, "−" for minus: "100", "0.8".
std::string plain(double value);

// How many decimals show three significant digits of `value`, at most 6. O(1).
int decimals_for(double value);

// "16.7 kg".
std::string weight(double value, int decimals);

// "15.2–18.1", or one number where both look the same.
std::string range(double low, double high, int decimals);

// "81 %"; never 100 % (0 %) of what is less (more).
std::string percent(double share);

// "(3.5, −2)", to 6 significant digits.
std::string point(const Vec2& p);

// "Edges 2 and 7: they cross", a sentence without a full stop.
std::string sentence(const InputError& error);

// "1 team", "3 teams".
std::string count(std::size_t n, const char* one, const char* many);

}  // namespace evenlift::view
