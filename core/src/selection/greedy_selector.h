// The lifting base H while teams are added to it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <queue>
#include <utility>
#include <vector>

#include "evenlift/candidates.h"
#include "evenlift/document.h"
#include "evenlift/selection.h"
#include "evenlift/stands.h"
#include "evenlift/vec.h"
#include "selection/base_edge.h"
#include "selection/max_tree.h"
#include "selection/rules.h"

namespace evenlift {

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
