// Balanced robots: m robots whose centroid is C, so that equal forces W / m carry the weight W. The
// loads are equal if forces are controlled, or if all robots are equally stiff and level and the
// object does not bend; for three robots that are not on one line, they always are. Two robots with
// equal arms are the smallest case. Beyond the thesis, which calls for such methods in 6.2. The
// full definition is in algorithm.md, Balanced robots.
//
// A local search compares sets by these keys, in order. If all tie, the set found first is better.
// 1. fewer pairs of robots nearer to each other than `apart`;
// 2. with survive = F > 0: more failures, counted up to F, that leave C at least `clear` inside the
//    hull of the rest;
// 3. for the goal hold: more of the thresholds 0.001, 0.4 mu and mu reached by the margin of the
//    contacts at least `clear` from every corner (mu is min_margin);
// 4. the larger coverage, by more than 1e-9;
// 5. the larger sum of |p - C|^2, by more than 1e-9 of it;
// 6. the smaller place, where the places along the outline first differ by more than tau Lambda.
//    The outline, of length Lambda, runs counter-clockwise from the vertex farthest from C.
//
// Coverage and H presume robots that push back because they are stiff or their height is
// controlled; constant forces give no righting moment.
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

// The object, C, the settings robots, goal, min_margin, apart, clear, survive, robot and no_go, and
// what is computed from them only once. If robots have a size or there are no-go parts, trial
// points are on the usable parts of the outline, and every robot of a set can stand there.
// Immutable; copies share the data.
class BalancedProblem {
 public:
  // The settings must be in their ranges. O(n log n), plus the cost of Stands (stands.h).
  BalancedProblem(PolygonWithHoles object, const Vec2& centre, const Settings& settings);

  const balanced::Rules& rules() const { return *rules_; }

 private:
  std::shared_ptr<const balanced::Rules> rules_;
};

// The keys of a set. `level` is 0 for the goal cover.
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

// Whether `a` is better than `b`. At most the cost of balanced_keys() for each.
bool is_better(const BalancedProblem& problem, const std::vector<LiftingPoint>& a,
               const std::vector<LiftingPoint>& b);

// The state of a search. The search depends only on it and the problem, so it can be copied and
// continued elsewhere.
struct BalancedSearch {
  std::vector<LiftingPoint> robots;  // in their order along the outline
  std::uint32_t round = 0;           // rounds that have ended
  std::uint32_t next = 0;            // the next triple of the round, from 0
  bool changed = false;              // whether this round has swapped anything
  bool finished = false;             // after a round without a change, or most_rounds
  bool restarted = false;            // whether a second start was looked for
  std::uint64_t work = 0;            // the cost of the triples so far, see most_work
  bool cut_short = false;            // whether most_work ended the search
};
inline constexpr std::uint32_t most_rounds = 8;

// The limit on work if the boundary (PolygonWithHoles::boundary()) has more than 1,000 vertices. It
// is counted, not timed, so that platforms agree: a completion counts 1, plus 1 for every 100 even
// candidates about C.
inline constexpr std::uint64_t most_work = 150'000;

// Starts a search with the set S_m of algorithm.md; nothing if there is none. For s trial points,
// usually 64 to 128, at most (s + 1) m completions, and s^2 more for m = 4 or if S_4 would not
// exist otherwise. A completion finds the even candidates about one point: O(n) at worst, usually
// much less.
std::optional<BalancedSearch> start_balanced(const BalancedProblem& problem);

// Whether the start should take less than a few tenths of a second, so that it need not run in the
// background. The estimate counts completions and even candidates about C, so platforms agree.
// Combs and spiky stars of a few hundred vertices are slow, and so are four robots on a winding
// outline. O(n) at worst.
bool is_quick_to_start(const BalancedProblem& problem);

// The moved robots, by their numbers before the swap.
struct BalancedSwap {
  std::array<std::uint32_t, 3> numbers{};
  std::array<LiftingPoint, 3> from, to;
};

// One step: for a triple i < j < k of robots, the best of the current set and of all sets that
// complete the other robots by three becomes the current set (of several, the first). With more
// than 12 robots a triple must contain two neighbours along the outline, with more than 24 three in
// a row. A swap renumbers the robots. After a round without a swap the search ends, and no swap
// makes the set better. A triple costs one completion for each trial point.
//
// A search restarts at most once, if that leads to a better set (algorithm.md, Second start and
// Robots with a size).
struct BalancedStep {
  BalancedSearch search;             // after the step
  std::optional<BalancedSwap> swap;  // if there was one
};
BalancedStep try_next_triple(const BalancedProblem& problem, BalancedSearch search);

// Calls try_next_triple() until the search is finished.
BalancedSearch finish_search(const BalancedProblem& problem, BalancedSearch search);

// The robots, at least three, after the user moves one to `to`, the contact of a robot with a size.
// Its two neighbours in the list move to the ends of the even candidate with the least sum of
// squared moves, so C stays the centroid. Nothing if there is none, or if the robot does not fit or
// collides. O(n) at worst, like a completion.
std::optional<std::vector<LiftingPoint>> move_robot(const BalancedProblem& problem,
                                                    std::vector<LiftingPoint> robots,
                                                    std::size_t moved, const LiftingPoint& to);

}  // namespace evenlift
