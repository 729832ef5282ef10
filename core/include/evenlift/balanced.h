// Balanced robots: m robots whose centroid is C, so that equal forces W / m carry the weight W. The
// loads are equal if forces are controlled, or if all robots are level and equally stiff and the
// object does not bend. Three robots that are not on one line have equal loads even without these
// conditions. Two robots with equal arms are the smallest case. Balanced robots go beyond the
// thesis, whose section 6.2 calls for other ways to share the load evenly. The full definition is
// in algorithm.md, Balanced robots.
//
// A local search compares sets by these keys, in order. If all tie, the set found first is better.
// 1. fewer pairs of robots nearer to each other than the setting `apart`;
// 2. if the setting `survive` is F > 0: the larger number of failures, counted up to F, after which
//    C is at least `clear` inside the hull of the other robots, whichever robots fail;
// 3. for the goal `hold`: the higher level. The level is the number of thresholds 0.001, 0.4 mu and
//    mu that the margin reaches, and 0 if the hold is not firm (closure.h). Here mu is min_margin,
//    and only contacts at least `clear` from every corner count for the margin;
// 4. the larger coverage, by more than 1e-9;
// 5. the larger sum of |p - C|^2 over the robots' places p, by more than 1e-9 of it;
// 6. the smaller places along the outline: the first robot whose places in the two sets differ by
//    more than tau Lambda decides. The outline, of length Lambda, runs counter-clockwise from the
//    vertex farthest from C.
//
// A downward press inside the lifting base H leaves the object upright only if the robots push back
// and none is overloaded. Robots push back if they are stiff or a controller holds their height;
// constant forces give no righting moment.
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

// A problem contains the object, C, the settings `robots`, `goal`, `min_margin`, `apart`, `clear`,
// `survive`, `robot` and `no_go`, and values computed once from all of these. A trial point is a
// place that the search tries for the first of three new robots (docs/algorithm.md). If robots have
// a size or there are no-go parts, the trial points are on the usable parts of the outline, and
// every robot of a set can stand at its place. A problem is immutable; copies share the data.
class BalancedProblem {
 public:
  // The settings must be in their ranges. O(n log n), plus the cost of Stands (stands.h).
  BalancedProblem(PolygonWithHoles object, const Vec2& centre, const Settings& settings);

  const balanced::Rules& rules() const { return *rules_; }

 private:
  std::shared_ptr<const balanced::Rules> rules_;
};

// The keys of a set. `level` is 0 for the goal `cover`.
struct BalancedKeys {
  std::uint32_t near_pairs = 0;  // key 1
  int steady = 0;                // key 2, -1 .. F; 0 if `survive` is 0
  std::uint32_t level = 0;       // key 3, 0 .. 3
  double coverage = 0;           // key 4
  double spread = 0;             // key 5, in squared units of length
  std::vector<double> places;    // key 6, ascending, in [0, Lambda)
};
// Returns the keys of a set. O(m^2 + m log n), plus O(n m) at worst for the coverage.
BalancedKeys balanced_keys(const BalancedProblem& problem, const std::vector<LiftingPoint>& robots);

// Whether the set `a` is better than the set `b`. At most the cost of balanced_keys() for each.
bool is_better(const BalancedProblem& problem, const std::vector<LiftingPoint>& a,
               const std::vector<LiftingPoint>& b);

// What a search has done, counted, not timed, so that the limits are the same on all platforms. A
// step is a set that is compared; the candidates that are found and the keys that are computed for
// it count more (Rules::steps_of()). A processor takes 40 to 100 million steps in a second.
struct BalancedWork {
  std::uint64_t steps = 0;
  // Counted only if the boundary (PolygonWithHoles::boundary()) has more than 1,000 vertices: each
  // completion (finding the even candidates about one point) of the swaps that are not tried from a
  // second start counts 1, plus 1 for every 100 even candidates about C.
  std::uint64_t completions = 0;
};

// A search ends when it has done more. The first two are for boundaries of up to 1,000 vertices, the
// next two for larger ones. The start has a limit of its own.
inline constexpr std::uint64_t most_steps = 250'000'000;
inline constexpr std::uint64_t most_start_steps = 70'000'000;
inline constexpr std::uint64_t most_steps_if_large = 1'000'000'000;
inline constexpr std::uint64_t most_start_steps_if_large = 250'000'000;
inline constexpr std::uint64_t most_work = 150'000;  // of BalancedWork::completions

// The state of a search. Each step depends only on this state and on the problem, so a search can
// be copied and continued elsewhere.
struct BalancedSearch {
  std::vector<LiftingPoint> robots;  // in their order along the outline
  std::uint32_t round = 0;           // completed rounds since the start or restart
  std::uint32_t next = 0;            // the next triple of the round, from 0
  bool changed = false;              // whether this round has had a swap
  bool finished = false;             // whether the search has ended: after a round without a
                                     // swap, after most_rounds rounds, because it was cut short,
                                     // or because there are only two robots
  bool restarted = false;            // whether the search looked for a second start
  BalancedWork work, work_before_restart;  // of the swaps so far
  bool cut_short = false;                  // whether a limit of work ended the start or the search
};
inline constexpr std::uint32_t most_rounds = 8;

// The part of its limit of work that a search has used, about 1 if the limit ended it. O(1).
double work_used(const BalancedProblem& problem, const BalancedSearch& search);

// Starts a search with the set S_m of algorithm.md. If there is no S_m, robots with a size may
// start with another set (algorithm.md, Robots with a size); otherwise the function returns
// nothing. For s trial points, usually 64 to 128, S_m takes at most (s + 1) m completions, and s^2
// more if m = 4 or if S_4 would not exist otherwise. A completion costs O(n) at worst, usually much
// less.
//
// `cut_short`, if given, becomes whether the limit of the start ended it. If it then returns
// nothing, there may be places all the same.
std::optional<BalancedSearch> start_balanced(const BalancedProblem& problem,
                                             bool* cut_short = nullptr);

// Whether the start is expected to take less than a few tenths of a second, so that it need not run
// in the background. The estimate counts completions and even candidates about C, so it is the same
// on all platforms. The start is slow for combs and spiky stars of a few hundred vertices, and for
// four robots on a winding outline. O(n) at worst.
bool is_quick_to_start(const BalancedProblem& problem);

// The robots that a swap moves. `numbers` are their numbers before the swap.
struct BalancedSwap {
  std::array<std::uint32_t, 3> numbers{};
  std::array<LiftingPoint, 3> from, to;  // the old and the new places
};

// One step of a search. The step takes away a triple i < j < k of robots and forms all sets that
// complete the others with three new robots. If the best of these sets is better than the current
// set, it becomes the current set; if several tie, the first does. With more than 12 robots, a
// triple must contain two neighbours along the outline; with more than 24, its robots must be three
// in a row. A swap renumbers the robots. A round tries each triple once. If it ends without a swap,
// no such swap makes the set better, and the search ends. A triple costs one completion for each
// trial point.
//
// A search restarts at most once, under the conditions of algorithm.md (Second start, and Robots
// with a size).
struct BalancedStep {
  BalancedSearch search;             // after the step
  std::optional<BalancedSwap> swap;  // empty without a swap
};
BalancedStep try_next_triple(const BalancedProblem& problem, BalancedSearch search);

// Calls try_next_triple() until the search is finished.
BalancedSearch finish_search(const BalancedProblem& problem, BalancedSearch search);

// Returns the robots after the user moves one of them to `to` (the place of its contact, if robots
// have a size). The two neighbours of this robot in the list move to the ends of an even candidate,
// so that C stays the centroid; the candidate is the one with the least sum of squared moves.
// Returns nothing if there are fewer than three robots or no such candidate, or if a robot does not
// fit or collides. O(n) at worst, like a completion.
std::optional<std::vector<LiftingPoint>> move_robot(const BalancedProblem& problem,
                                                    std::vector<LiftingPoint> robots,
                                                    std::size_t moved, const LiftingPoint& to);

}  // namespace evenlift
