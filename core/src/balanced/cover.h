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
  // The object must outlive it. O(n).
  Cover(const PolygonWithHoles& object, const Vec2& centre);

  // Equals coverage(object, hull) up to rounding if C is inside H. It is 0 if C is not inside by
  // more than rounding (so, too, if H has no area). For each place where the boundary crosses H
  // O(h log n), and O(n h) at worst.
  double of(const SmallHull& hull) const;

 private:
  class Sum;

  const PolygonWithHoles& object_;
  Vec2 centre_;
  EdgeTree tree_;
  std::vector<double> doubled_areas_;  // by edge: of the triangles of C and the preceding edges
};

}  // namespace evenlift::balanced
