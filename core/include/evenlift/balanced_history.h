// The sets of a search for balanced robots (balanced.h), and why each was better than the one
// before, for the walkthrough.
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

// The first key in which two sets of the same number of robots differ, if any. At most the cost of
// balanced_keys() for each.
std::optional<BalancedKey> decided_by(const BalancedProblem& problem,
                                      const std::vector<LiftingPoint>& a,
                                      const std::vector<LiftingPoint>& b);

// A set, and how it was found.
struct BalancedSet {
  std::vector<LiftingPoint> robots;  // in their order along the outline
  std::vector<LiftingPoint> kept;    // from the previous set
  std::vector<LiftingPoint> came;    // the others: of three, first the one at a trial point; then
                                     // the ends of an even candidate, which make C the centroid
  bool at_once = false;  // found as a whole, for robots with a size and little room: all are in
                         // `came`, and no chord completes it
};

// A swap.
struct BalancedMove {
  BalancedSet set;                         // after the swap
  std::array<std::uint32_t, 3> numbers{};  // of the robots that left the previous set, increasing
  std::uint32_t round = 0;                 // from 0
  BalancedKey decided_by = BalancedKey::coverage;
};

struct BalancedHistory {
  std::vector<BalancedSet> start;   // the sets S_2, S_3 ... that exist
  bool found = false;               // whether S_m exists, as the last
  std::vector<BalancedMove> moves;  // in order
  std::uint32_t rounds = 0;         // completed
  bool settled = false;             // whether the last round changed nothing
  std::uint32_t triples = 0;        // tried in each round
  std::size_t stands = 0;           // trial points for each triple
};

// Repeats the search or its start, at the same cost. The last set is that of finish_search() or
// start_balanced(), bit for bit.
enum class HistoryLength : std::uint8_t { start, whole };
BalancedHistory balanced_history(const BalancedProblem& problem, HistoryLength length);

// Like is_quick_to_start(), but for the whole search: at most a second or two, judged by the
// completions of the start and three rounds. O(n) at worst.
bool is_quick_to_finish(const BalancedProblem& problem);

// The ways to complete robots by two more: the middle of the two, and the even candidates about it,
// in candidate order. No chords if the middle is not strictly inside the convex hull of P. O(n) at
// worst, usually much less.
struct Completions {
  Vec2 middle = Vec2::Zero();
  std::vector<Chord> chords;
};
Completions completions(const BalancedProblem& problem, const std::vector<LiftingPoint>& robots);

// The best set, if any, in which three new robots, the first at `place`, replace three of `robots`,
// of which there are at least three. One completion for each triple.
std::optional<BalancedMove> best_with_robot_at(const BalancedProblem& problem,
                                               const std::vector<LiftingPoint>& robots,
                                               const LiftingPoint& place);

}  // namespace evenlift
