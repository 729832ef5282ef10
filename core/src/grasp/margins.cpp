#include "grasp/margins.h"

#include "evenlift/tolerance.h"
#include "grasp/grasp.h"

namespace evenlift {

Margins::Margins(const Polygon& polygon, const Vec2& centre)
    : polygon_(polygon),
      centre_(centre),
      radius_(farthest_vertex(polygon, centre)),
      finder_(polygon, near_distance(polygon.diagonal())) {}

std::optional<double> Margins::of(const std::vector<LiftingPoint>& points) const {
  const auto contacts = find_contacts(polygon_, finder_, points);
  if (contacts.empty()) return std::nullopt;
  return wrench_margin(wrenches(make_grasp(polygon_, centre_, radius_, contacts)));
}

}  // namespace evenlift
