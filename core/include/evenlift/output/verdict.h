// Judges whether a placement is good, and gives each reason if it is not. The program, the page and
// JSON show the same judgement.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "evenlift/placed_robots.h"

namespace evenlift {

enum class VerdictKind : std::uint8_t {
  good,     // there is no reason against the placement
  warning,  // there is a reason against it, but nothing below
  bad       // there are no robots, the object falls, it tips under the given conditions, or a robot
            // is overloaded
};
std::string_view name(VerdictKind kind);

struct Judgement {
  VerdictKind kind = VerdictKind::good;
  std::vector<std::string> reasons;  // sentences, the most serious first
};

// Describes the misfits of given supports (supports.h): returns a sentence for each of the first
// three and, if there are more, one with the number of the others. O(m log n + m^2).
std::vector<std::string> misfits_in_words(const ShownPlacement& of);

// Judges a placement. It is good if all requested teams are placed, every robot fits (misfits() of
// placed_robots.h), none carries more than its capacity, the object does not tip within the
// disturbance (disturbance_of()), the coverage is at least good_coverage (words.h), and the object
// is held (is_held()). The capacities are compared with loads_when_disturbed() (placed_robots.h).
// O(m log n + m^2) for given supports, otherwise O(m log m); with a disturbance, also the cost of
// model_loads().
Judgement judge(const ShownPlacement& of);

// Judges a placement whose loads by the model that is shown are known (loads_by()): the capacities
// are compared with them. O(m log n + m^2).
Judgement judge(const ShownPlacement& of, LoadModel model, const std::vector<LoadRange>& loads);

}  // namespace evenlift
