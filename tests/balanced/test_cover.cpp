// The coverage of many sets, and its bound, against that of one.
#include <cmath>
#include <string>

#include "balanced/search.h"
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

// A place moved by as little as its coordinates allow.
LiftingPoint shaken(Vec2 position, Rng& rng) {
  for (double* const axis : {&position.x, &position.y})
    for (std::uint64_t steps = rng.below(4); steps > 0; --steps)
      *axis = std::nextafter(*axis, rng.below(2) == 0 ? -1e300 : 1e300);
  LiftingPoint robot;
  robot.position = position;
  return robot;
}

}  // namespace

// Two pairs at the ends of a chord span a base as thin as rounding, or none.
TEST_CASE("a base that is thin as rounding covers nothing", "[balanced]") {
  Rng rng(5);
  // Such a base once covered an infinite share of this object.
  const Polygon polygon = testing::polygon({{9.297922186016947, -3.6808481390535093},
                                            {9.488625200072306, 3.156895914114508},
                                            {5.239495028691213, 8.517493284078343},
                                            {-1.4612530971154514, 9.892660885028366},
                                            {-7.4782646587626065, 6.63894251319457},
                                            {-9.996113074920814, 0.2787891558096973},
                                            {-7.836669088901517, -6.2118127459748615},
                                            {-2.0103605413097005, -9.795838427309064},
                                            {4.756618046229599, -8.796282439888067}});
  const PolygonWithHoles object = solid(polygon);
  const Vec2 centre(-1.8787448048800242, 6.121300348629878);
  const balanced::Cover cover(object, centre);
  const Vec2 ends[] = {{-8.659230241312937, 3.65579143602444},
                       {4.901740631552889, 8.586809261235315}};
  for (int i = 0; i < 10'000; ++i) {
    std::vector<LiftingPoint> robots;
    for (int robot = 0; robot < 4; ++robot) robots.push_back(shaken(ends[robot % 2], rng));
    std::uint64_t steps = 0;
    const double covered = cover.of(balanced::small_hull(robots, centre), steps);
    REQUIRE(covered >= 0);
    REQUIRE(covered <= 1e-12);
  }
}

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
      std::uint64_t steps = 0;
      CHECK(std::fabs(cover.of(small, steps) - expected) <= 1e-11);
      CHECK(steps > 0);
      CHECK(coarse.most(small) >= expected - 1e-11);
      ++compared;
    }
  }
  CHECK(compared > 1000);
}
