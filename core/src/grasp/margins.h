// The margins of many grasps of one object.
#pragma once

#include <optional>
#include <vector>

#include "evenlift/closure.h"
#include "grasp/vertex_finder.h"
#include "grasp/wrench_margin.h"

namespace evenlift {

class Margins {
 public:
  // The polygon must outlive it. O(n log n).
  Margins(const Polygon& polygon, const Vec2& centre);

  // The same as analyse_closure(polygon, centre, points).margin. O(m log n + m^2).
  std::optional<double> of(const std::vector<LiftingPoint>& points) const;

  // The wrenches of robots at the points, as the margin is found from them: of contacts on one edge
  // the first and the last. O(m log n).
  std::vector<Wrench> wrenches_of(const std::vector<LiftingPoint>& points) const;

 private:
  const Polygon& polygon_;
  Vec2 centre_;
  double radius_;
  VertexFinder finder_;
};

}  // namespace evenlift
