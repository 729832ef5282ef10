// "Why not this one?" says as data why a chord through C is not among the teams. The words for it
// are in output/trace_words.h.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "evenlift/trace.h"

namespace evenlift {

enum class Why : std::uint8_t {
  no_chord,             // there is no boundary on both sides of C in that direction
  not_by_candidates,    // the method does not choose among candidates
  no_pair,              // its ends lie on edges that do not face each other (radial ones)
  too_uneven,           // no chord of its pair has the minimum load ratio
  opposite_too_uneven,  // it lies between two opposite vertices, and its load ratio is too low
  not_best_of_pair,     // its pair's candidate is another chord
  duplicate,            // its pair's candidate is within tolerance of another pair's, which stands
  not_even,             // a candidate; the first team is chosen among the even ones only
  behind,               // a candidate; another one won (see decided_by)
  taken,                // a team has taken it
  cannot_stand,         // robots of the given size cannot stand at both of its ends
  collides,             // a candidate; its robots would collide with those of an earlier team
};

struct WhyNot {
  Why why = Why::no_chord;
  Chord chord;                             // the one asked about
  std::optional<std::uint32_t> pair;       // its edge-pair, where it comes from one
  double pair_ratio = 0;                   // the best ratio in that pair
  std::optional<std::uint32_t> candidate;  // the candidate it is, or that its pair led to instead
  std::uint32_t team = 0;  // the choice that is spoken of; with `taken` the team itself
  std::uint32_t rank = 0;  // of the candidate in that choice, from 0
  std::optional<std::uint32_t> winner;  // the candidate that won it
  double value = 0, best = 0;           // score, length or ratio by `rule`: its own, the winner's
  bool exact = true;                    // else `value` is an upper bound
  Rule rule = Rule::score;
  DecidedBy decided_by = DecidedBy::first_key;  // the key at which it lost
};

// Why candidate `candidate` is not the team that is chosen at step k or, at a step that is no
// choice, the last one before (the first, before any). The cost of look_at_scores.
WhyNot why_not(const Trace& trace, std::uint32_t k, std::uint32_t candidate);

// Of the chords through C and `point`, of which there is one for each boundary point ahead of C
// with each one behind it, the shortest that reaches the point, or the longest if none does.
// Nothing if there is no chord, or if the point is C itself. Looks at 256 chords at most. O(n log
// n).
std::optional<Chord> chord_at(const Trace& trace, const Vec2& point);

// Why a chord such as that of chord_at() is not a team; with nothing, why there is no chord.
// O(n + K), besides the cost of why_not.
WhyNot why_not_chord(const Trace& trace, std::uint32_t k, const std::optional<Chord>& chord);

// Two sets of balanced robots by their keys.
struct SetComparison {
  BalancedKeys keys, keys_now;               // of the set asked about, and of that of the step
  std::optional<double> margin, margin_now;  // none without contacts
  BalancedKey decided_by = BalancedKey::coverage;
  bool better = false;  // whether the set asked about is the better one
};

// Why no balanced robot stands at a place, or why one does.
struct WhyNoRobot {
  enum class Why : std::uint8_t {
    no_set,             // three robots are not found yet
    stands_from_start,  // a robot stands there since the last set of the start
    stands,             // a robot came there by an exchange
    no_completion,      // no set of three others with one at the place has the centroid C
    other_set,          // some have: `set` is the best of them
  };
  Why why = Why::no_set;
  LiftingPoint place;        // the point of the boundary that is asked about
  std::uint32_t robot = 0;   // stands: its number
  std::size_t move = 0;      // stands: the exchange by which it came
  BalancedSet set;           // other_set
  SetComparison comparison;  // other_set: of that set with the step's
};

// Answers for the boundary point nearest to `at` and the robots of step k, or those of the last set
// if they are fewer than three. A robot within `reach` of `at` counts as standing there. The cost
// is one completion (balanced.h) for each three robots that could leave.
WhyNoRobot why_no_robot(const Trace& trace, std::uint32_t k, const Vec2& at, double reach);

// What the other robots and another of the even chords of a completion or an exchange would make,
// compared with what the chosen one makes. `choice` is an index of detail.balanced->chords.
SetComparison compare_even_chord(const Trace& trace, const StepDetail& detail,
                                 std::uint32_t choice);

// What another answer to a question about an exchange of teams would come to: the best exchange of
// another team, or the same team at another candidate.
struct OtherSwap {
  std::uint32_t team = 0;
  std::optional<std::uint32_t> candidate;  // none: no exchange of that team makes the choice better
  HoldKeys keys;                           // of all teams, if there is a candidate
};
// A round of exchanges of one team at worst (exchange.h).
OtherSwap compare_swap(const Trace& trace, const StepDetail& detail, const Question& question,
                       std::uint32_t choice);

}  // namespace evenlift
