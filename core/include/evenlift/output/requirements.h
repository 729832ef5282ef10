// Conditions that a placement should satisfy, in the words of `evenlift place --require`: "held,
// coverage>=0.8, max<=20, robots<=4". They mark a result as kept or not.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "evenlift/placed_robots.h"
#include "evenlift/result.h"

namespace evenlift {

// The quantity that a condition is about. The first three are true or false.
enum class Quantity : std::uint8_t {
  held,      // the robots hold the object (is_held() of words.h)
  stands,    // C is in the lifting base (equilibrium.h)
  steady,    // any one robot may fail, and the object does not tip (failures_clear)
  coverage,  // 0 to 1
  max,       // the greatest planned load
  min,       // the least planned load
  spread,    // the greatest planned load minus the least
  margin,    // of form closure
  robots,    // their number
};

struct Condition {
  Quantity quantity = Quantity::held;
  bool at_least = true;  // for numbers: >= or <=
  double limit = 0;      // for numbers
  std::string text;      // as given, without spaces
};

inline constexpr std::size_t most_conditions = 100;

// The conditions in a text: words between commas, or a quantity, >= or <=, and a number. Spaces do
// not matter. The error, at the place "require", quotes the wrong condition if it is short, and
// lists all words. O(bytes).
Result<std::vector<Condition>> read_conditions(std::string_view text);

// A condition with the value that it is about: a number, or 0 or 1. No value if the placement has
// none, such as a load of an object that falls; then the condition is not kept. Numbers are compared
// within tolerance: tau of the weight for loads, tau for coverage and margin.
struct Requirement {
  Condition condition;
  std::optional<double> value;
  bool kept = false;
};

// O(m log m) in all.
std::vector<Requirement> check_conditions(const Placement& placement,
                                          const std::vector<Condition>& conditions);

// Whether a quantity is true or false. O(1).
bool is_yes_or_no(Quantity quantity);

// "coverage>=0.8: 0.834, kept", "held: no, not kept". O(1).
std::string requirement_in_words(const Requirement& requirement);

}  // namespace evenlift
