// The sets of a search for balanced robots (balanced.h), for the walkthrough, and why each set was
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

// The first key in which two sets of the same number of robots differ; nothing if all keys tie. At
// most the cost of balanced_keys() for each.
std::optional<BalancedKey> decided_by(const BalancedProblem& problem,
                                      const std::vector<LiftingPoint>& a,
                                      const std::vector<LiftingPoint>& b);

// A set, and how it was found.
struct BalancedSet {
  std::vector<LiftingPoint> robots;  // in their order along the outline
  std::vector<LiftingPoint> kept;    // the robots that were in the previous set
  std::vector<LiftingPoint> came;    // the new robots: if there are three, first the one at a trial
                                     // point; then the ends of an even candidate, which make C the
                                     // centroid
  bool at_once = false;  // whether the set was found as a whole, for robots with a size and little
                         // room: all robots are in `came`, and no chord completes the set
};

// A swap of a search.
struct BalancedMove {
  BalancedSet set;                                 // after the swap
  std::array<std::uint32_t, 3> numbers{};          // of the robots that left, in ascending order
  std::uint32_t round = 0;                         // from 0
  BalancedKey decided_by = BalancedKey::coverage;  // the key by which the set is better
};

struct BalancedHistory {
  std::vector<BalancedSet> start;   // the sets S_2, S_3 ... that exist
  bool found = false;               // whether S_m exists; it is the last of `start`
  std::vector<BalancedMove> moves;  // the swaps, in order
  std::uint32_t rounds = 0;         // number of completed rounds
  bool settled = false;             // whether the last round changed nothing
  std::uint32_t triples = 0;        // number of triples tried in each round
  std::size_t stands = 0;           // number of trial points for each triple
};

// balanced_history() repeats the whole search or only its start, at the same cost. The last set is
// that of finish_search() or start_balanced(), bit for bit. If the search restarts, the history
// begins with the second start.
enum class HistoryLength : std::uint8_t { start, whole };
BalancedHistory balanced_history(const BalancedProblem& problem, HistoryLength length);

// Whether the whole search is expected to take at most a second or two. The estimate is that of
// is_quick_to_start(), but for the completions of the start and of three rounds. O(n) at worst.
bool is_quick_to_finish(const BalancedProblem& problem);

// The ways to complete robots by two more: the middle of these two, and the even candidates about
// the middle, in candidate order. There are no chords if the middle is not strictly inside the
// convex hull of P. O(n) at worst, usually much less.
struct Completions {
  Vec2 middle = Vec2::Zero();
  std::vector<Chord> chords;
};
Completions completions(const BalancedProblem& problem, const std::vector<LiftingPoint>& robots);

// The best set in which three new robots, the first at `place`, replace three of the `robots`;
// nothing if there is no such set. There must be at least three robots. Costs one completion for
// each triple.
std::optional<BalancedMove> best_with_robot_at(const BalancedProblem& problem,
                                               const std::vector<LiftingPoint>& robots,
                                               const LiftingPoint& place);

}  // namespace evenlift
