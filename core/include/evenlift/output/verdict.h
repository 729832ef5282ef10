// Judges whether a placement is good, and gives each reason if it is not. The program, the page and
// JSON show the same judgement.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "evenlift/report.h"

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
  // For each sentence what it is about, for programs: no_place, falls, tips, overloaded, left_out, misfit,
  // fewer_teams, not_upright, low_coverage, not_held or inaccurate.
  std::vector<std::string_view> codes;
};

// Describes the misfits of given supports (supports.h): returns a sentence for each of the first
// three and, if there are more, one with the number of the others. O(1).
std::vector<std::string> misfits_in_words(const Reported& of);

// The supports and holes that are left out (placement.h): a sentence for each reason. O(k^2) for k.
std::vector<std::string> left_out_in_words(const Placement& placement);

// Judges a placement. It is good if all requested teams are placed, every robot fits, none carries
// more than its capacity by the loads that are shown, the object does not tip under the given
// conditions, the coverage is at least good_coverage (words.h), C is clearly inside the lifting base,
// the object is held, and all of this is so with robots that are off by the setting `accuracy`. O(m).
Judgement judge(const Reported& of);

}  // namespace evenlift
