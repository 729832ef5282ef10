// Slopes, starts, stops, uneven ground and a further load, in words (tilt.h, extra_load.h).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "evenlift/extra_load.h"
#include "evenlift/output/words.h"
#include "evenlift/tilt.h"

namespace evenlift {

// "8 %" and "4.6°". O(1).
std::string slope_in_words(double ratio);
std::string degrees_in_words(double degrees);

// "with a C uncertainty of 3 cm, on slopes up to 8 %, braked at up to 0.1 g, with heights off by up
// to 2 mm". Empty without a disturbance. O(1).
std::string disturbance_in_words(const Shown& shown);

// "C is off by up to 3 cm, the ground slopes by up to 8 % and heights are off by up to 2 mm". O(1).
std::string disturbance_as_clause(const Shown& shown);

// The conditions that change nothing because another number is missing: "The acceleration changes
// nothing without the height of the centre of mass." Empty if all count. O(1).
std::string without_effect_in_words(const Shown& shown);

// "It can tip: the centre of mass may be off by 200 mm, and 177 mm in one direction is enough.", or
// "On a slope of 8 % it tips." Empty if it stays upright under the given conditions. O(1).
std::string tipping_in_words(const Robustness& robustness, const ShownPlacement& of);

// "In the worst direction it tips at a slope of 14° (25 %) or when it is braked at 0.25 g." Empty
// if the height of C is 0. O(1).
std::string tilt_in_words(const Robustness& robustness, const ShownPlacement& of);

// "Another 80 kg may stand on 62 % of the object without lifting a robot off or overloading one, if
// all are equally stiff. Up to 33.3 kg may stand anywhere on it." O(1).
std::string extra_in_words(const ExtraLoad& extra, const ShownPlacement& of);

// A further load at a place: "80 kg here: robots carry 12.1–54.2 kg", or "80 kg here tips it". It
// is fine if all robots keep carrying within their capacities; otherwise the text says so.
// O(m log m).
struct LoadHere {
  std::string words;
  bool is_fine = false;
};
LoadHere extra_here_in_words(const ExtraLoad& extra, const Vec2& at, const ShownPlacement& of);

// "Downhill this way it tips at 14° (25 %)", from C towards a place other than C. Empty without a
// height of C, or without an area of H. O(h).
std::string tilt_towards_in_words(const Vec2& at, const ShownPlacement& of);

}  // namespace evenlift
