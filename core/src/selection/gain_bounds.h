// Close upper bounds of gains by area and distance, which cost less than the gains. A wedge is
// divided into bins or blocks by direction, and each of these into levels by distance outward. The
// bounds use sums over these parts.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

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

}  // namespace evenlift
