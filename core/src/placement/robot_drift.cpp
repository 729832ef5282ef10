#include "placement/robot_drift.h"

#include <algorithm>

namespace evenlift {

RobotDrift::RobotDrift(const Polygon& polygon, const LiftingPoint& contact, bool in_notch)
    : polygon_(polygon), contact_(contact), in_notch_(in_notch) {}

double RobotDrift::way(double arm, double error) const {
  if (in_notch_) return 0;
  return arm > 0 && contact_.edge != beneath ? error + arm * turn(error) : error;
}

double RobotDrift::turn(double error) const {
  const Vec2 own = inward_normal(polygon_, contact_.edge);
  double greatest = 0;
  for (const bool on : {true, false}) {
    std::size_t edge = contact_.edge;
    Vec2 at = contact_.position;
    double left = error;
    for (std::size_t passed = 0; passed < polygon_.size(); ++passed) {
      const std::size_t end = on ? polygon_.next(edge) : edge;
      left -= length(polygon_.vertex(end) - at);
      if (left < 0) break;
      at = polygon_.vertex(end);
      edge = on ? end : polygon_.previous(edge);
      const Vec2 normal = inward_normal(polygon_, static_cast<std::uint32_t>(edge));
      greatest = std::max(greatest, length(normal - own));
    }
  }
  return greatest;
}

std::vector<RobotDrift> drifts_of(const Placement& placement) {
  const std::vector<LiftingPoint> points = contact_points(placement);
  std::vector<bool> in_notch(points.size(), false);
  for (const Contact& contact : contacts(placement.polygon(), points))
    if (contact.in_notch) in_notch[contact.point] = true;
  std::vector<RobotDrift> drifts;
  drifts.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    drifts.emplace_back(placement.polygon(), points[i], in_notch[i]);
  return drifts;
}

}  // namespace evenlift
