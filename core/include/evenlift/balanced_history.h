// The story of a search for balanced robots: the sets that it went through, and why each was better
// than the one before. It is what a lesson shows; balanced.h defines the search itself.
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

// The first key in which two sets of equally many robots differ; nothing if they tie in all. The
// cost is that of balanced_keys() at most, for each set.
std::optional<BalancedKey> decided_by(const BalancedProblem& problem,
                                      const std::vector<LiftingPoint>& a,
                                      const std::vector<LiftingPoint>& b);

// A set, and how it came about.
struct BalancedSet {
  std::vector<LiftingPoint> robots;  // in their order along the outline
  std::vector<LiftingPoint> kept;    // those of them that stood there before
  std::vector<LiftingPoint> came;    // the others: two at the ends of an even candidate about the
                                     // point that makes C the centroid of all; if there are three,
                                     // the one on a stand comes first
  bool at_once = false;  // found as a whole where robots with a size have little room: then
                         // all of them came, and no chord completes the set
};

// An exchange that was made.
struct BalancedMove {
  BalancedSet set;                         // afterwards
  std::array<std::uint32_t, 3> numbers{};  // the robots of the set before that left, increasing
  std::uint32_t round = 0;                 // from 0
  BalancedKey decided_by = BalancedKey::coverage;
};

struct BalancedHistory {
  std::vector<BalancedSet> start;   // those of S_2, S_3 ... that exist (start_balanced())
  bool found = false;               // whether S_m exists: then it is the last of them
  std::vector<BalancedMove> moves;  // in their order
  std::uint32_t rounds = 0;         // rounds that were gone through to their end
  bool settled = false;             // whether the last of them changed nothing
  std::uint32_t triples = 0;        // tried in each round
  std::size_t stands = 0;           // tried for each triple
};

// The search once more, to its end or only its start. The last set is that of start_balanced or
// finish_search, bit for bit, and it costs as much.
enum class HistoryLength : std::uint8_t { start, whole };
BalancedHistory balanced_history(const BalancedProblem& problem, HistoryLength length);

// Whether the whole search surely takes no more than a second or two, as is_quick_to_start() judges
// the start: by the completions of three rounds. O(n) at worst.
bool is_quick_to_finish(const BalancedProblem& problem);

// What completes robots by two more: the point that must be the middle between the two, and the
// even candidates about it, in candidate order; none if the point is not strictly inside the convex
// hull of P. O(n) at worst, and much less as a rule.
struct Completions {
  Vec2 middle = Vec2::Zero();
  std::vector<Chord> chords;
};
Completions completions(const BalancedProblem& problem, const std::vector<LiftingPoint>& robots);

// The best set that comes of one of at least three robots if three of them leave and the first of
// three others comes to `place`; nothing if there is none. One completion for each triple.
std::optional<BalancedMove> best_with_robot_at(const BalancedProblem& problem,
                                               const std::vector<LiftingPoint>& robots,
                                               const LiftingPoint& place);

}  // namespace evenlift
