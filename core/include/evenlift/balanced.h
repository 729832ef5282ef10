// Balanced robots: m of them, whose centroid is C. Forces of W / m each then add up to W, and their
// moments about C cancel, so all can bear the same. They do so if forces are controlled, or if all
// are equally stiff and level; three robots that are not on one line do so in any case. A pair with
// equal arms is the smallest case. This is beyond the thesis, which asks for such methods in 6.2;
// algorithm.md, Balanced robots, defines it.
//
// The robots are found by a local search among sets whose centroid is C. The outline of P begins at
// v*, the vertex farthest from C (of those within tau L the leftmost, then the lowest), runs once
// round counter-clockwise and has the length Lambda. The stands are the 64 points at
// (j + 1/2) Lambda / 64 (16 of them if P has more than 1,000 vertices), then the reflex vertices if
// they are at most as many. Robots Q become a set of m = |Q| + 2 by the ends of an even candidate
// about (m C - sum Q) / 2, if that point is strictly inside the convex hull of P, and one of
// m = |Q| + 3 by a stand b and the ends of an even candidate for Q and b.
//
// Of two sets that one is better which is ahead in the first key in which they differ:
// 1. the fewer pairs of robots nearer to each other than `apart`;
// 2. with survive = F > 0: min(F, the number of failures that leave the object steady), the larger;
// 3. for the goal hold: how many of 0.001, 0.4 mu and mu the margin reaches, mu being min_margin;
// 4. the coverage, the larger by more than 1e-9;
// 5. the sum of |p - C|^2, the larger by more than 1e-9 of it;
// 6. the robots' places along the outline, in order, the first that is smaller by more than
//    tau Lambda.
// Where all tie, the set found first stays.
//
// Robots that hold a constant force give no righting moment: coverage and H presume robots that
// push back, being stiff or controlled by height.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "evenlift/chords.h"
#include "evenlift/document.h"
#include "evenlift/polygon.h"

namespace evenlift {

namespace balanced {
class Rules;
}

// The object, C and the settings robots, goal, min_margin, apart, survive, robot and no_go, with
// all that is computed of them once. Where robots have a size, or edges must not be touched, the
// stands are spread over what can be used, and in every set that is looked at all robots can stand.
// It is immutable, and copies share it.
class BalancedProblem {
 public:
  // The settings must be in their ranges. O(n log n), besides the cost of Stands (stands.h).
  BalancedProblem(Polygon polygon, const Vec2& centre, const Settings& settings);

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

// Whether the first set is better than the second. The cost of balanced_keys() at most, for each.
bool is_better(const BalancedProblem& problem, const std::vector<LiftingPoint>& a,
               const std::vector<LiftingPoint>& b);

// A search at one moment. All that it depends on is here and in the problem, so it can be kept,
// copied, and gone on with elsewhere.
struct BalancedSearch {
  std::vector<LiftingPoint> robots;  // in their order along the outline
  std::uint32_t round = 0;           // rounds that have ended
  std::uint32_t next = 0;            // the next triple of the present round, counted from 0
  bool changed = false;              // whether the present round has exchanged anything
  bool finished = false;             // a whole round changed nothing, or there were most_rounds
  bool restarted = false;            // a second start was looked for
  std::uint64_t work = 0;            // what the triples so far took, in units of most_work
  bool cut_short = false;            // it has finished because that was too much
};
inline constexpr std::uint32_t most_rounds = 8;

// The search on an outline with more than 1,000 vertices ends after so much work, which is counted
// and not timed, so that every platform ends with the same robots: for each completion 1, and 1
// more for every 100 even candidates about C.
inline constexpr std::uint64_t most_work = 150'000;

// The start: S_i is the better one of S_(i-2) with two more and S_(i-3) with three more, for i = 2
// .. m from the empty S_0; for m = 4, and where S_4 would not exist, also a stand with three more.
// Nothing if there is no set of m robots. For s stands, from 64 to 128 as a rule, at most (s + 1) m
// completions, and s^2 more where a stand takes three more. A completion is the search for the even
// candidates about one point: O(n) at worst, and much less as a rule.
std::optional<BalancedSearch> start_balanced(const BalancedProblem& problem);

// Whether the start surely takes less than some tenths of a second, so that a program that shows it
// need not search beside. It is judged by the number of completions and that of the even candidates
// about C, and so is the same on every platform. Combs and spiky stars of some hundred vertices are
// slow, and so are four robots on an outline that winds. O(n) at worst.
bool is_quick_to_start(const BalancedProblem& problem);

// Three robots, by their numbers before, that went elsewhere.
struct BalancedExchange {
  std::array<std::uint32_t, 3> numbers{};
  std::array<LiftingPoint, 3> from, to;
};

// A search begins once more, at most once, where that leads farther: points that are to hold and do
// not, from a start in which S_4 is also the best stand with three more, as for m = 4; and robots
// with a size, of which few sets find a place, from the best sets on usable intervals
// (docs/algorithm.md).
//
// What a search does next. It goes through the triples i < j < k of robots; with more than 12
// robots only those of which two are neighbours along the outline, with more than 24 three in a
// row. The best of the present set and of all sets of the other robots with three more, in this
// order, becomes the present one, and the robots are numbered anew. A round that changes nothing is
// the last: then no exchange makes the set better. A triple costs as many completions as there are
// stands.
struct BalancedStep {
  BalancedSearch search;                     // afterwards
  std::optional<BalancedExchange> exchange;  // what was exchanged, if anything was
};
BalancedStep try_next_triple(const BalancedProblem& problem, BalancedSearch search);

// The search at its end: try_next_triple() until it is finished.
BalancedSearch finish_search(const BalancedProblem& problem, BalancedSearch search);

// The robots, at least three, when somebody moves one of them along the outline: its two neighbours
// in the list follow, so that C stays the centroid. Of the even candidates that allow it theirs are
// the ends that are nearest to them, by the sum of the squares of the ways. Nothing if there is
// none: the robot cannot go there. Where robots have a size `to` is its contact, and it cannot go
// where it would not fit or collide. O(n) at worst, as a completion.
std::optional<std::vector<LiftingPoint>> move_robot(const BalancedProblem& problem,
                                                    std::vector<LiftingPoint> robots,
                                                    std::size_t moved, const LiftingPoint& to);

}  // namespace evenlift
