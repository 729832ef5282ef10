#include "output/svg/svg_bodies.h"

#include "evenlift/output/markup.h"
#include "evenlift/output/words.h"
#include "evenlift/placed_robots.h"
#include "evenlift/stands.h"
#include "output/svg/svg_markup.h"
#include "output/svg/svg_style.h"

namespace evenlift::svg {
namespace {

constexpr std::string_view unusable_colour = "#9AA5B1", marked_colour = "#C77700",
                           body_colour = "#1B232B";

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
  const double radius = length(paper(robot.stand + Vec2(size.radius, 0)) - middle);
  return out +
         element("circle", attribute("class", "body") + attribute("cx", middle.x()) +
                               attribute("cy", middle.y()) + attribute("r", radius) +
                               attribute("fill", body_colour) + attribute("fill-opacity", 0.15) +
                               attribute("stroke", body_colour));
}

}  // namespace

Points extent(const Placement& placement) {
  Points points = placement.vertices();
  if (!placement.stands || !placement.stands->has_body()) return points;
  const double radius = placement.stands->robot().radius;
  for (const PlacedRobot& robot : placed_robots(placement)) {
    points.emplace_back(robot.stand - Vec2(radius, radius));
    points.emplace_back(robot.stand + Vec2(radius, radius));
  }
  return points;
}

std::string unusable_boundary(const Placement& placement, const Paper& paper) {
  if (!placement.stands) return "";
  std::string out;
  const Polygon& polygon = placement.polygon;
  for (const UnusablePart& part : placement.stands->unusable()) {
    const Vec2 &a = polygon.edge_start(part.edge), &b = polygon.edge_end(part.edge);
    const Vec2 along = (b - a) / length(b - a);
    const bool marked = part.why == WhyUnusable::no_go;
    out += element(
        "path",
        attribute("class", marked ? "no-go" : "unusable") +
            path({paper(a + part.part.from * along), paper(a + part.part.to * along)}, false) +
            attribute("stroke", marked ? marked_colour : unusable_colour) +
            attribute("stroke-width", 5));
  }
  return out;
}

std::string bodies(const Placement& placement, const Paper& paper) {
  if (!placement.stands || !placement.stands->has_body()) return "";
  std::string out;
  for (const PlacedRobot& robot : placed_robots(placement))
    out += body(robot, placement.stands->robot(), paper);
  return out;
}

}  // namespace evenlift::svg
