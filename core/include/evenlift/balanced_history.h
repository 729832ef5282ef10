// The history of a search for balanced robots: its sets, and why each was better than the one
// before. The walkthrough shows it; balanced.h defines the search itself.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "evenlift/balanced.h"

namespace evenlift {

// The keys of balanced.h, in their order.
enum class BalancedKey : std::uint8_t { near_pairs, steady, level, coverage, spread, places };

// The first key in which two sets of the same number of robots differ; nothing if they tie in all
// keys. At most the cost of balanced_keys() for each set.
std::optional<BalancedKey> decided_by(const BalancedProblem& problem,
                                      const std::vector<LiftingPoint>& a,
                                      const std::vector<LiftingPoint>& b);

// A set, and how it was found.
struct BalancedSet {
  std::vector<LiftingPoint> robots;  // in their order along the outline
  std::vector<LiftingPoint> kept;    // the robots that stayed from the previous set
  std::vector<LiftingPoint> came;    // the others: two at the ends of an even candidate about the
                                     // point that makes C the centroid of all; if there are three,
                                     // the one at a trial point is first
  bool at_once = false;  // found as a whole, for robots with a size and little room: then all
                         // robots are in `came`, and no chord completes the set
};

// A swap that was made.
struct BalancedMove {
  BalancedSet set;                         // after the swap
  std::array<std::uint32_t, 3> numbers{};  // the robots that left the previous set, increasing
  std::uint32_t round = 0;                 // from 0
  BalancedKey decided_by = BalancedKey::coverage;
};

struct BalancedHistory {
  std::vector<BalancedSet> start;   // the sets S_2, S_3 ... that exist (start_balanced())
  bool found = false;               // whether S_m exists: then it is the last of them
  std::vector<BalancedMove> moves;  // in order
  std::uint32_t rounds = 0;         // the number of completed rounds
  bool settled = false;             // whether the last round changed nothing
  std::uint32_t triples = 0;        // the number tried in each round
  std::size_t stands = 0;           // the number of trial points for each triple
};

// Repeats the search, to its end or only its start. The last set is that of start_balanced() or
// finish_search(), bit for bit, and the cost is the same.
enum class HistoryLength : std::uint8_t { start, whole };
BalancedHistory balanced_history(const BalancedProblem& problem, HistoryLength length);

// Whether the whole search is expected to take at most a second or two, judged like
// is_quick_to_start(), but by the completions of the start and of three rounds. O(n) at worst.
bool is_quick_to_finish(const BalancedProblem& problem);

// The ways to complete robots by two more: the point that must be the middle of the two, and the
// even candidates about it, in candidate order. There are no chords if the point is not strictly
// inside the convex hull of P. O(n) at worst, usually much less.
struct Completions {
  Vec2 middle = Vec2::Zero();
  std::vector<Chord> chords;
};
Completions completions(const BalancedProblem& problem, const std::vector<LiftingPoint>& robots);

// The best set in which three new robots, the first of them at `place`, replace three of `robots`;
// nothing if there is none. There must be at least three robots. One completion for each triple.
std::optional<BalancedMove> best_with_robot_at(const BalancedProblem& problem,
                                               const std::vector<LiftingPoint>& robots,
                                               const LiftingPoint& place);

}  // namespace evenlift
