// "Why not this one?": why a chord through C is not among the teams. output/trace_words.h puts it
// into words.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "evenlift/trace.h"

namespace evenlift {

enum class Why : std::uint8_t {
  no_chord,             // the boundary is not on both sides of C in that direction
  not_by_candidates,    // the method does not choose among candidates
  no_pair,              // its ends are on edges that do not face each other (radial edges)
  too_uneven,           // no chord of its pair meets the minimum ratio
  opposite_too_uneven,  // it joins opposite vertices, and its load ratio is too low
  not_best_of_pair,     // its pair's candidate is another chord
  duplicate,     // its pair's candidate is within tolerance of another pair's, which was kept
  not_even,      // a candidate, but the first team takes an even one
  behind,        // a candidate; another won (see decided_by)
  taken,         // a team has taken it
  cannot_stand,  // robots of the given size cannot stand at both its ends
  collides,      // a candidate; its robots would collide with those of an earlier team
};

struct WhyNot {
  Why why = Why::no_chord;
  Chord chord;
  std::optional<std::uint32_t> pair;       // if it comes from one
  double pair_ratio = 0;                   // the best of that pair
  std::optional<std::uint32_t> candidate;  // itself, or its pair's
  std::uint32_t team = 0;                  // the choice in question; with `taken`, the team itself
  std::uint32_t rank = 0;                  // of the candidate in that choice, from 0
  std::optional<std::uint32_t> winner;     // the candidate that won it
  double value = 0, best = 0;  // score, length or ratio by `rule`: its own, the winner's
  bool exact = true;           // otherwise `value` is an upper bound
  Rule rule = Rule::score;
  DecidedBy decided_by = DecidedBy::first_key;  // the key at which it lost
};

// Why a candidate is not the team chosen at step k or, if that is not a choice, at the last choice
// before it, else at the first. Costs as much as look_at_scores().
WhyNot why_not(const Trace& trace, std::uint32_t k, std::uint32_t candidate);

// The shortest chord through C that reaches `point`, or the longest on that line if none does. Each
// boundary point ahead of C forms a chord with each one behind it; at most 256 are examined.
// Nothing if there is no chord, or if the point is C itself. O(n log n).
std::optional<Chord> chord_at(const Trace& trace, const Vec2& point);

// Why a chord is not a team; Why::no_chord for an empty one. O(n + K), plus the cost of why_not().
WhyNot why_not_chord(const Trace& trace, std::uint32_t k, const std::optional<Chord>& chord);

// Two sets of balanced robots: the one in question, and that of the step (`now`).
struct SetComparison {
  BalancedKeys keys, keys_now;
  std::optional<double> margin, margin_now;  // nothing without contacts
  BalancedKey decided_by = BalancedKey::coverage;
  bool better = false;  // the set in question is
};

// Why no balanced robot stands at a place, or why one does.
struct WhyNoRobot {
  enum class Why : std::uint8_t {
    no_set,             // of three or more robots
    stands_from_start,  // a robot has stood there since the last set of the start
    stands,             // a robot came by a swap
    no_completion,      // no swap of three robots brings one there and keeps C the centroid
    other_set,          // some swaps do: `set` is the best result
  };
  Why why = Why::no_set;
  LiftingPoint place;        // on the boundary
  std::uint32_t robot = 0;   // the robot that stands there
  std::size_t move = 0;      // stands: the swap that brought it
  BalancedSet set;           // other_set
  SetComparison comparison;  // other_set: with the step's set
};

// For the boundary point nearest to `at` and the robots of step k, or those of the last set if
// there are fewer than three. A robot within `reach` of `at` counts as standing there. Costs one
// completion (balanced.h) for each choice of three robots that could leave.
WhyNoRobot why_no_robot(const Trace& trace, std::uint32_t k, const Vec2& at, double reach);

// Compares the sets that another even chord of a completion or swap and the chosen one make.
// `choice` is an index of detail.balanced->chords.
SetComparison compare_even_chord(const Trace& trace, const StepDetail& detail,
                                 std::uint32_t choice);

// The result of another answer about a swap of teams: the best swap of another team, or the same
// team at another candidate.
struct OtherSwap {
  std::uint32_t team = 0;
  std::optional<std::uint32_t> candidate;  // nothing if no swap of that team improves the choice
  HoldKeys keys;                           // of all teams, if there is a candidate
};
// At worst one round of swaps of one team (swaps.h).
OtherSwap compare_swap(const Trace& trace, const StepDetail& detail, const Question& question,
                       std::uint32_t choice);

}  // namespace evenlift
