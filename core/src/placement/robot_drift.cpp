#include "placement/robot_drift.h"

#include "polygon/outline_walk.h"

namespace evenlift {

RobotDrift::RobotDrift(const Polygon& polygon, const LiftingPoint& contact, bool in_notch)
    : polygon_(polygon), contact_(contact), in_notch_(in_notch) {}

double RobotDrift::way(double arm, double error) const {
  if (in_notch_) return 0;
  if (!(arm > 0) || contact_.edge == beneath) return error;
  return error + arm * greatest_turn(polygon_, contact_.position, contact_.edge, error);
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
