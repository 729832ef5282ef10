// A Placement in words and rounded numbers, for the program's table, the picture's caption, and
// those who cannot see a picture. Plain English, UTF-8, the same bytes on every platform.
#pragma once

#include <string>
#include <string_view>

#include "evenlift/placement.h"

namespace evenlift {

// A number with exactly `decimals` (0 .. 9) digits after the point, rounded, halves away from zero;
// very large ones as shortest() writes them. O(1).
std::string fixed(double value, int decimals);

// Decimals that show a value of this size, and smaller ones of its kind, to three significant
// digits. O(1).
int decimals_for(double largest);

// A share of 1 as a percentage: "81 %". Only nothing is "0 %" and only all of it "100 %". O(1).
std::string percentage(double share);

// "6 robots, each 15.2–18.1 kg of 100." or why there are none, and how many teams were asked for
// if fewer could be placed. O(1).
std::string loads_in_words(const Placement& placement);

// "81 % of the object is safe to push on." O(1).
std::string coverage_in_words(const Placement& placement);

// "It can still turn clockwise." or what holds it. O(1).
std::string closure_in_words(const Placement& placement);

// The three together: the result in a sentence or four. O(1).
std::string verdict(const Placement& placement);

}  // namespace evenlift
