// The greedy choice of teams: rules, bounds of gains, gains, the growing base, and the choice.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <queue>
#include <span>
#include <utility>
#include <vector>

#include "evenlift/candidates.h"
#include "evenlift/document.h"
#include "evenlift/polygon_with_holes.h"
#include "evenlift/selection.h"
#include "evenlift/stands.h"
#include "evenlift/tolerance.h"
#include "evenlift/vec.h"
#include "selection/max_tree.h"

namespace evenlift {

// --- The rules by which teams are chosen. The walkthrough explains each choice by them.

enum class Key : std::uint8_t { score, ratio, length };

// The keys of a rule, in order. At each key, only the candidates that tie with the best one remain.
// After the last key, the first remaining candidate in candidate order wins.
inline std::span<const Key> keys_of(Rule rule) {
  static constexpr Key by_length[] = {Key::length, Key::ratio},
                       by_ratio[] = {Key::ratio, Key::length},
                       by_score[] = {Key::score, Key::ratio, Key::length};
  switch (rule) {
    case Rule::longest_even:
    case Rule::longest:
      return by_length;
    case Rule::most_even:
      return by_ratio;
    case Rule::score:
      break;
  }
  return by_score;
}

inline Rule rule_of_first_team(const std::vector<Candidate>& candidates, FirstTeam first) {
  if (first == FirstTeam::longest) return Rule::longest;
  return std::any_of(candidates.begin(), candidates.end(),
                     [](const Candidate& c) { return is_even(c.chord); })
             ? Rule::longest_even
             : Rule::most_even;
}

inline bool is_eligible(Rule rule, double ratio) {
  return rule != Rule::longest_even || ratio >= even_ratio;
}

inline double value_of(Key key, const Candidate& candidate, double score) {
  return key == Key::score ? score : key == Key::ratio ? candidate.chord.ratio : candidate.length;
}

// Whether a value ties with the best, which is the largest. `floor` is Selector::floor().
inline bool ties(Key key, double best, double value, double floor) {
  if (key == Key::ratio) return ratios_tie(best, value);
  if (key == Key::length) return lengths_tie(best, value);
  return value >= best - score_slack(std::fabs(best), floor);
}

// Keeps each candidate i if value(i), its value for the key, ties with the best value.
template <class Value>
void keep_best(std::vector<std::uint32_t>& indices, Key key, double floor, Value value) {
  double best = -std::numeric_limits<double>::infinity();
  for (const std::uint32_t i : indices) best = std::max(best, value(i));
  std::erase_if(indices, [&](std::uint32_t i) { return !ties(key, best, value(i), floor); });
}

// --- Close upper bounds of gains by area and distance, which cost less than the gains. A wedge is
// divided into bins or blocks by direction, and each of these into levels by distance outward. The
// bounds use sums over these parts.

// Bounds areas of a region that lies beyond the line h1 h2, and in the wedge from h1 to h2 or
// slightly outside it.
class AreaBins {
 public:
  // `region` is a counter-clockwise ring, which may touch itself. All points are relative to C, and
  // h2 is at most 180 degrees to the left of h1. O((m + c) levels) if the region's m edges cross
  // the rims of bins c times.
  AreaBins(const Points& region, const Vec2& h1, const Vec2& h2, double diameter);

  // An upper bound of the region's area in the triangle h1 h2 p, for p in the wedge. O(bins).
  double bound(const Vec2& p) const;

 private:
  static constexpr int levels = 16;
  struct Bin {
    // The level of v is `outward` . v. It is 1 on the segment between the bin's two rim vectors.
    Vec2 outward;
    double unit = 0;              // area between C and level 1
    double base = 0;              // area between C and h1 h2
    double lowest = 0, step = 0;  // levels: `lowest` + j `step`; `step` is 0 in an empty bin
    std::array<double, levels + 1> inside{};  // area of the region up to each level
    double inside_at_most(double level) const;
  };
  struct Piece;  // a piece of the region's boundary within one bin
  void make_bins(std::size_t number);
  std::vector<Piece> split(const Points& region) const;
  void measure_levels(const std::vector<Piece>& pieces);
  std::size_t bin_of(const Vec2& v) const;
  double level_at_rim(const Vec2& a, const Vec2& b, std::size_t rim) const;

  Vec2 h1_, h2_;
  double pseudo_angle1_ = 0, width_ = 0;  // the pseudo-angle of h1, and that from h1 to h2
  Points rims_;                           // directions from h1 to h2, with |x| + |y| = 1
  std::vector<Bin> bins_;
  double error_bound_ = 0;  // of the rounding in bound()
};

// Bounds sums of distances of points beyond a line.
class DistanceBlocks {
 public:
  // The points are relative to C and counter-clockwise about it. O(m log m).
  explicit DistanceBlocks(Points points);

  // A lower bound, up to rounding, of the sum of max(0, d) over the points `first` to `last` - 1,
  // where d is the distance to the right of the line a -> b. O(blocks log(size of a block)).
  double least_sum_beyond(const Vec2& a, const Vec2& b, std::size_t first, std::size_t last) const;

 private:
  struct Line;
  double least_sum_of_block(const Line& line, std::size_t block) const;

  Points points_;
  std::size_t size_;            // points in a block; the last block may have fewer
  Points aheads_;               // `ahead`, the middle point, of each block
  std::vector<double> levels_;  // `ahead` . v for the points v of each block, ascending
  Points sums_;                 // the sums of the block's points at or above each level
};

// --- An edge of the lifting base H seen from C, and the gain f(p) of a new lifting point p beyond it
// (algorithm.md, Selection).

// The object seen from C, for all wedges.
struct Surroundings {
  Surroundings(const PolygonWithHoles& object, const Vec2& centre);  // O(n log n)

  struct Seen {
    Vec2 position;  // relative to C
    double pseudo_angle;
  };
  Points boundary;             // relative to C, counter-clockwise (polygon_with_holes.h)
  std::vector<Seen> vertices;  // those of the outline, except any at C, by pseudo-angle
  bool convex = false;         // convex and without holes
  double diameter = 0;         // L
};

// The gain of one end of a chord: exact, or an upper bound that costs less.
enum class Certainty { bound, close_bound, exact };
struct Gain {
  double value = 0;
  Certainty certainty = Certainty::exact;
  bool exact() const { return certainty == Certainty::exact; }
};

// The wedge in which C sees an edge of H, and the parts of P in the wedge beyond the edge.
class Wedge {
 public:
  // The edge's ends h1 and h2 are relative to C and in counter-clockwise order. If H is a segment,
  // each of its sides is an edge. O(n) for area and distance, O(1) for circle.
  Wedge(const Surroundings& surroundings, Metric metric, const Vec2& h1, const Vec2& h2);

  const Vec2& h1() const { return h1_; }
  const Vec2& h2() const { return h2_; }

  // The signed distance of p (relative to C) from the edge's line, positive outside H. O(1).
  double distance(const Vec2& p) const;

  // Returns f(p) or an upper bound of it, for p in the wedge beyond the edge. O(log n).
  Gain estimate(const Vec2& p) const;

  // Returns a better value than `known`: a close bound if `known` is a bound from estimate(),
  // otherwise f(p). As long as close bounds are unlikely to save time, as in the first few calls,
  // the result is always f(p). The first close bound costs a few evaluations, each later one
  // O(sqrt(m) log m).
  Gain sharpen(const Vec2& p, const Gain& known);

  // Returns f(p). O(m) for the m vertices and crossings of P in the wedge beyond the edge.
  double evaluate(const Vec2& p) const;

  // A term of the sum f(p) for the metric `distance`. arms(p) returns all terms, in O(m).
  struct Arm {
    Vec2 vertex;
    double before, after;  // distances outside the present edge and outside the new one
    bool up_to_p;          // whether the new edge is h1 p rather than p h2
  };
  std::vector<Arm> arms(const Vec2& p) const;

 private:
  void collect_area();
  // Whether the edge subtends at most 180 degrees at C. The angle is greater only if C is outside
  // the edge, by less than tau L; the edge is then the first team's chord of opposite vertices.
  bool is_convex() const;
  void collect_outer_vertices();
  double area_gain(const Vec2& p) const;
  double distance_gain(const Vec2& p) const;
  double distance_bound(const Vec2& p) const;
  bool prepare_close_bounds();
  double close_bound(const Vec2& p) const;
  double distance_error_bound() const;
  // Divides the outer vertices by their directions from C. Those before `begin` come before p,
  // those in [begin, end) are in the direction of p, and the others come after p.
  struct Split {
    std::size_t begin, end;
  };
  Split split_at(const Vec2& p) const;
  template <class Visit>
  void for_each_arm(const Vec2& p, Visit visit) const;

  const Surroundings* surroundings_;
  Metric metric_;
  Vec2 h1_, h2_;
  double pseudo_angle1_ = 0;  // that of h1

  Points outside_;  // for area: P beyond the edge; only in and near the wedge if is_convex()
  double outside_area_ = 0;

  struct Outer {
    Vec2 position;
    double pseudo_angle;  // measured from that of h1
    double distance;      // outside the edge's line; not negative
  };
  std::vector<Outer> outer_;  // for distance: vertices of P in the wedge beyond the edge
  Points sums_;               // sums_[k] is the sum of the first k positions
  double distance_sum_ = 0;

  int evaluations_ = 0;  // calls of evaluate() by sharpen() before close bounds exist
  std::optional<AreaBins> area_bins_;
  std::optional<DistanceBlocks> distance_blocks_;
};

// --- The lifting base H while teams are added to it.

// The corners of H in a counter-clockwise ring around C, which is the origin. A corner keeps its
// number as long as it is one.
class GrowingBase {
 public:
  using Corner = std::uint32_t;

  // `flat` as for convex_hull().
  explicit GrowingBase(double flat) : flat_(flat) {}

  std::size_t size() const { return size_; }
  bool has(Corner corner) const { return corners_[corner].in_ring; }
  const Vec2& position(Corner corner) const { return corners_[corner].position; }
  Corner next(Corner corner) const { return corners_[corner].next; }

  // Whether p is within the distance of an edge. O(h).
  bool is_near(const Vec2& p, double distance) const;

  // From the lowest of the leftmost corners, as by convex_hull(). O(h).
  Points positions() const;

  // A point to add, and the corner at which the edge begins through which C sees it.
  struct Added {
    Vec2 position;
    std::optional<Corner> edge;
  };

  // Adds both points and returns the corners at which a new edge begins, in the order of
  // positions(); none if H stays the same. O(changes) if only a few edges change and the hull has
  // many corners, otherwise O(h).
  std::vector<Corner> add(const Added& p, const Added& q);

 private:
  struct Node {
    Vec2 position;
    Corner next = 0, previous = 0;
    bool in_ring = true;
  };
  // Where a point belongs: in place of the corners between two others, or within H.
  struct Gap {
    bool inside = false;
    Corner before = 0, after = 0;
  };
  // How a point was put in, so that it can be taken out again as long as it is the last.
  struct Put {
    Gap gap;
    Corner next, previous;  // those of the corners beside the gap, before
    Corner first;
    std::size_t size;
  };
  double side(Corner edge, const Vec2& p) const;
  bool is_straight(const Vec2& before, Corner corner, const Vec2& after) const;
  std::optional<Gap> gap_for(const Added& added) const;
  std::optional<Gap> widest_gap(Corner visible, const Vec2& p) const;
  std::optional<std::vector<Corner>> add_locally(const Added& p, const Added& q);
  Put put(const Vec2& p, const Gap& gap);
  void take_out(const Put& put);
  std::vector<Corner> replace(const Points& positions);
  void link(Corner from, Corner to);

  double flat_;
  std::vector<Node> corners_;  // also past ones
  Corner first_ = 0;           // the lowest of the leftmost
  std::size_t size_ = 0;
};

// --- The greedy choice of teams (algorithm.md, Selection).

// Lazy greedy evaluation (M. Minoux, Accelerated greedy algorithms for maximizing submodular set
// functions, 1978). Each end of a candidate has an upper bound of its gain. The bound is refined,
// and finally replaced by the gain, only while the candidate can still win. Gains do not always
// diminish here, so an end gets a new bound when the edge of H in front of it changes.
class Selector {
 public:
  // The candidates and `stands` must outlive the selector. With `stands`, candidates whose robots
  // collide with a taken team drop out. O(m log m) for m candidates, without the vertices beyond
  // new edges (base_edge.h).
  Selector(const PolygonWithHoles& object, const Vec2& centre,
           const std::vector<Candidate>& candidates, Metric metric,
           FirstTeam first = FirstTeam::even, const Stands* stands = nullptr);

  // Takes the best candidate left. Returns false if every candidate is taken or has dropped out.
  // Usually O((k + 1) log m) for k ends that C sees through new edges or whose gain is evaluated;
  // O(m) with `stands`, or if many candidates tie by one key but not by others.
  bool take_next();

  // Takes this candidate, whatever its score. O(k log m), or O(m) with `stands`.
  void take(std::uint32_t candidate);

  const std::vector<std::uint32_t>& taken() const { return taken_; }

  // Whether the candidate dropped out because it collides with a taken team.
  bool dropped_out(std::uint32_t candidate) const { return states_[candidate] == State::dropped; }

  // The candidate's score after the teams taken so far, of which there must be at least one.
  double score(std::uint32_t candidate);

  // Evaluates candidates like take_next(), but takes none.
  void compare() { find_best_score(); }

  // The known gain of a candidate's end (0: r1, 1: r2), the wedge of the edge of H in front of the
  // end, and whether the end is outside H. At least one team must be taken.
  const Gain& gain(std::uint32_t candidate, std::uint32_t end) const {
    return ends_[2 * candidate + end].gain;
  }
  const Wedge& wedge(std::uint32_t candidate, std::uint32_t end) const {
    return wedges_[ends_[2 * candidate + end].wedge];
  }
  bool outside(std::uint32_t candidate, std::uint32_t end) const {
    return gains(wedge(candidate, end), ends_[2 * candidate + end].position);
  }

  // The corners of H, relative to C.
  Points base() const { return base_.positions(); }

  // Scores that differ by at most the floor always tie. For distance, the floor depends on H.
  double floor() const { return floor_; }

 private:
  using Index = std::uint32_t;
  using Indices = std::vector<Index>;

  struct End {
    Vec2 position;  // relative to C
    double pseudo_angle = 0;
    Index wedge = 0;  // into wedges_
    // An end in the direction of a corner of H belongs to both edges there. The larger gain counts,
    // so that mirror images have the same scores.
    std::optional<Index> other_wedge;
    Gain gain;
  };
  enum class State : std::uint8_t { open, taken, dropped };

  // What is known of an open candidate, or the greatest of several. The score of a candidate counts
  // once both gains are exact; until then there is an upper bound.
  struct Standing {
    static constexpr double none = -std::numeric_limits<double>::infinity();
    double score = none, bound = none, ratio = none, length = none;
    double before = none;  // minus the candidate, for the first one in candidate order
    void raise_to(const Standing& other);
    double of(Key key) const;
  };
  Standing standing(Index candidate) const;
  Standing standing_at(Index place) const { return standing(by_evenness_[place]); }
  void touch(Index candidate) { standings_.touch(place_[candidate]); }
  void update_standings();
  template <class Value, class Passes>
  double greatest(Value value, Passes passes) const;  // as by MaxTree
  template <class Passes>
  Index first(Passes passes) const;  // in candidate order
  Index best_by(Rule rule) const;
  void find_best_score();
  double bound(Index candidate) const {
    return ends_[2 * candidate].gain.value + ends_[2 * candidate + 1].gain.value;
  }
  bool exact(Index candidate) const {
    return ends_[2 * candidate].gain.exact() && ends_[2 * candidate + 1].gain.exact();
  }
  double evaluate(const End& end, Index wedge) const;
  void evaluate(End& end);
  void sharpen(Index candidate);
  void widen_base(Index candidate);
  // Whether the wedge is that of an edge of H.
  bool is_edge(Index wedge) const {
    return base_.has(starts_[wedge]) && wedge_at_[starts_[wedge]] == wedge;
  }
  void update_floor(Index first_new);
  void enter_wedge(Index index);
  Gain estimate(const End& end) const;
  bool gains(const Wedge& wedge, const Vec2& p) const;
  void drop(Index candidate, State state);
  void drop_colliding(Index taken);

  const std::vector<Candidate>& candidates_;
  Surroundings surroundings_;
  Metric metric_;
  FirstTeam first_;
  double near_;   // tau L
  double floor_;  // see floor()

  std::vector<End> ends_;      // candidate i has the ends 2 i (r1) and 2 i + 1 (r2)
  Indices by_direction_;       // the ends by pseudo-angle
  GrowingBase base_;           // H relative to C
  std::vector<Wedge> wedges_;  // of all edges, past ones too, so that indices stay valid
  Indices starts_;             // the corner at which each wedge's edge begins
  Indices wedge_at_;           // the wedge of the edge that begins at each corner of H
  std::priority_queue<std::pair<double, Index>>
      shortest_;  // minus lengths of edges, with their wedges

  const Stands* stands_;
  std::size_t out_ = 0;        // candidates taken or dropped
  std::vector<State> states_;  // of the candidates
  std::vector<std::uint32_t> taken_;
  // Even candidates come first, since many of them tie by their ratio.
  Indices by_evenness_, place_;
  MaxTree<Standing> standings_;
};

}  // namespace evenlift
