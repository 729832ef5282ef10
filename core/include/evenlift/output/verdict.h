// Judges a placement: whether it is good and, if it is not, each reason why. The program, the page
// and JSON show the same judgement.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "evenlift/placed_robots.h"

namespace evenlift {

enum class VerdictKind : std::uint8_t {
  good,     // nothing against it
  warning,  // it stands, but something is amiss
  bad       // there are no robots, or the object falls
};
std::string_view name(VerdictKind kind);

struct Judgement {
  VerdictKind kind = VerdictKind::good;
  std::vector<std::string> reasons;  // sentences, the most serious first
};

// Returns a sentence for each of the first three misfits of given supports (supports.h), and one
// for the number of the other misfits. O(m log n + m^2).
std::vector<std::string> misfits_in_words(const ShownPlacement& of);

// Judges a placement. It is good if all requested teams are placed, every robot fits (misfits() of
// placed_robots.h), none exceeds its capacity, the object does not tip within the disturbance
// (disturbance_of()), the coverage is at least good_coverage (words.h), and the object is held
// (is_held()). The loads are as planned, as ranges if there is a disturbance. O(m log n + m^2) for
// supports of a size, otherwise O(m log m).
Judgement judge(const ShownPlacement& of);

// Judges the same with known robustness and with the loads to compare with the capacities: those of
// the load model that is shown (loads_by()). O(m log n + m^2).
Judgement judge(const ShownPlacement& of, const Robustness& robustness,
                const std::vector<LoadRange>& loads);

}  // namespace evenlift
