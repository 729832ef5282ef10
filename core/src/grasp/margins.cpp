#include "grasp/margins.h"

#include "grasp/grasp.h"

namespace evenlift {

Margins::Margins(const Polygon& polygon, const Vec2& centre, double clear)
    : polygon_(polygon),
      centre_(centre),
      radius_(farthest_vertex(polygon, centre)),
      clear_(clear),
      finder_(polygon) {}

std::vector<Wrench> Margins::wrenches_of(const std::vector<LiftingPoint>& points) const {
  return wrenches(make_grasp(polygon_, centre_, radius_,
                             clear_contacts(polygon_, finder_.find(points), clear_)));
}

std::optional<double> Margins::of(const std::vector<LiftingPoint>& points) const {
  const std::vector<Wrench> all = wrenches_of(points);
  if (all.empty()) return std::nullopt;
  return wrench_margin(all);
}

}  // namespace evenlift
