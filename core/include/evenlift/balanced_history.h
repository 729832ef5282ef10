// For the walkthrough: the sets of a search for balanced robots (balanced.h), and why each set was
// better than the one before.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "evenlift/balanced.h"

namespace evenlift {

// The keys of balanced.h, in order.
enum class BalancedKey : std::uint8_t { near_pairs, steady, level, coverage, spread, places };

// The first key in which two sets of the same number of robots differ; nothing if all keys tie.
// Costs at most balanced_keys() for each set.
std::optional<BalancedKey> decided_by(const BalancedProblem& problem,
                                      const std::vector<LiftingPoint>& a,
                                      const std::vector<LiftingPoint>& b);

// A set, and how it was found.
struct BalancedSet {
  std::vector<LiftingPoint> robots;  // in their order along the outline
  std::vector<LiftingPoint> kept;    // the robots that were already in an earlier set
  // The new robots. The last two are at the ends of an even candidate, so that C is the centroid.
  // If there are three, the first is at a trial point.
  std::vector<LiftingPoint> came;
  // Whether the set was found as a whole, which can happen if robots have a size or if there are
  // no-go parts. Then all robots are in `came`; none need be at the ends of an even candidate.
  bool at_once = false;
};

// A swap of a search.
struct BalancedMove {
  BalancedSet set;                                 // after the swap
  std::array<std::uint32_t, 3> numbers{};          // of the robots that left, ascending
  std::uint32_t round = 0;                         // from 0
  BalancedKey decided_by = BalancedKey::coverage;  // the key that makes the set better
};

struct BalancedHistory {
  std::vector<BalancedSet> start;   // the sets S_2, S_3 ... that exist
  bool found = false;               // whether the last set of `start` has all m robots
  std::vector<BalancedMove> moves;  // the swaps, in order
  std::uint32_t rounds = 0;         // number of completed rounds
  bool settled = false;             // whether the last round changed nothing
  std::uint32_t triples = 0;        // number of triples tried in each round
  std::size_t stands = 0;           // number of trial points for each triple
};

// balanced_history() repeats the whole search (finish_search()) or only its start
// (start_balanced()), at the same cost and, bit for bit, with the same last set. If the search
// restarts, the history begins with the second start.
enum class HistoryLength : std::uint8_t { start, whole };
BalancedHistory balanced_history(const BalancedProblem& problem, HistoryLength length);

// Whether the whole search is expected to take at most a second or two. The estimate is like that
// of is_quick_to_start(), and also counts the completions of three rounds (for each possible start,
// if robots have a size or there are no-go parts). O(n) at worst.
bool is_quick_to_finish(const BalancedProblem& problem);

// The ways to complete a set of robots with two more: `middle` is the midpoint of the two, and
// `chords` are the even candidates about `middle`, in candidate order (only some of them if P has
// more than 1,000 vertices). There are no chords if `middle` is not strictly inside the convex hull
// of P. O(n) at worst, usually much less.
struct Completions {
  Vec2 middle;
  std::vector<Chord> chords;
};
Completions completions(const BalancedProblem& problem, const std::vector<LiftingPoint>& robots);

// The best set in which three new robots, the first of them at `place`, replace three of the
// `robots`; nothing if there is no such set. There must be at least three robots. Costs one
// completion for each triple.
std::optional<BalancedMove> best_with_robot_at(const BalancedProblem& problem,
                                               const std::vector<LiftingPoint>& robots,
                                               const LiftingPoint& place);

}  // namespace evenlift
