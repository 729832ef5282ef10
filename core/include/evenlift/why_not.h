// Answers to "Why not this one?": why a chord through C is not among the teams, or why no balanced
// robot stands at a place. output/trace_words.h puts the answers into words.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "evenlift/trace.h"

namespace evenlift {

// The reasons. In the comments, "it" is the chord in question.
enum class Why : std::uint8_t {
  no_chord,             // the boundary is not on both sides of C in that direction
  not_by_candidates,    // the method does not choose among candidates
  no_pair,              // its ends are on edges that form no pair, such as radial edges
  too_uneven,           // no chord of its pair meets the minimum ratio
  opposite_too_uneven,  // it joins opposite vertices, and its load ratio is too low
  not_best_of_pair,     // its pair's candidate is another chord
  duplicate,            // it is a duplicate of another pair's candidate, which was kept
  not_even,      // it is a candidate but not even, and the first team takes an even candidate
  behind,        // it is a candidate, but another candidate won (see decided_by)
  taken,         // a team has taken it
  cannot_stand,  // robots of the given size cannot stand at both its ends
  collides,      // it is a candidate, but its robots would collide with those of an earlier team
};

struct WhyNot {
  Why why = Why::no_chord;
  Chord chord;
  std::optional<std::uint32_t> pair;       // the edge pair of the chord, if any
  double pair_ratio = 0;                   // the best ratio on that pair
  std::optional<std::uint32_t> candidate;  // the chord itself, or the candidate of its pair
  std::uint32_t team = 0;  // the team whose choice is in question; if `taken`, the chord's own team
  std::uint32_t rank = 0;  // the candidate's rank in this choice, from 0
  std::optional<std::uint32_t> winner;  // the candidate that won this choice
  // The score, length or ratio (see `rule`) of the candidate, and the same for the winner.
  double value = 0, best = 0;
  bool exact = true;  // whether `value` is exact; otherwise it is an upper bound
  Rule rule = Rule::score;
  DecidedBy decided_by = DecidedBy::first_key;  // the key at which the candidate lost
};

// Why a candidate does not win the choice that step k belongs to. If step k belongs to no choice,
// the answer is about the last choice before step k or, without one, about the first choice. If an
// earlier team has taken the candidate, the answer is about that team. Costs as much as
// look_at_scores().
WhyNot why_not(const Trace& trace, std::uint32_t k, std::uint32_t candidate);

// The shortest chord through C that reaches `point` or, if no chord does, the longest chord on the
// line through C and `point`. On this line, each boundary point on one side of C forms a chord with
// each boundary point on the other side; at most 256 chords are examined. Returns nothing if there
// is no chord, or if the point is C itself. O(n log n).
std::optional<Chord> chord_at(const Trace& trace, const Vec2& point);

// Why no team stands on a chord; the answer is Why::no_chord if `chord` is empty. O(n + K), plus
// the cost of why_not().
WhyNot why_not_chord(const Trace& trace, std::uint32_t k, const std::optional<Chord>& chord);

// Compares two sets of balanced robots: the set in question, and the set of the step (`_now`).
struct SetComparison {
  BalancedKeys keys, keys_now;
  std::optional<double> margin, margin_now;  // empty without contacts
  BalancedKey decided_by = BalancedKey::coverage;
  bool better = false;  // whether the set in question is better
};

// Why no balanced robot stands at a place, or why one does.
struct WhyNoRobot {
  enum class Why : std::uint8_t {
    no_set,             // there is no set of three or more robots
    stands_from_start,  // a robot stood there before the first swap, and stays
    stands,             // a robot came there by a swap
    no_completion,      // no swap of three robots puts one there and keeps the centroid at C
    other_set,          // some swaps put a robot there; `set` is the best result
  };
  Why why = Why::no_set;
  LiftingPoint place;        // the boundary point in question
  std::uint32_t robot = 0;   // the robot that stands there, if any
  std::size_t move = 0;      // with `stands`: the index of the swap that put it there
  BalancedSet set;           // with `other_set`: the best set with a robot there
  SetComparison comparison;  // with `other_set`: `set` and the step's set
};

// Answers for the boundary point nearest to `at` and the robots of step k or, if step k has fewer
// than three robots, those of the last set. A robot within `reach` of `at` counts as standing
// there. Costs one completion (balanced.h) for each choice of three robots that could leave.
WhyNoRobot why_no_robot(const Trace& trace, std::uint32_t k, const Vec2& at, double reach);

// For a step that is a completion or swap: compares the set that another even chord would make with
// that of the chosen chord. `choice` is the other chord's index in detail.balanced->chords.
SetComparison compare_even_chord(const Trace& trace, const StepDetail& detail,
                                 std::uint32_t choice);

// The swap that would follow from a learner's wrong answer about a swap of teams (QuestionKind):
// the best swap of the answer's team, or a move of the right team to the answer's candidate.
struct OtherSwap {
  std::uint32_t team = 0;
  std::optional<std::uint32_t> candidate;  // empty if no swap of that team improves the choice
  HoldKeys keys;                           // of the choice after the swap, if there is one
};
// The swap that would follow from the answer `choice`. Costs at most one round of swaps of one team
// (swaps.h).
OtherSwap compare_swap(const Trace& trace, const StepDetail& detail, const Question& question,
                       std::uint32_t choice);

}  // namespace evenlift
