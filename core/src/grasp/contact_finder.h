// Finds the contacts of robots with an object, and the distances of these contacts from corners.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "evenlift/closure.h"
#include "polygon/corners.h"

namespace evenlift {

class ContactFinder {
 public:
  // The polygon must outlive the finder. O(n log n).
  explicit ContactFinder(const Polygon& polygon);

  // Returns the same as contacts() (closure.h). O(m log n) for m points, if few vertices lie within
  // tau L of one another.
  std::vector<Contact> find(const std::vector<LiftingPoint>& points) const;

 private:
  // A cell of a grid of squares with side 4 tau L. All points within tau L of a given point lie in
  // at most four of these squares.
  using Cell = std::array<double, 2>;
  Cell cell_of(const Vec2& p) const;
  // Takes each vertex in the cells around a point, among them all within tau L of it.
  template <class Take>
  void each_vertex_near(const Vec2& p, Take take) const;

  const Polygon& polygon_;
  double near_;
  std::vector<Cell> cells_;             // by vertex
  std::vector<std::uint32_t> by_cell_;  // the vertices in the order of their cells
  Corners corners_;
};

}  // namespace evenlift
