// Conditions on a placement, in the words of `evenlift place --require`: "held, coverage>=0.8,
// max<=20, robots<=4". Each condition is met ("kept" in outputs) or not.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "evenlift/report.h"
#include "evenlift/result.h"

namespace evenlift {

// A condition on a quantity:
//
//   held               the robots hold the object (is_held() of placement.h)
//   stands             C is in the lifting base, within tau L (equilibrium.h)
//   steady             the object does not tip after any one failure, both on level ground
//                      (failures_clear) and under the disturbance (disturbance_of())
//   upright            C is clearly in the lifting base (Report::upright)
//   capacity           no robot carries more than its capacity
//   coverage           the coverage, from 0 to 1
//   max                the greatest planned load
//   min                the least planned load
//   spread             max - min, with C at its assumed place
//   use                the greatest use of a robot (Report::use); none if no robot has a capacity
//   safety             the tipping distance less the accuracy, divided by the distance by which the
//                      disturbance moves the weight; none if it does not
//   max_after_failure  the greatest load by springs after any one failure, under the disturbance;
//                      none if the object then falls or tips
//   margin             the margin of form closure
//   tipping_distance   the distance by which C may be off before the object tips
//   tip                the slope, in degrees, at which the object tips in the worst direction
//                      (tilt.h)
//   robots             the number of robots
//   within             the length by which all robots may be off while all that is told stays true
//                      (accuracy.h), infinite without a limit; none if the object falls or tips
//   worst              the greatest load of a robot that statics allows, under the disturbance
//                      (Report::worst)
//
// The first five are true or false. `capacity`, `max`, `min` and `use` refer to the planned loads or,
// under a disturbance, to the ends of their ranges (Report::planned). If the object falls,
// or can tip under the disturbance, conditions on these quantities are not met.
struct Condition {
  std::string_view quantity;  // one of these names
  bool at_least = true;       // for numbers: >= or <=
  double limit = 0;           // for numbers
  std::string text;           // as written, but without spaces
};

inline constexpr std::size_t most_conditions = 100;

// Reads the conditions in a text, separated by commas; there may be at most most_conditions. Each
// is one of the first five names, or another name, >= or <=, and a number. Spaces do not matter. An
// error has the place "require". The error for a faulty condition lists all names, and quotes the
// condition if it is short and printable. O(bytes).
Result<std::vector<Condition>> read_conditions(std::string_view text);

// A condition and the value of its quantity: a number, or 1 for true and 0 for false. If there is
// no value, as for a load of an object that falls, the condition is not met. Numbers are compared
// within tolerance: tau of the weight for loads, tau L for distances, tau for coverage and margin,
// and 90 tau for degrees.
struct Requirement {
  Condition condition;
  std::optional<double> value;
  bool kept = false;
};

// Whether one of them needs the effects of failures (Asked::failures).
bool need_failures(const std::vector<Condition>& conditions);

// Determines the values of the conditions and whether they are met. Completes a copy of the report if
// they need more than it has. O(m) for each condition.
std::vector<Requirement> check_conditions(const Reported& of,
                                          const std::vector<Condition>& conditions);

// Returns whether the condition's quantity is true or false, not a number. O(1).
bool is_yes_or_no(const Condition& condition);

// condition_in_words() describes a condition: "The greatest load is at most 30 kg", "The robots
// hold the object". value_in_words() returns its value: "33.3 kg", "no". The text is empty if the
// requirement has no value. O(1).
std::string condition_in_words(const Condition& condition, const Units& units);
std::string value_in_words(const Requirement& requirement, const Units& units);

// Returns a requirement in one line: "coverage>=0.8: 0.834, kept", "held: no, not kept". O(1).
std::string requirement_in_words(const Requirement& requirement);

}  // namespace evenlift
