// Finds the best choice of teams among the candidates by dynamic programming, to measure how far
// the greedy choice is from it (algorithm.md, The optimum).
//
// Dynamic programming ignores collisions between robots with a size. For such robots the bound
// stays valid, but only a choice without collisions can replace the greedy choice.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "evenlift/candidates.h"
#include "evenlift/placement.h"
#include "evenlift/polygon_with_holes.h"
#include "evenlift/swaps.h"

namespace evenlift {

struct Optimum {
  std::vector<std::uint32_t> taken;  // the candidates of the best choice found, increasing
  double coverage = 0;               // of this choice, 0 .. 1
  double bound = 1;                  // no choice covers more than this, up to rounding
  bool proved = false;               // whether `coverage` reaches the bound, within 1e-9
};

// A function that the computation calls from time to time. If it returns true, the computation
// ends, with the coverage of all candidates as the bound.
using Stop = std::function<bool()>;

// The greatest number of candidates for which dynamic programming is exact, and the greatest number
// for which it gives a bound. For more candidates, the bound is the coverage of all candidates.
inline constexpr std::size_t most_candidates_proved = 160, most_candidates_bounded = 600;

// Returns the choice of `teams` teams with the greatest coverage found (or the choice of all
// candidates, if there are fewer). `candidates` are in candidate order (algorithm.md, Candidates).
// `start` is a choice of the same number of teams, and is returned if nothing better is found. With
// `stands`, the bound includes choices whose robots collide, but such a choice is not returned. For
// K <= most_candidates_proved candidates, O(n K^2 + K^4 teams). Up to most_candidates_bounded,
// O(n K^2 + K^3 teams). The bound then comes from a ring of ends; if these belong to at most
// `teams` chords, they give the best choice. For more candidates, O(n K) at worst.
Optimum widest_choice(const PolygonWithHoles& object, const Vec2& centre,
                      const std::vector<Candidate>& candidates, std::size_t teams,
                      const std::vector<std::uint32_t>& start, const Stop& stop = {},
                      const Stands* stands = nullptr);

// The greatest number of choices of which choice_to_hold() compares all.
inline constexpr std::uint64_t most_choices = std::uint64_t{1} << 22;

struct ChoiceToHold {
  std::vector<std::uint32_t> taken;
  HoldKeys keys;
  // No choice has a level above most_level, and none with this level covers more than
  // most_coverage, up to rounding.
  std::uint32_t most_level = 3;
  double most_coverage = 1;
  bool compared = false;  // whether all choices were compared
  // Whether it is proved that no choice is better: by all keys if all choices were compared,
  // otherwise by level and coverage only.
  bool proved = false;
};

// Returns the best choice by the keys of the goal `hold` (swaps.h), or nothing if `start` has no
// team or more than most_swapped_teams. If there are more than `most` choices, they are not all
// compared; the result is then the best choice that swaps reach from `start` and from `widest`, the
// result of widest_choice(). In that case most_level is the level that all candidates together
// reach, computed for up to most_candidates_bounded candidates, and most_coverage is the bound of
// `widest`. closure.h explains HoldRequirements; the other parameters are those of widest_choice().
std::optional<ChoiceToHold> choice_to_hold(
    const PolygonWithHoles& object, const Vec2& centre, const std::vector<Candidate>& candidates,
    std::size_t teams, const std::vector<std::uint32_t>& start, const HoldRequirements& hold,
    const Optimum& widest, const Stands* stands = nullptr, std::uint64_t most = most_choices);

// The greedy choice of a document's teams, beside the best ones. The goal does not count for the first
// two.
struct ComparedChoices {
  Placement greedy;
  Optimum widest;
  std::optional<ChoiceToHold> to_hold;  // with the goal `hold`
};

// Compares the choices. It is an error if the method does not choose among candidates, if place()
// refuses the document, or with the goal `hold` if there are more than most_swapped_teams teams.
Result<ComparedChoices> compare_choices(const Document& document, const Stop& stop = {});

// Returns the comparison as `evenlift optimum --json` prints it. Candidates count from 0.
std::string choices_json(const ComparedChoices& compared,
                         const std::vector<std::string>& notices = {});

}  // namespace evenlift
