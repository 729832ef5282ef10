// Puts numbers and results into words, the same in the program, the page, pictures, lessons and
// experiments. Texts are in plain English or the reader's language (wording.h), in UTF-8, with the
// same bytes on every platform.
//
// Numbers are rounded from the decimal that shortest() (numbers.h) prints, with halves rounded away
// from zero. So 2.345 is 2.35 with two decimals, although its double is slightly less. The minus
// sign is "−"; zero never has one. The decimal mark is a point, or the reader's (as_read() of
// wording.h). A no-break space (U+00A0) separates a number from its unit.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "evenlift/report.h"

namespace evenlift {

// --- Numbers. All O(1).

// Writes a number with exactly `decimals` (0 .. 9) digits after the point. Numbers of 1e15 or more
// in size are written as by plain().
std::string fixed(double value, int decimals);

// Writes a number with the fewest digits that read back to the same number: "100", "0.8".
std::string plain(double value);

// Limits are rounded so that they stay true: a distance that is allowed down, a greatest load up.
// What only rounding (tau of the value) puts beyond a decimal counts as the decimal.
enum class Toward : std::uint8_t { nearest, down, up };

// Writes a number with `digits` significant digits and no trailing zeros: "0.00167", "1.67e−21".
// Only numbers of 0 or more can be rounded down or up.
std::string significant(double value, int digits, Toward toward = Toward::nearest);

// Returns the number of decimals, 0 to 9, with which `largest` shows three significant digits, or
// as close to three as possible. Use this number also for smaller values of the same kind.
int decimals_for(double largest);

// Writes a number with decimals_for(largest) decimals. The numbers in a column align if `largest`
// is the largest of them. If `largest` is below 1e-6, or 1e12 or more, the number has three
// significant digits instead of a long row of digits.
std::string amount(double value, double largest, Toward toward = Toward::nearest);

// Writes a range, as "15.2–18.1", or one number if both ends look the same after rounding.
std::string amounts(double low, double high, double largest);

// Write a load, or a range of loads, with its unit: "16.7 kg", "15.2–18.1 kg".
std::string load_in_words(double value, double largest, const Units& units);

std::string load_in_words(double low, double high, double largest, const Units& units);

// Write a limit with its unit and three significant digits: a load, or a length.
std::string load_in_words(double value, const Units& units, Toward toward);
std::string length_in_words(double length, const Units& units, Toward toward);

// Write the range in which a load lies, rounded outwards.
std::string amounts(const LoadRange& load, double largest);
std::string load_in_words(const LoadRange& load, double largest, const Units& units);

// Write a robot's load or range by a model: amounts() without a unit, load_in_words() with one. The
// models `best` and `worst` give only an upper bound, which is written as "≤ 18.1".
std::string amounts(LoadModel model, const LoadRange& load, double largest);
std::string load_in_words(LoadModel model, const LoadRange& load, double largest,
                          const Units& units);

// Adds the unit of weights to a number that is already text: "100 kg".
std::string with_weight_unit(const std::string& number, const Units& units);

// Writes a weight or capacity that the user gave: "100 kg", "22.6796 kg". The text has at most six
// significant digits, since a value converted from another unit may have many more. A whole part of
// more than six digits is written in full.
std::string given_weight(double weight, const Units& units);

// Adds the unit of lengths, if any, to a number that is already text: "2.5 mm", or "2.5".
std::string with_length_unit(const std::string& number, const Units& units);

// Writes a guaranteed length, rounded down to two significant digits: "12" for 12.9.
std::string promised_length(double length, const Units& units);

// Writes a share as "81 %". The text is "0 %" only for a share of 0, and "100 %" only for 1, within
// tolerance (tau). Other shares that would round to these are "< 1 %" or "> 99 %" or, with one
// decimal, "< 0.1 %".
std::string percentage(double share, int decimals = 0);

// Writes by how much `share` exceeds `other`, in percentage points: the difference of the two
// percentages, each rounded to two decimals.
std::string points_ahead(double share, double other);

// Writes a number with its noun: "1 team", "3 teams".
std::string count_of(std::size_t n, const char* one, const char* many);

// Returns the name of a method in words: "area", "equal angles", "by hand".
std::string method_in_words(Method method);

// Writes a load ratio with three decimals.
std::string ratio_in_words(double ratio);

// Writes a point that the user gave, to six significant digits: "(3.5, −2)".
std::string given_point(const Vec2& point);

// Writes a point with a fixed number of decimals: "(3.5, −2.0)". coordinate_decimals() returns
// the number of decimals, 1 to 9, with which the longer side of the polygon's bounding box shows
// four significant digits, or as close to four as possible.
std::string point_in_words(const Vec2& point, int decimals);
int coordinate_decimals(const Points& vertices);  // O(n)

// --- A placement. O(1) unless stated otherwise.

// Describes the planned loads: "6 robots carry 15.2–18.1 kg each (100 kg in all)." For balanced
// robots the text is "6 robots carry equal loads of 16.7 kg (100 kg in all)." With cargo the text
// ends in "(120 kg with its cargo of 24 kg)." Without robots the text is like "No team can be
// placed." If the loads are shown by another model (Report::model), the text begins with "As planned"
// or, for given supports, with "If equally stiff". If the object tips under the given conditions, the
// text is "On level ground and with C as given, 6 robots carry …". Under other conditions the loads
// are ranges: "6 robots carry 14.9–18.4 kg each, with a C uncertainty of 3 cm, on slopes up to 8 %
// (100 kg in all)." For given supports the text calls the robots equally stiff, unless equilibrium
// alone determines the loads. If the object falls, the text is "It falls: the centre of mass is 12 mm
// outside the lifting base, beyond robots 2 and 3." With TellWeight::no the text omits the weight in
// parentheses. O(m).
enum class TellWeight : std::uint8_t { no, yes };
std::string loads_in_words(const Reported& of, TellWeight weight = TellWeight::yes);

// Writes the weight, with cargo if there is any: "120 kg with its cargo of 24 kg", or "100 kg".
// O(items).
std::string weight_in_words(const ShownPlacement& of);

// Describes the outline: "4 vertices, 12 holes", or "4 vertices".
std::string outline_in_words(const PolygonWithHoles& object);

// Says why there are no teams and what could help, or that there are fewer teams than requested.
// The text is empty if all teams are placed, or if the search has found no team yet.
std::string shortage_in_words(const Placement& placement);

// Says that a limit of work ended the search: "The search was cut short by its limit of work: there
// may be better places." The text is empty if it was not.
std::string cut_short_in_words(const Placement& placement);

// Describes the coverage: "81 % of the object can be pressed down on without tipping it." The text
// is empty if there are no teams, or if the object falls.
std::string coverage_in_words(const Placement& placement);

// Describes the hold. In form closure that is not firm (placement.h), the text says which robot must
// be placed accurately, or how accurately all must be. Otherwise the text
// says that the object is held to second order, that no contact counts, or which motions are free:
// "It can still turn clockwise." The text is empty if there are no teams.
std::string closure_in_words(const Reported& of);

// Names the free motions: "turn either way and slide". The text is empty if no motion is free.
std::string free_motions_in_words(const Closure& closure);

// The least coverage of a good result.
inline constexpr double good_coverage = 0.5;

// Returns the text that follows loads_in_words(): the shortage, that C is near the edge of the base,
// the coverage, the hold, and how far robots may be off if all is
// well or an accuracy is asked for. The hold comes before the coverage if only
// the hold is a problem.
std::string detail_in_words(const Reported& of);

// Returns what is worst: that the object tips under the given conditions (tipping_in_words()), or
// which robots are overloaded by the loads that are shown. The text is empty if neither is so, or if
// the object falls, which loads_in_words() says.
std::string worst_news_in_words(const Reported& of);

// Says how much given supports can come to carry if the floor is not even: "If one of them stands a
// little high, robots 1 and 3 can come to carry 60.0 kg." With capacities, it also names those that
// can be overloaded then. The text is empty if statics alone determines the loads, or if the ranges
// that are shown allow for it already. O(m).
std::string if_uneven_in_words(const Reported& of);

// Returns worst_news_in_words(), loads_in_words(), if_uneven_in_words() and detail_in_words().
std::string verdict(const Reported& of);

// Says why a robot cannot use a place, with the size that prevents it: "a robot of radius 60 mm
// does not fit here".
std::string unusable_in_words(WhyUnusable why, const RobotSize& robot, const Units& units);

// Names the no-go parts of the boundary: "No robot touches edge 1 between 31 % and 76 % of its
// length, nor edge 3." If there are more than three parts, the text gives only their number. It is
// empty if there are none. O(1).
std::string no_go_in_words(const std::vector<EdgePart>& no_go);

// Names the capacity of each robot: "20 kg", or "its capacity" if robots have their own. At least
// one robot must have a capacity.
std::string limit_in_words(const ShownPlacement& of);

// Names the robots that are overloaded by the loads that are shown, or says that there are none, and
// adds needs_in_words(). O(teams).
std::string capacity_in_words(const Reported& of);

// Says only how many robots are needed, and how many so that any one may fail, as far as the report
// has these plans. They assume planned loads without failures or a disturbance; the text says so if
// other loads are shown.
std::string needs_in_words(const Reported& of);

// A team and its robots in words. The robots are in the order of the team. O(robots of the team).
struct TeamInWords {
  std::string ratio;
  std::string length;                  // of the chord of a team of two, or empty
  std::vector<std::string> at, loads;  // of each robot; loads without a unit
};
TeamInWords team_in_words(const Placement& placement, std::size_t team, int decimals);

// The number of decimals for the robots' places: coordinate_decimals(), or up to two more if
// rounding would put a robot at a vertex that it is only near, where it may have no contact. Then
// places that are typed again keep what they promise. O(robots).
int place_decimals(const Placement& placement);

// Returns "yes", "second order" or "no".
std::string form_closure_in_words(const Closure& closure);

// Writes a margin with three decimals, with more if it is small, or with none if it is 0 within
// tau. margin_decimals() returns this number of decimals.
std::string margin_in_words(double margin);
int margin_decimals(double margin);

// Returns the error and its place as a sentence without a full stop: "Edges 2 and 7 cross, touch or
// overlap". The text begins with the name of a setting only if the message does not identify the
// setting.
std::string sentence(const InputError& error);

}  // namespace evenlift
