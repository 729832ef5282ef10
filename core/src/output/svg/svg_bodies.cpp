#include "output/svg/svg_bodies.h"

#include "evenlift/output/markup.h"
#include "evenlift/output/words.h"
#include "evenlift/stands.h"
#include "output/svg/svg_cargo.h"
#include "output/svg/svg_markup.h"
#include "output/svg/svg_style.h"

namespace evenlift::svg {
namespace {

std::string body(const PlacedRobot& robot, const RobotSize& size, const Paper& paper) {
  const Vec2 inward = robot.contact - robot.stand;
  const double way = length(inward);
  std::string out;
  if (size.reach > 0)
    out += element("path", attribute("class", "arm") +
                               path({paper(robot.stand), paper(robot.contact)}, false) +
                               attribute("stroke", body_colour) + attribute("stroke-width", 3));
  if (way > 0 && (size.depth > 0 || size.width > 0)) {
    const Vec2 aside = left_normal(inward) * (size.width / 2 / way);
    const Points hand{paper(robot.contact - aside), paper(robot.contact + aside),
                      paper(robot.at + aside), paper(robot.at - aside)};
    out += element("path", attribute("class", "hand") + path(hand, true) +
                               attribute("fill", body_colour) + attribute("fill-opacity", 0.3) +
                               attribute("stroke", body_colour));
  }
  if (size.radius == 0) return out;
  const Vec2 middle = paper(robot.stand);
  const double radius = size.radius * paper.scale;
  return out +
         element("circle", attribute("class", "body") + attribute("cx", middle.x) +
                               attribute("cy", middle.y) + attribute("r", radius) +
                               attribute("fill", body_colour) + attribute("fill-opacity", 0.15) +
                               attribute("stroke", body_colour));
}

}  // namespace

std::vector<PlacedRobot> robots_with_size(const Placement& placement) {
  if (!placement.stands || !placement.stands->has_body()) return {};
  return placed_robots(placement);
}

Points extent(const Placement& placement, const std::vector<PlacedRobot>& robots) {
  Points points = placement.vertices();
  for (const PlacedRobot& robot : robots) {
    const double radius = placement.stands->robot().radius;
    points.emplace_back(robot.stand - Vec2(radius, radius));
    points.emplace_back(robot.stand + Vec2(radius, radius));
  }
  add_discs_of_cargo(placement, points);
  return points;
}

std::string unusable_boundary(const Placement& placement, const Paper& paper) {
  if (!placement.stands) return "";
  std::string out;
  const Polygon& polygon = placement.polygon();
  for (const UnusablePart& part : placement.stands->unusable()) {
    const Vec2 &a = polygon.edge_start(part.edge), &b = polygon.edge_end(part.edge);
    const Vec2 along = (b - a) / length(b - a);
    const bool marked = part.why == WhyUnusable::no_go;
    out += element(
        "path",
        attribute("class", marked ? "no-go" : "unusable") +
            path({paper(a + part.part.from * along), paper(a + part.part.to * along)}, false) +
            attribute("stroke", marked ? no_go_colour : unusable_colour) +
            attribute("stroke-width", 5));
  }
  return out;
}

std::string bodies(const std::vector<PlacedRobot>& robots, const RobotSize& size,
                   const Paper& paper) {
  std::string out;
  for (const PlacedRobot& robot : robots) out += body(robot, size, paper);
  return out;
}

Box body_box(const PlacedRobot& robot, const RobotSize& size, const Paper& paper) {
  const Vec2 middle = paper(robot.stand), reach = Vec2(1, 1) * (size.radius * paper.scale);
  return {middle - reach, middle + reach};
}

}  // namespace evenlift::svg
