// The search for balanced robots (balanced.h): hulls and coverage, trial points, rules, starts and swaps.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "candidates/pair_candidate.h"
#include "evenlift/balanced.h"
#include "evenlift/balanced_history.h"
#include "evenlift/chords.h"
#include "evenlift/document.h"
#include "evenlift/polygon.h"
#include "evenlift/polygon_with_holes.h"
#include "evenlift/stands.h"
#include "grasp/grasp.h"
#include "polygon/corners.h"

namespace evenlift::balanced {

// --- The convex hull of a few robots, relative to C. It is computed in plain doubles and without
// allocation, since the search computes the coverage of thousands of sets. The hull may have
// corners that exist only through rounding; they hardly change its area.

struct SmallHull {
  std::array<Vec2, most_robots> corners;  // counter-clockwise
  std::size_t size = 0;                   // less than 3 if all robots are on one line
  double area = 0;
};

// Returns the hull of at most most_robots robots. O(m^2), by an insertion sort that usually takes
// few steps.
SmallHull small_hull(const std::vector<LiftingPoint>& robots, const Vec2& centre);

// --- The coverage of many lifting bases of one object.

class Cover {
 public:
  // The object must outlive the Cover. O(n).
  Cover(const PolygonWithHoles& object, const Vec2& centre);

  // The coverage, equal to coverage(object, hull) up to rounding. It is 0 if H has no area, if C is
  // outside H, or if only rounding separates C from a side of H. O(h log n) for each crossing of
  // the boundary with H, O(n h) at worst. Adds the work to `steps` (BalancedWork in balanced.h): one for
  // about three comparisons of a point with a side of H.
  double of(const SmallHull& hull, std::uint64_t& steps) const;

 private:
  class Sum;

  const PolygonWithHoles& object_;
  Vec2 centre_;
  EdgeTree tree_;
  // For each edge, twice the sum of the signed areas of the triangles of C and the preceding edges.
  std::vector<double> doubled_areas_;
};

// --- An upper bound of the coverage, from the part of the object in each cell of a grid. Nearly all
// sets lose by this bound and need no exact coverage.

class CoarseCover {
 public:
  // Computes the part of the object in each cell. O(n) for each row of the grid.
  CoarseCover(const PolygonWithHoles& object, const Vec2& centre);

  // Returns the upper bound, in which every cell that H meets counts in full. O(h), plus the number
  // of rows.
  double most(const SmallHull& hull) const;

 private:
  static constexpr std::size_t cells = 32;  // the number of columns, and of rows

  // The part of a row that H meets, from `first` to `last` in columns; empty if first > last.
  struct Stretch {
    double first = cells, last = -1;
  };
  using Rows = std::array<Stretch, cells>;
  static std::size_t cell_of(double place);
  static void widen(Rows& rows, const Vec2& a, const Vec2& b);

  Vec2 low_, scale_;  // the grid's lower left corner relative to C; cells per unit of length
  // For each row and column, the share of the object in the row's cells before this column.
  std::array<std::array<double, cells + 1>, cells> before_{};
};

// --- The outline of P as a walk from v*, and its trial points (algorithm.md, Balanced robots). Neither
// depends on which vertex is first in the list.

class Outline {
 public:
  // The polygon must outlive the Outline. O(n).
  Outline(const Polygon& polygon, const Vec2& centre);

  // The length of the outline, Lambda.
  double length() const { return starts_.back(); }

  // The edges in the order of the walk. O(n).
  std::vector<std::uint32_t> edges() const;

  // Returns the distance along the outline, counter-clockwise from v* to a point on an edge. It is
  // in [0, Lambda); a distance within tau Lambda of Lambda counts as 0. O(1).
  double place(const LiftingPoint& point) const;

  // The trial points, in order. If robots have a size or there are no-go parts, `room` must be
  // given. The trial points are then the lifting points of contacts at equal distances along all
  // usable intervals (docs/stands.md). The lifting points for the ends and the middle of each
  // interval follow, but only if there are no more intervals than points at equal distances. O(n).
  std::vector<LiftingPoint> stands(const Stands* room = nullptr) const;

 private:
  std::vector<LiftingPoint> usable_stands(std::uint32_t number, const Stands& room) const;
  std::vector<LiftingPoint> interval_stands(std::uint32_t most, const Stands& room) const;
  std::uint32_t edge_of_step(std::size_t step) const;
  std::vector<LiftingPoint> even_stands(std::uint32_t number) const;
  std::vector<LiftingPoint> reflex_stands(std::uint32_t most) const;

  const Polygon& polygon_;
  std::vector<std::uint32_t> vertices_;  // from v* counter-clockwise
  std::vector<std::uint32_t> steps_;     // by edge: the step of the walk along this edge
  std::vector<double> starts_;           // by step: its distance from v*; the last is Lambda
};

// --- The three robots that a swap may replace.

using Triple = std::array<std::uint32_t, 3>;  // increasing

// The triples that a swap may replace, in lexicographic order. For up to 12 robots, these are all
// triples; for up to 24, the triples that contain two neighbours along the outline; for more, the
// triples of three robots in a row. O(m^3).
std::vector<Triple> triples_of(std::uint32_t robots);

// The robots outside the triple. O(m).
std::vector<LiftingPoint> others(const std::vector<LiftingPoint>& robots, const Triple& triple);

// --- The requirements on balanced robots, and the comparison of two sets by the keys of
// evenlift/balanced.h. Rules computes a key only when it is needed, and first tries cheap bounds of
// the coverage, by which nearly all sets lose.

// A set with those of its keys (see BalancedKeys) that have been computed.
struct RatedSet {
  std::vector<LiftingPoint> robots;
  std::uint32_t near_pairs = 0;
  std::optional<int> steady;
  std::optional<Margins::Level> level;
  std::optional<SmallHull> hull;
  std::optional<double> coverage, spread;
  std::uint64_t steps_of_coverage = 0;  // cover.h
  std::optional<std::vector<double>> places;

  // Clears the keys after `robots` has changed. `pairs` is the number of near pairs of the new
  // robots.
  void begin(std::uint32_t pairs);
};

class Rules {
 public:
  Rules(PolygonWithHoles object, const Vec2& centre, const Settings& settings);
  Rules(const Rules&) = delete;
  Rules& operator=(const Rules&) = delete;

  const Polygon& polygon() const { return object_.outline(); }
  const Vec2& centre() const { return centre_; }
  std::uint32_t robots() const { return robots_; }
  const EvenChords& chords() const { return chords_; }
  const Outline& outline() const { return outline_; }
  const std::vector<LiftingPoint>& stands() const { return stands_; }
  // What a completion adds to BalancedWork::completions; 0 if they are not counted.
  std::uint64_t work_of_completion() const { return work_of_completion_; }
  // Whether the boundary has more than 1,000 vertices.
  bool is_large() const { return work_of_completion_ > 0; }
  // The part of the limits (balanced.h) that this work uses; 1 or more if it exceeds one.
  double used(const BalancedWork& work) const;
  // The steps that it took to compute those keys of a set that are known. O(1).
  std::uint64_t steps_of(const RatedSet& set) const;
  const std::vector<Triple>& triples() const { return triples_; }

  // The places where robots can stand; null if robots are points that may stand anywhere.
  const Stands* room() const { return room_.get(); }
  // Whether `other` collides with one of the first `number` robots. O(number).
  bool collides(const std::vector<LiftingPoint>& robots, std::size_t number,
                const LiftingPoint& other) const;

  // Of the first `number` robots, counts those that are too near to `other`. O(number).
  std::uint32_t near_pairs(const std::vector<LiftingPoint>& robots, std::size_t number,
                           const LiftingPoint& other) const;

  // The number of near pairs of all robots. O(m^2).
  std::uint32_t near_pairs(const std::vector<LiftingPoint>& robots) const;

  // Whether the goal is `hold`, but the set has level 0.
  bool misses_hold(RatedSet& set) const { return holds_ && level(set) == 0; }
  // Whether the set `a` reaches a higher level than the set `b`.
  bool holds_better(RatedSet& a, RatedSet& b) const { return level(a) > level(b); }

  bool better(RatedSet& a, RatedSet& b) const;

  // Returns the key that decides between two sets; nothing if the sets tie in all keys.
  std::optional<BalancedKey> decided_by(RatedSet& a, RatedSet& b) const;

  // Returns the set of these robots, with its number of near pairs. O(m^2).
  RatedSet rated(const std::vector<LiftingPoint>& robots) const;

  BalancedKeys keys(RatedSet& set) const;

  // Returns the same set with its keys, but with its robots in order along the outline.
  RatedSet in_order(const RatedSet& set) const;

 private:
  int steady(RatedSet& set) const;
  std::uint32_t level(RatedSet& set) const;
  const SmallHull& hull(RatedSet& set) const;
  bool covers_less(RatedSet& set, double bound) const;
  double coverage(RatedSet& set) const;
  double spread(RatedSet& set) const;
  double place(const LiftingPoint& robot) const;
  const std::vector<double>& places(RatedSet& set) const;
  bool surely_loses_by_coverage(RatedSet& a, RatedSet& b) const;

  // The first key in which two sets differ, and the better set: `order` is 1 if `a` is better, -1
  // if `b` is, and 0 if they tie.
  struct Decision {
    int order = 0;
    BalancedKey key = BalancedKey::near_pairs;
  };
  Decision decide(RatedSet& a, RatedSet& b) const;

  PolygonWithHoles object_;
  Vec2 centre_;
  std::uint32_t robots_;
  bool holds_;  // whether the goal is `hold`
  HoldRequirements hold_;
  double near_square_;  // robots at a smaller squared distance are too near
  int survive_;
  std::shared_ptr<const Stands> room_;
  Outline outline_;
  std::vector<LiftingPoint> stands_;
  std::vector<Triple> triples_;
  EvenChords chords_;
  std::uint64_t work_of_completion_ = 0;
  CoarseCover coarse_cover_;
  Cover cover_;
  Margins margins_;
};

// --- Completes given robots by two or three more, so that the centroid of all is C.

// The point where the midpoint of two more robots must be, so that the centroid of all is C.
Vec2 middle_of_two_more(const std::vector<LiftingPoint>& robots, const Vec2& centre);

// The even candidates whose two ends, together with the robots, have the centroid C; none if
// middle_of_two_more() is not strictly inside the convex hull of P. If the outline has more than
// 1,000 vertices and many such candidates, only some are returned (EvenChords::some_about). Adds the
// work to `steps` (BalancedWork in balanced.h).
std::vector<Candidate> pairs_to_complete(const Rules& rules,
                                         const std::vector<LiftingPoint>& robots,
                                         std::uint64_t& steps);

// All such candidates, for any outline.
std::vector<Candidate> all_pairs_to_complete(const Rules& rules,
                                             const std::vector<LiftingPoint>& robots);

// Keeps the best of the offered sets; of sets that tie, the first.
class Best {
 public:
  // After `most_steps`, no three more are offered: any set will do, and none if usable_sets() can
  // take its place.
  explicit Best(const Rules& rules, std::uint64_t most_steps = ~std::uint64_t{0})
      : rules_(rules), most_steps_(most_steps) {}

  // Makes `set` the best so far, without a comparison.
  void offer(const RatedSet& set) { set_ = set; }
  // Offer each completion of the robots by two or by three more, in the order of the trial points
  // and then of the candidates.
  void offer_two_more(const std::vector<LiftingPoint>& robots);
  void offer_three_more(const std::vector<LiftingPoint>& robots);
  // Offers each completion of the robots by three more, of which the first is at `place`.
  void offer_three_more(const std::vector<LiftingPoint>& robots, const LiftingPoint& place);

  const std::optional<RatedSet>& set() const { return set_; }
  // Whether a completion has become the best set.
  bool completed() const { return completed_; }
  // The number of robots that the best set had before two or three more completed it. In the set,
  // these robots come first.
  std::size_t kept() const { return kept_; }
  // The work so far, in steps of BalancedWork (balanced.h).
  std::uint64_t steps() const { return steps_; }

 private:
  // Offers the robots together with the ends of each even candidate that completes them, but skips
  // sets whose robots collide. The last `added` of the `robots` do not count as kept. `near_pairs`
  // counts the near pairs among the `robots`.
  void complete(const std::vector<LiftingPoint>& robots, std::size_t added,
                std::uint32_t near_pairs);

  const Rules& rules_;
  std::uint64_t most_steps_;
  std::optional<RatedSet> set_;
  bool completed_ = false;
  std::size_t kept_ = 0;
  std::uint64_t steps_ = 0;
  RatedSet offered_;  // a member so that its memory is reused
};

// --- The start of the search: sets of two, three and more robots, each built from smaller sets.

// A set with its keys and with its robots in order along the outline. If the set was built from a
// smaller set, `kept` holds the robots of the smaller set, and `came` the others.
struct StartSet {
  RatedSet set;
  std::vector<LiftingPoint> kept, came;
  bool at_once = false;  // whether the set is from usable_sets(); then `came` holds all robots
};

// The sets S_0, S_1 ... S_m (algorithm.md, Balanced robots), indexed by their number of robots; an
// entry is empty if its set does not exist. If S_m does not exist and robots cannot stand
// everywhere, the best set on usable intervals (usable_sets.h) takes the place of S_m.
using StartSets = std::vector<std::optional<StartSet>>;
// `cut_short` becomes whether most_start_steps (balanced.h) are spent; the remaining sets are then
// chosen among few.
StartSets start_sets(const Rules& rules, bool* cut_short = nullptr);

// The start from which the search begins again after it ended with `now`; nothing if no better
// start is found. The steps that it takes add to `work`; if this reaches the limit, the result is
// incomplete.
//   - If robots have a size or there are no-go parts, the swaps are tried from each of the best
//     sets on usable intervals, at most most_starts of them. If the best result is better than
//     `now`, the returned list contains only the set that leads to it.
//   - Otherwise, if there are more than four robots, the goal is `hold` and `now` has level 0, the
//     sets S_i are built again. The choice of S_4 then includes all sets that consist of a trial
//     point and three more robots. The new sets are returned if S_m has a higher level than `now`.
//     This helps with regular polygons, where the first start is symmetrical about C.
inline constexpr std::size_t most_starts = 6;
std::optional<StartSets> second_start(const Rules& rules, const std::vector<LiftingPoint>& now,
                                      BalancedWork& work);

// --- Sets of robots with a size, for objects on which few sets fit. If the usable boundary is short,
// completing smaller sets (completions.h) may find no set. So this search first chooses the number
// of robots on each usable interval such that the centroid of all can be at C, and then the places
// of the robots.

// Returns up to `most` of the best such sets, the best first; none if robots are points that may
// stand anywhere. The robots on one interval stand at equal distances, as close together as
// possible, as far apart as possible, or in between. The search chooses the numbers of robots one
// interval after another along the outline, from v*, the vertex farthest from C, on. It makes at
// most most_nodes partial choices, so that the work is bounded and the same on every platform.
inline constexpr std::size_t most_nodes = 100'000;
std::vector<RatedSet> usable_sets(const Rules& rules, std::size_t most);

// --- The swaps of the search for balanced robots. evenlift/balanced.h explains the two functions;
// there they take a BalancedProblem, here its Rules.

BalancedStep try_next_triple(const Rules& rules, BalancedSearch search);
BalancedSearch finish_search(const Rules& rules, BalancedSearch search);

}  // namespace evenlift::balanced
