// An edge of the lifting base H as C sees it, and what a new lifting point beyond it would gain by
// each metric (algorithm.md, Selection: f(p)).
#pragma once

#include <optional>
#include <vector>

#include "evenlift/document.h"
#include "evenlift/polygon.h"
#include "selection/gain_bounds.h"

namespace evenlift {

// The polygon's vertices as seen from C, for all wedges: made once.
struct Surroundings {
  Surroundings(const Polygon& polygon, const Vec2& centre);  // O(n log n)

  struct Seen {
    Vec2 position;  // relative to C
    double key;     // direction_key of it
  };
  Points boundary;             // P relative to C, counter-clockwise
  std::vector<Seen> vertices;  // other than C, by key
  bool convex = false;
  double diagonal = 0;  // L
};

// How much one end of a chord gains: the value, or an upper bound that costs less.
enum class Certainty { bound, close_bound, exact };
struct Gain {
  double value = 0;
  Certainty certainty = Certainty::exact;
  bool exact() const { return certainty == Certainty::exact; }
};

class Wedge {
 public:
  // The edge h1 h2 of H, corners relative to C and counter-clockwise. With an H that is a segment
  // each of its sides is such an edge. O(n) for area and distance, else O(1).
  Wedge(const Surroundings& surroundings, Method metric, const Vec2& h1, const Vec2& h2);

  const Vec2& h1() const { return h1_; }
  const Vec2& h2() const { return h2_; }

  // Signed distance of p (relative to C) from the edge's line, positive outside H. O(1).
  double distance(const Vec2& p) const;

  // f(p) for a p that lies beyond, or a bound: never below f(p). O(log n).
  Gain estimate(const Vec2& p) const;

  // From an estimate to a close bound, from there to f(p) itself; straight to f(p) while bounds
  // have not paid for themselves. The first close bound costs as much as a few evaluations, the
  // others O(sqrt(m) log m).
  Gain sharpen(const Vec2& p, const Gain& known);

  // f(p) itself. O(m) for the m vertices and crossings of P in the wedge beyond the edge.
  double evaluate(const Vec2& p) const;

  // Of metric distance: the vertices whose arms f(p) sums up, with their distances outside the edge
  // and outside the new one. O(m).
  struct Arm {
    Vec2 vertex;
    double before, after;
    bool up_to_p;  // `after` is the distance from h1 p, else from p h2
  };
  std::vector<Arm> arms(const Vec2& p) const;

 private:
  void collect_area();
  void collect_outer_vertices();
  double area_gain(const Vec2& p) const;
  double distance_gain(const Vec2& p) const;
  double distance_bound(const Vec2& p) const;
  bool prepare_close_bounds();
  double close_bound(const Vec2& p) const;
  double distance_room() const;
  // The outer vertices that C sees before p, in its direction, and after it: begin and end of those
  // in the middle.
  struct Split {
    std::size_t begin, end;
  };
  Split split_at(const Vec2& p) const;
  template <class Visit>
  void for_each_arm(const Vec2& p, Visit visit) const;

  const Surroundings* surroundings_;
  Method metric_;
  Vec2 h1_, h2_;
  double key1_ = 0;

  Points outside_;  // area: P in the wedge beyond the edge
  double outside_area_ = 0;

  struct Outer {
    Vec2 position;
    double key;       // from key1_
    double distance;  // outside the edge's line, not negative
  };
  std::vector<Outer> outer_;  // distance: vertices of P in the wedge beyond the edge, by direction
  Points sums_;               // sums_[k]: of the first k positions
  double distance_sum_ = 0;

  int evaluations_ = 0;  // before close bounds were made
  std::optional<AreaBins> area_bins_;
  std::optional<DistanceBlocks> distance_blocks_;
};

}  // namespace evenlift
