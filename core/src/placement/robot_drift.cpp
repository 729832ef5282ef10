#include "placement/robot_drift.h"

#include "evenlift/tolerance.h"
#include "polygon/outline_walk.h"

namespace evenlift {
namespace {

// On along the outline, or back.
ErrorDirection along_outline(const Polygon& polygon, const LiftingPoint& point) {
  const double near = near_distance(polygon.diameter());
  const auto along = [&](std::size_t edge) {
    const Vec2 way = polygon.edge_end(edge) - polygon.edge_start(edge);
    return way / length(way);
  };
  std::size_t on = point.edge, back = point.edge;
  if (length(point.position - polygon.edge_start(point.edge)) <= near)
    back = polygon.previous(point.edge);
  else if (length(point.position - polygon.edge_end(point.edge)) <= near)
    on = polygon.next(point.edge);
  return {ErrorDirection::Kind::along, {along(on), -along(back)}};
}

}  // namespace

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

std::vector<ErrorDirection> error_directions(const Placement& placement,
                                             const std::vector<RobotDrift>& drifts) {
  using Kind = ErrorDirection::Kind;
  const Polygon& polygon = placement.polygon();
  std::vector<ErrorDirection> directions;
  for (const LiftingPoint& point : lifting_points(placement.teams)) {
    ErrorDirection direction;
    if (point.edge == beneath)
      direction.kind = Kind::any;
    else if (!drifts[directions.size()].is_fixed())
      direction = along_outline(polygon, point);
    directions.push_back(direction);
  }
  return directions;
}

}  // namespace evenlift
