// The convex hull of a few robots, relative to C. It is computed in plain doubles and without
// allocation, since the search computes the coverage of thousands of sets. The hull may have
// corners that exist only through rounding; they hardly change its area.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "evenlift/chords.h"
#include "evenlift/document.h"
#include "evenlift/polygon_with_holes.h"
#include "polygon/clip.h"

namespace evenlift::balanced {

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

}  // namespace evenlift::balanced
