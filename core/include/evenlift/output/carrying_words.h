// Slopes, starts, stops, uneven ground and a further load, in words (tilt.h, extra_load.h).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "evenlift/output/words.h"

namespace evenlift {

// A length as given, unless it was computed, as from readings, and has many digits: then it is rounded
// up. O(1).
std::string given_length(double length, const Units& units);

// Return a slope as "8 %", and an angle at which something tips, rounded down, as "4.6°". O(1).
std::string slope_in_words(double ratio, Toward toward = Toward::nearest);
std::string degrees_in_words(double degrees);

// Returns the disturbance (uncertainty.h) as an addition to a sentence: "with a C uncertainty of 3
// cm, on slopes up to 8 %, braked at up to 0.1 g, with heights off by up to 2 mm". The text is
// empty if there is no disturbance. O(1).
std::string disturbance_in_words(const Shown& shown);

// Returns the disturbance as a clause: "C is off by up to 3 cm, the ground slopes by up to 8 % and
// heights are off by up to 2 mm". O(1).
std::string disturbance_as_clause(const Shown& shown);

// Returns the disturbance as the end of "it tips …": "with C off by up to 3 cm, on a slope of 8 %,
// braked at 0.1 g". O(1).
std::string conditions_in_words(const Shown& shown);

// Says which conditions count only in part because another number is missing: "The acceleration
// changes nothing without the height of the centre of mass." The text is empty if all given
// conditions count fully. O(m).
std::string given_in_part_in_words(const Reported& of);

// Says that the object can tip under the given conditions: "It can tip: the centre of mass may be
// off by 200 mm, and 177 mm in one direction is enough.", or "On a slope of 8 % it tips." The text
// is empty if the object cannot tip under them. O(1).
std::string tipping_in_words(const Reported& of);

// Says when the object tips: "In the worst direction it tips at a slope of 14° (25 %) or, on level
// ground, when it is braked at 0.25 g." If it stays under a given slope or acceleration, the text
// adds what is left: "On the slope of 8 % it tips when it is braked at 0.19 g." The text is empty if
// the height of C is 0. O(1).
std::string tilt_in_words(const Reported& of);

// Says where a further load may stand: "Another 80 kg may stand on 62 % of the object without
// lifting a robot off or overloading one, if all robots are equally stiff and level and the object does not bend. Up to 33.3 kg may stand
// anywhere on it." A robot that is lifted off goes slack: it carries nothing. The text is empty if no such load is given, or if the
// object falls. O(1).
std::string extra_in_words(const Reported& of);

// Describes a further load at a place, if robots are equally stiff: "80 kg here: robots carry
// 12.1–54.2 kg", or "80 kg here tips it". `is_fine` is true if, under all given conditions, no
// robot goes slack or is overloaded; otherwise the text gives the reason. O(m log m).
struct LoadHere {
  std::string words;
  bool is_fine = false;
};
LoadHere extra_here_in_words(const ExtraLoad& extra, const Vec2& at, const ShownPlacement& of);

// Gives the slope at which the object tips if the ground falls from C towards `at`: "Downhill this
// way it tips at 14° (25 %)". The text is empty if `at` is C, the height of C is 0, H has no area,
// or the object falls. O(h) for h corners of H.
std::string tilt_towards_in_words(const Vec2& at, const ShownPlacement& of);

}  // namespace evenlift
