// Balanced robots: m robots whose centroid is C. If W is the weight, forces of W / m each add up to
// W, and their moments about C cancel, so all robots can carry the same load. They do if forces are
// controlled, or if all robots are equally stiff and level and the object does not bend; three
// robots that are not on one line always do. Two robots with equal arms are the smallest case. This
// is beyond the thesis, which calls for such methods in 6.2; algorithm.md, Balanced robots, gives
// the definition.
//
// A local search finds the robots among sets whose centroid is C. The outline of P begins at v*,
// the vertex farthest from C (if several are farthest within tau L, the leftmost of them, then the
// lowest), runs once round counter-clockwise and has the length Lambda. The trial points are the 64
// points at (j + 1/2) Lambda / 64, followed by the reflex vertices if there are at most 64 of them.
// If P has more than 1,000 vertices, both numbers are 16. Robots Q are completed to m = |Q| + 2
// robots by the ends of an even candidate about (m C - sum Q) / 2, if that point is strictly inside
// the convex hull of P. They are completed to m = |Q| + 3 robots by a trial point b and the ends of
// an even candidate for Q and b.
//
// The better of two sets is ahead in the first key in which they differ:
// 1. fewer pairs of robots nearer to each other than `apart`;
// 2. with survive = F > 0: the larger min(F, number of failures that leave C at least `clear`
//    inside the hull of the rest);
// 3. for the goal hold: the larger number of thresholds reached by the margin of the contacts that
//    are at least `clear` from every corner (the thresholds are 0.001, 0.4 mu and mu, where mu is
//    min_margin);
// 4. the larger coverage, by more than 1e-9;
// 5. the larger sum of |p - C|^2, by more than 1e-9 of it;
// 6. the robots' places along the outline, compared in order: where two of them first differ by
//    more than tau Lambda, the smaller place.
// If all keys tie, the set found first stays.
//
// Robots that hold a constant force give no righting moment: coverage and H presume robots that
// push back because they are stiff or because their height is controlled.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "evenlift/chords.h"
#include "evenlift/document.h"
#include "evenlift/polygon_with_holes.h"

namespace evenlift {

namespace balanced {
class Rules;
}

// The object, C and the settings robots, goal, min_margin, apart, clear, survive, robot and no_go,
// with everything that is computed from them only once. If robots have a size or there are no-go
// parts, the trial points are spread over the usable parts of the outline, and the search considers
// only sets in which every robot can stand. Immutable; copies share the data.
class BalancedProblem {
 public:
  // The settings must be in their ranges. O(n log n), plus the cost of Stands (stands.h).
  BalancedProblem(PolygonWithHoles object, const Vec2& centre, const Settings& settings);

  const balanced::Rules& rules() const { return *rules_; }

 private:
  std::shared_ptr<const balanced::Rules> rules_;
};

// The keys of a set of robots. `level` is 0 for the goal cover.
struct BalancedKeys {
  std::uint32_t near_pairs = 0;  // key 1
  int steady = 0;                // key 2, -1 .. F
  std::uint32_t level = 0;       // key 3, 0 .. 3
  double coverage = 0;           // key 4
  double spread = 0;             // key 5, in squared units of length
  std::vector<double> places;    // key 6, ascending, in [0, Lambda)
};
// O(m^2 + m log n), and O(n m) for the coverage at worst.
BalancedKeys balanced_keys(const BalancedProblem& problem, const std::vector<LiftingPoint>& robots);

// Whether the first set is better than the second. At most the cost of balanced_keys() for each.
bool is_better(const BalancedProblem& problem, const std::vector<LiftingPoint>& a,
               const std::vector<LiftingPoint>& b);

// The state of a search. It can be kept, copied, and continued elsewhere, since the search depends
// only on it and the problem.
struct BalancedSearch {
  std::vector<LiftingPoint> robots;  // in their order along the outline
  std::uint32_t round = 0;           // rounds that have ended
  std::uint32_t next = 0;            // the next triple of the current round, counted from 0
  bool changed = false;              // whether the current round has swapped anything
  bool finished = false;             // after a round without a change, or after most_rounds
  bool restarted = false;            // whether the search has looked for a second start
  std::uint64_t work = 0;            // the cost of the triples so far, in the units of most_work
  bool cut_short = false;            // whether the search finished because of most_work
};
inline constexpr std::uint32_t most_rounds = 8;

// The limit on work if the boundary (PolygonWithHoles::boundary()) has more than 1,000 vertices.
// Work is counted, not timed, so every platform ends with the same robots. Each completion counts
// 1, plus 1 for every 100 even candidates about C.
inline constexpr std::uint64_t most_work = 150'000;

// Starts the search: S_i is the better of S_(i-2) with two more robots and S_(i-3) with three more,
// for i = 2 .. m from the empty S_0. For m = 4, and where S_4 would not exist, a trial point with
// three more robots is also considered. Nothing if there is no set of m robots. For s trial points,
// usually 64 to 128, at most (s + 1) m completions, and s^2 more where a trial point gets three
// more robots. A completion is the search for the even candidates about one point: O(n) at worst,
// usually much less.
std::optional<BalancedSearch> start_balanced(const BalancedProblem& problem);

// Whether the start is expected to take less than a few tenths of a second, so that an interactive
// program need not search in the background. The estimate counts completions and even candidates
// about C, so it is the same on every platform. Combs and spiky stars with a few hundred vertices
// are slow, and so are four robots on a winding outline. O(n) at worst.
bool is_quick_to_start(const BalancedProblem& problem);

// Three robots that a swap moved to other places, by their numbers before the swap.
struct BalancedSwap {
  std::array<std::uint32_t, 3> numbers{};
  std::array<LiftingPoint, 3> from, to;
};

// One step of a search. A search goes through the triples i < j < k of robots; with more than 12
// robots only triples that contain two neighbours along the outline, with more than 24 only three
// in a row. For each triple, the search compares the current set and then all sets that complete
// the other robots by three more. The best becomes the current set (if several are best, the first
// of them). After each swap the robots are renumbered. A round that changes nothing is the last:
// then no swap makes the set better. A triple costs one completion for each trial point.
//
// A search restarts, at most once, if that leads to a better set (docs/algorithm.md). If the robots
// should hold the object and do not, it restarts with S_4 also chosen among trial points with three
// more robots, as for m = 4. For robots with a size, which fit in few places, it tries the best
// sets on usable intervals, and restarts from the one that leads to the best result.
struct BalancedStep {
  BalancedSearch search;             // after the step
  std::optional<BalancedSwap> swap;  // the swap, if there was one
};
BalancedStep try_next_triple(const BalancedProblem& problem, BalancedSearch search);

// Runs the search to its end: try_next_triple() until it is finished.
BalancedSearch finish_search(const BalancedProblem& problem, BalancedSearch search);

// The robots, at least three, after the user moves one of them along the outline. Its two
// neighbours in the list follow, so that C stays the centroid: they move to the ends of the even
// candidate for which the sum of their squared moves is least. Nothing if there is no such
// candidate: the robot cannot move there. If robots have a size, `to` is the robot's contact, and
// the robot cannot move to a place where it would not fit or would collide. O(n) at worst, like a
// completion.
std::optional<std::vector<LiftingPoint>> move_robot(const BalancedProblem& problem,
                                                    std::vector<LiftingPoint> robots,
                                                    std::size_t moved, const LiftingPoint& to);

}  // namespace evenlift
