// The coverage of many lifting bases of one object.
#pragma once

#include <cstdint>
#include <vector>

#include "balanced/small_hull.h"
#include "evenlift/polygon_with_holes.h"
#include "polygon/edge_tree.h"

namespace evenlift::balanced {

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

}  // namespace evenlift::balanced
