// Finds the nearest vertex within a distance of a point.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "evenlift/closure.h"

namespace evenlift {

class VertexFinder {
 public:
  // The polygon must outlive it. O(n log n).
  VertexFinder(const Polygon& polygon, double near);

  // The nearest vertex within `near`, if there is one. O(log n) and the vertices within `near` in
  // x.
  std::optional<std::uint32_t> find(const Vec2& p) const;

 private:
  const Polygon& polygon_;
  double near_;
  std::vector<std::uint32_t> by_x_;
};

// The same as contacts(), with a finder that is there already. O(m log n).
std::vector<Contact> find_contacts(const Polygon& polygon, const VertexFinder& finder,
                                   const std::vector<LiftingPoint>& points);

}  // namespace evenlift
