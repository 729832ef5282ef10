// An upper bound of the coverage, from the part of the object in each cell of a grid. Nearly all
// sets lose by it and need no exact coverage.
#pragma once

#include <array>
#include <cstddef>

#include "balanced/small_hull.h"
#include "evenlift/polygon_with_holes.h"

namespace evenlift::balanced {

class CoarseCover {
 public:
  // Finds the part of the object in each cell. O(n) for each row of the grid.
  CoarseCover(const PolygonWithHoles& object, const Vec2& centre);

  // The upper bound: each cell that H meets counts in full. O(h), plus the number of rows.
  double most(const SmallHull& hull) const;

 private:
  static constexpr std::size_t cells = 32;  // the number of columns, and of rows

  // The columns in which H meets a row, in cells; empty if first > last.
  struct Stretch {
    double first = cells, last = -1;
  };
  using Rows = std::array<Stretch, cells>;
  static std::size_t cell_of(double place);
  static void widen(Rows& rows, const Vec2& a, const Vec2& b);

  Vec2 low_, scale_;  // the grid's lower left corner relative to C; cells per unit of length
  // The share of the object in the cells of a row before each column.
  std::array<std::array<double, cells + 1>, cells> before_{};
};

}  // namespace evenlift::balanced
