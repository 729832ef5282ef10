// An upper bound of the coverage, from the part of the object in each cell of a grid. Nearly all
// sets lose by this bound and need no exact coverage.
#pragma once

#include <array>
#include <cstddef>

#include "balanced/small_hull.h"
#include "evenlift/polygon_with_holes.h"

namespace evenlift::balanced {

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
