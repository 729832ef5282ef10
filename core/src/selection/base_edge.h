// Close upper bounds of gains by area and distance, which cost less than the gains. A wedge is
// divided into bins or blocks by direction, and each of these into levels by distance outward. The
// bounds use sums over these parts.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "evenlift/document.h"
#include "evenlift/polygon_with_holes.h"
#include "evenlift/vec.h"

namespace evenlift {

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

}  // namespace evenlift
