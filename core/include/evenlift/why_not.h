// "Why not this one?": why a chord through C is not among the teams, as data. output/trace_words.h
// puts it into words.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "evenlift/trace.h"

namespace evenlift {

enum class Why : std::uint8_t {
  no_chord,             // the boundary is not on both sides of C in that direction
  not_by_candidates,    // the method does not choose among candidates
  no_pair,              // its ends lie on edges that do not face each other (radial edges)
  too_uneven,           // no chord of its pair meets the minimum ratio
  opposite_too_uneven,  // it joins two opposite vertices, and its load ratio is too low
  not_best_of_pair,     // its pair's candidate is another chord
  duplicate,  // its pair's candidate is within tolerance of another pair's, which was kept instead
  not_even,   // a candidate; the first team is chosen among the even ones only
  behind,     // a candidate; another one won (see decided_by)
  taken,      // a team has taken it
  cannot_stand,  // robots of the given size cannot stand at both its ends
  collides,      // a candidate; its robots would collide with those of an earlier team
};

struct WhyNot {
  Why why = Why::no_chord;
  Chord chord;                             // the chord in question
  std::optional<std::uint32_t> pair;       // its edge pair, if it comes from one
  double pair_ratio = 0;                   // the best ratio in that pair
  std::optional<std::uint32_t> candidate;  // itself, or the candidate of its pair
  std::uint32_t team = 0;                  // the choice in question; with `taken`, the team itself
  std::uint32_t rank = 0;                  // the rank of the candidate in that choice, from 0
  std::optional<std::uint32_t> winner;     // the candidate that won that choice
  double value = 0, best = 0;  // score, length or ratio by `rule`: its own, the winner's
  bool exact = true;           // otherwise `value` is an upper bound
  Rule rule = Rule::score;
  DecidedBy decided_by = DecidedBy::first_key;  // the key at which it lost
};

// Why candidate `candidate` is not the team chosen at step k. If that step is not a choice, the
// last choice before it counts, or the first choice if there is none before it. Costs as much as
// look_at_scores().
WhyNot why_not(const Trace& trace, std::uint32_t k, std::uint32_t candidate);

// The shortest chord through C that reaches `point`, or the longest on that line if none does. Each
// boundary point ahead of C forms a chord with each one behind it. Nothing if there is no chord, or
// if the point is C itself. At most 256 chords are examined. O(n log n).
std::optional<Chord> chord_at(const Trace& trace, const Vec2& point);

// Why a chord, such as that of chord_at(), is not a team; for an empty `chord`, Why::no_chord.
// O(n + K), plus the cost of why_not().
WhyNot why_not_chord(const Trace& trace, std::uint32_t k, const std::optional<Chord>& chord);

// Two sets of balanced robots, compared by their keys.
struct SetComparison {
  BalancedKeys keys, keys_now;               // of the set in question, and of the step's set
  std::optional<double> margin, margin_now;  // nothing without contacts
  BalancedKey decided_by = BalancedKey::coverage;
  bool better = false;  // whether the set in question is better
};

// Why no balanced robot stands at a place, or why one does.
struct WhyNoRobot {
  enum class Why : std::uint8_t {
    no_set,             // there is no set of three or more robots
    stands_from_start,  // a robot has stood there since the last set of the start
    stands,             // a robot came there by a swap
    no_completion,      // no swap of three robots brings one there and keeps C the centroid
    other_set,          // some swaps do: `set` is the best result
  };
  Why why = Why::no_set;
  LiftingPoint place;        // the boundary point in question
  std::uint32_t robot = 0;   // the number of the robot that stands there
  std::size_t move = 0;      // stands: the swap that brought the robot
  BalancedSet set;           // other_set
  SetComparison comparison;  // other_set: that set compared with the step's
};

// The answer for the boundary point nearest to `at` and the robots of step k. If step k has fewer
// than three robots, those of the last set count. A robot within `reach` of `at` counts as standing
// there. Costs one completion (balanced.h) for each choice of three robots that could leave.
WhyNoRobot why_no_robot(const Trace& trace, std::uint32_t k, const Vec2& at, double reach);

// Compares the set that another even chord of a completion or swap would make with the set that the
// chosen chord makes. `choice` is an index of detail.balanced->chords.
SetComparison compare_even_chord(const Trace& trace, const StepDetail& detail,
                                 std::uint32_t choice);

// The result of another answer to a question about a swap of teams: the best swap of another team,
// or the same team at another candidate.
struct OtherSwap {
  std::uint32_t team = 0;
  std::optional<std::uint32_t> candidate;  // nothing if no swap of that team improves the choice
  HoldKeys keys;                           // of all teams, if there is a candidate
};
// At worst one round of swaps of one team (swaps.h).
OtherSwap compare_swap(const Trace& trace, const StepDetail& detail, const Question& question,
                       std::uint32_t choice);

}  // namespace evenlift
