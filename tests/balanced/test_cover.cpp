// The coverage of many sets, and its bound, against the coverage of one.
#include <cmath>
#include <string>

#include "balanced/coarse_cover.h"
#include "balanced/cover.h"
#include "evenlift/hull.h"
#include "evenlift/predicates.h"
#include "evenlift/random.h"
#include "evenlift/stability.h"
#include "kit/catch.h"
#include "kit/corpus.h"
#include "kit/polygons.h"
#include "kit/solid.h"

using namespace evenlift;

namespace {

std::vector<LiftingPoint> any_robots(const Polygon& polygon, Rng& rng) {
  std::vector<LiftingPoint> robots(3 + rng.below(8));
  for (LiftingPoint& robot : robots) {
    robot.edge = static_cast<std::uint32_t>(rng.below(polygon.size()));
    const double part = rng.below(4) == 0 ? 0 : rng.uniform();
    const Vec2 &a = polygon.edge_start(robot.edge), &b = polygon.edge_end(robot.edge);
    robot.position = a + part * (b - a);
  }
  return robots;
}

bool well_inside(const Points& hull, const Vec2& centre, double diagonal) {
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Vec2 &a = hull[i], &b = hull[(i + 1) % hull.size()];
    if (orient(a, b, centre) <= 1e-6 * diagonal * length(b - a)) return false;
  }
  return hull.size() > 2;
}

}  // namespace

TEST_CASE("the coverage of a set is the same, and its bound is above it", "[balanced][slow]") {
  Rng rng(3);
  int compared = 0;
  for (const std::string& name : corpus::polygon_names()) {
    INFO(name);
    const Document document = corpus::polygon(name);
    const Polygon polygon = testing::polygon(document.vertices);
    const Vec2 centre = *check_centre_of_mass(polygon, document.centre_of_mass);
    const PolygonWithHoles object = solid(polygon);
    const balanced::Cover cover(object, centre);
    const balanced::CoarseCover coarse(object, centre);
    for (int i = 0; i < 100; ++i) {
      const std::vector<LiftingPoint> robots = any_robots(polygon, rng);
      Points points;
      for (const LiftingPoint& robot : robots) points.push_back(robot.position);
      const Points hull = convex_hull(points);
      if (!well_inside(hull, centre, polygon.diagonal())) continue;
      const double expected = coverage(solid(polygon), hull);
      const balanced::SmallHull small = balanced::small_hull(robots, centre);
      CHECK(std::fabs(small.area - signed_area(hull)) <= 1e-12 * signed_area(hull));
      CHECK(std::fabs(cover.of(small) - expected) <= 1e-11);
      CHECK(coarse.most(small) >= expected - 1e-11);
      ++compared;
    }
  }
  CHECK(compared > 1000);
}
