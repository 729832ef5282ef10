// Upper bounds of gains by area and distance that cost less than the gains and come close to them:
// what a wedge holds, summed up in bins by direction and in each by how far out it lies.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "evenlift/vec.h"

namespace evenlift {

// The area of a region in the wedge from h1 to h2 and beyond the line h1 h2.
class AreaBins {
 public:
  // `region` is a closed chain, counter-clockwise, that perhaps touches itself; all relative to C,
  // which sees h2 under at most 180 degrees to the left of h1.
  // O((m + crossings of m edges with the bins' rims) levels).
  AreaBins(const Points& region, const Vec2& h1, const Vec2& h2, double diagonal);

  // Never below the area of the region in the triangle h1 h2 p, p in the wedge. O(bins).
  double bound(const Vec2& p) const;

 private:
  static constexpr int levels = 16;
  struct Bin {
    Vec2 outward = Vec2::Zero();  // the level of v is outward . v, and 1 on the segment between its
                                  // rims' vectors
    double unit = 0;              // area between C and level 1
    double base = 0;              // area between C and h1 h2
    double lowest = 0, step = 0;  // of levels; step > 0, or 0 without any
    std::array<double, levels + 1> inside{};  // area of the region up to level lowest + j step
    double inside_at_most(double level) const;
  };
  struct Piece;  // of the region's boundary, within one bin
  void make_bins(std::size_t number);
  std::vector<Piece> split(const Points& region) const;
  void measure_levels(const std::vector<Piece>& pieces);
  std::size_t bin_of(const Vec2& v) const;
  double level_at_rim(const Vec2& a, const Vec2& b, std::size_t rim) const;

  Vec2 h1_, h2_;
  double key1_ = 0, width_ = 0;
  Points rims_;  // directions from h1 to h2, with |x| + |y| = 1
  std::vector<Bin> bins_;
  double room_ = 0;  // for rounding
};

// Sums of distances by which points lie beyond a line.
class DistanceBlocks {
 public:
  // Points in counter-clockwise order about C, relative to it. O(m log m).
  explicit DistanceBlocks(Points points);

  // At most the sum over the points number `first` to `last` - 1 of the distance by which each lies
  // to the right of the line a -> b, or 0; but for rounding. O(blocks log(size of a block)).
  double least_sum_beyond(const Vec2& a, const Vec2& b, std::size_t first, std::size_t last) const;

 private:
  struct Line;
  double least_sum_of_block(const Line& line, std::size_t block) const;

  Points points_;
  std::size_t size_;            // of a block; the last one may be smaller
  Points aheads_;               // of each block its middle direction
  std::vector<double> levels_;  // in each block ascending: ahead . v of its points
  Points sums_;                 // of the points from that one up to the block's last
};

}  // namespace evenlift
