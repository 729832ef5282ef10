// How far C may be off.
#include "evenlift/uncertainty.h"

#include <cmath>

#include "evenlift/hull.h"
#include "evenlift/random.h"
#include "kit/catch.h"
#include "robustness/robot_sets.h"

using namespace evenlift;
using robot_sets::RobotSet;

namespace {

double tipping(const RobotSet& set) {
  return tipping_distance(convex_hull(set.robots, 1e-9 * set.diameter), set.centre, set.diameter);
}

std::optional<SpringLoads> springs(const RobotSet& set) {
  return spring_loads(set.robots, set.centre, set.diameter, 1);
}

}  // namespace

TEST_CASE("the object tips if C is off by the distance of the nearest edge",
          "[robustness][uncertainty]") {
  const Points square{{0, 0}, {4, 0}, {4, 4}, {0, 4}};
  CHECK(tipping_distance(square, {1, 2}, 6) == 1);
  CHECK(tipping_distance(square, {2, 3.5}, 6) == 0.5);
  CHECK(tipping_distance(square, {4, 2}, 6) == 0);
  CHECK(tipping_distance(square, {4 - 1e-9, 2}, 6) == 0);  // within the tolerance
  CHECK(tipping_distance(square, {4 - 1e-8, 2}, 6) == Approx(1e-8));
  CHECK(tipping_distance(square, {5, 2}, 6) == 0);
  CHECK(tipping_distance({{0, 0}, {4, 0}}, {1, 0}, 6) == 0);
  CHECK(tipping_distance({}, {1, 0}, 6) == 0);
}

TEST_CASE("robots carry until C is off by so much, and not beyond", "[robustness][uncertainty]") {
  for (std::uint64_t number = 0; number < 500; ++number) {
    const RobotSet set = robot_sets::make_steady_set(number, 12);
    const Points hull = convex_hull(set.robots, 1e-9 * set.diameter);
    const double distance = tipping(set);
    INFO(number << ", " << set.kind);
    REQUIRE(distance > 0);
    int tips = 0;
    for (std::size_t i = 0; i < hull.size(); ++i) {
      const Vec2 along = hull[(i + 1) % hull.size()] - hull[i];
      const Vec2 outward = -left_normal(along) / length(along);
      RobotSet moved = set;
      moved.centre = set.centre + (1 - 1e-6) * distance * outward;
      CHECK(springs(moved).has_value());
      moved.centre = set.centre + (1 + 1e-6) * distance * outward;
      tips += !springs(moved);
    }
    CHECK(tips >= 1);
  }
}

TEST_CASE("robots go slack before the object tips; three robots just then",
          "[robustness][uncertainty]") {
  int three = 0;
  for (std::uint64_t number = 0; number < 1000; ++number) {
    const RobotSet set = robot_sets::make_steady_set(number, 1 + number % 12);
    const auto loads = springs(set);
    REQUIRE(loads);
    INFO(number << ", " << set.kind);
    CHECK(loads->same_within <= tipping(set) * (1 + 1e-9));
    if (set.robots.size() != 3) continue;
    ++three;
    CHECK(loads->same_within == Approx(tipping(set)).epsilon(1e-9));
  }
  CHECK(three > 50);
}

TEST_CASE("ranges are as wide as the C uncertainty, and no load is below 0",
          "[robustness][uncertainty]") {
  const SpringLoads springs{{10, 2}, {0.5, 1}, 2};
  const auto ranges = load_ranges({10, 2}, springs, 4);
  CHECK(ranges[0].least == 8);
  CHECK(ranges[0].greatest == 12);
  CHECK(ranges[1].least == 0);
  CHECK(ranges[1].greatest == 6);
  const SpringLoads steep{{1, 1}, {1e308, 0}, 0};
  for (const LoadRange& range : load_ranges({1, 1}, steep, 1e308))
    CHECK(std::isfinite(range.greatest));
  CHECK(std::isfinite(greatest_change(steep, 1e308)));
  CHECK(greatest_change(springs, 4) == 4);
}

TEST_CASE("a capacity allows as much uncertainty as its first robot has room for",
          "[robustness][uncertainty]") {
  const SpringLoads springs{{10, 2}, {0.5, 1}, 20};
  const auto within = [&](double tipping, double capacity) {
    return radius_within_capacity(
        springs, tipping, std::vector<std::optional<double>>(springs.loads.size(), capacity));
  };
  CHECK(within(30, 12) == 4.0);
  CHECK(within(30, 10) == 0.0);
  CHECK_FALSE(within(30, 9.9));
  // Nothing is promised beyond the radius at which a robot goes slack or the object tips.
  CHECK(within(30, 1000) == 20.0);
  CHECK(within(3, 1000) == 3.0);
}
