#include "grasp/margins.h"

#include "evenlift/tolerance.h"
#include "grasp/grasp.h"
#include "grasp/hold_errors.h"
#include "grasp/hold_levels.h"

namespace evenlift {

Margins::Margins(const Polygon& polygon, const Vec2& centre, const HoldRequirements& hold)
    : polygon_(polygon),
      centre_(centre),
      radius_(farthest_vertex(polygon, centre)),
      hold_(hold),
      finder_(polygon) {}

std::vector<Wrench> Margins::wrenches_of(const std::vector<LiftingPoint>& points) const {
  return wrenches(make_grasp(polygon_, centre_, radius_,
                             clear_contacts(polygon_, finder_.find(points), hold_.clear)));
}

std::optional<double> Margins::of(const std::vector<LiftingPoint>& points) const {
  const std::vector<Wrench> all = wrenches_of(points);
  if (all.empty()) return std::nullopt;
  return wrench_margin(all);
}

bool Margins::are_firm(const std::vector<LiftingPoint>& points,
                       const WeakestDirection& margin) const {
  const double error = hold_.tolerance - near_distance(polygon_.diameter());
  return error <= 0 || HoldErrors(polygon_, centre_, radius_, finder_.find(points))
                           .hold_within(error, hold_.clear > error ? margin : WeakestDirection{});
}

Margins::Level Margins::level_of(const std::vector<LiftingPoint>& points) const {
  const std::vector<Wrench> all = wrenches_of(points);
  if (all.empty()) return {};
  const WeakestDirection margin = weakest_direction(all);
  const std::uint32_t level = evenlift::level_of(margin.margin, level_bounds(hold_.min_margin));
  return {level > 0 && are_firm(points, margin) ? level : 0, level > 0};
}

}  // namespace evenlift
