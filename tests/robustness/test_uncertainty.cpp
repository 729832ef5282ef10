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
  const auto ranges = load_ranges({10, 2}, {{}, false, {2, 1}, {50, 60}, {3, 0.5}});
  CHECK(ranges[0].least == 8);
  CHECK(ranges[0].greatest == 12);
  CHECK(ranges[1].least == 1);
  CHECK(ranges[1].greatest == 3);
  // If one may go slack, the ends hold whichever robots carry.
  const auto wider = load_ranges({10, 2}, {{}, false, {4, 4}, {50, 60}, {3, 0.5}});
  CHECK(wider[0].least == 3);
  CHECK(wider[0].greatest == 50);
  CHECK(wider[1].least == 0.5);
  CHECK(wider[1].greatest == 60);
  // On a slope, a part of the weight acts along the ground, and less of it holds a robot down.
  const auto on_slope = [](double by) {
    return load_ranges({10, 2}, {{.kept = 0.9}, false, {by, by}, {50, 60}, {3, 0.5}})[0];
  };
  CHECK(on_slope(1.7).least == Approx(7.3));
  CHECK(on_slope(1.7).greatest == 11.7);
  CHECK(on_slope(1.9).least == 3);
  CHECK(on_slope(1.9).greatest == 50);
  const Points corners{{0, 0}, {1e-9, 0}, {1e-9, 1e-9}, {0, 1e-9}};
  const Vec2 centre(5e-10, 5e-10);
  const auto springs = spring_loads(corners, centre, 1e-9, 1e100);
  const LoadChanges far = load_changes(corners, centre, 1e-9, 1e100, *springs,
                                       {.com_radius = 1e300, .uneven = 1e300, .give = 1});
  for (const LoadRange& range : load_ranges(springs->loads, far)) {
    CHECK(std::isfinite(range.greatest));
    CHECK(range.least == 0);
  }
}

TEST_CASE("loads may change by what uneven heights and a tilt do", "[robustness][uncertainty]") {
  const Points square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const Vec2 middle(0.5, 0.5);
  const auto springs = spring_loads(square, middle, std::sqrt(2), 100);
  const LoadChanges uneven =
      load_changes(square, middle, std::sqrt(2), 100, *springs, {.uneven = 1, .give = 4});
  for (const double by : uneven.by) CHECK(by == Approx(6.25));
  const LoadChanges tilted =
      load_changes(square, middle, std::sqrt(2), 100, *springs, {.height = 1, .slope = 0.2});
  for (const double by : tilted.by) CHECK(by == Approx(100 * 0.2 * std::sqrt(0.5)));
  // A plane fits any heights of three robots, or of two ends of a line.
  const Points three{{0, 0}, {1, 0}, {0, 1}}, two{{0, 0.5}, {1, 0.5}};
  const Vec2 third(0.3, 0.3);
  const auto of_three = spring_loads(three, third, 2, 100),
             of_two = spring_loads(two, middle, 2, 100);
  for (const std::optional<double> give : {std::optional<double>(1), std::optional<double>()}) {
    const Disturbance off{.uneven = 1, .give = give};
    CHECK(load_changes(three, third, 2, 100, *of_three, off).by == std::vector<double>{0, 0, 0});
    CHECK(load_changes(two, middle, 2, 100, *of_two, off).by == std::vector<double>{0, 0});
  }
  Points hexagon;
  for (int i = 0; i < 6; ++i)
    hexagon.emplace_back(std::cos(i * std::acos(-1.0) / 3), std::sin(i * std::acos(-1.0) / 3));
  const auto of_six = spring_loads(hexagon, Vec2{}, 2, 600);
  for (const double by :
       load_changes(hexagon, Vec2{}, 2, 600, *of_six, {.uneven = 1, .give = 1}).by)
    CHECK(by == Approx(400.0 / 3));
}

TEST_CASE("the worst load while C may be off is that at the worst place of C",
          "[robustness][uncertainty][thorough]") {
  int tips = 0;
  for (std::uint64_t number = 0; number < 300; ++number) {
    const RobotSet set = robot_sets::make_steady_set(number, 8);
    const double reach = set.diameter * 0.02 * static_cast<double>(number % 17);
    const auto worst = worst_loads(set.robots, set.centre, set.diameter, 1, reach);
    REQUIRE(worst);
    INFO(number << ", " << set.kind << ", reach " << reach);
    // A robot's worst load with C at this angle of the circle; below 0 where it tips.
    const auto load_at = [&](std::size_t robot, double angle) {
      const Vec2 centre = set.centre + reach * Vec2(std::cos(angle), std::sin(angle));
      const auto here = worst_loads(set.robots, centre, set.diameter, 1);
      return here ? (*here)[robot] : -1;
    };
    constexpr std::size_t directions = 720;
    const double step = 2 * std::acos(-1.0) / directions;
    std::vector<std::vector<double>> samples;
    for (std::size_t i = 0; i < directions; ++i) {
      const double turned = static_cast<double>(i) * step;
      const Vec2 centre = set.centre + reach * Vec2(std::cos(turned), std::sin(turned));
      const auto here = worst_loads(set.robots, centre, set.diameter, 1);
      if (!here) ++tips;
      samples.push_back(here.value_or(std::vector<double>(set.robots.size(), -1)));
    }
    for (std::size_t robot = 0; robot < set.robots.size(); ++robot) {
      const Vec2 to = set.robots[robot] - set.centre;
      // Loads fall along rays from the robot: C is worst at it, or on the circle.
      double angle = std::atan2(to.y, to.x);
      double sampled = length(to) <= reach ? 1 : load_at(robot, angle);
      for (std::size_t i = 0; i < directions; ++i) {
        if (samples[i][robot] <= sampled) continue;
        sampled = samples[i][robot];
        angle = static_cast<double>(i) * step;
      }
      for (double by = step; sampled < 1 && by > 1e-9; by /= 2)
        for (const double turned : {angle - by, angle + by})
          if (const double load = load_at(robot, turned); load > sampled) {
            sampled = load;
            angle = turned;
          }
      CHECK((*worst)[robot] == Approx(sampled).margin(1e-6));
    }
  }
  CHECK(tips > 1000);
}

TEST_CASE("the worst loads while C may be off are the same in every unit of length",
          "[robustness][uncertainty]") {
  const Points metres = {{0, 0}, {2, 0}, {2, 1}, {0, 1}};
  Points millimetres = metres;
  for (Vec2& robot : millimetres) robot *= 1000;
  const auto in_metres = worst_loads(metres, {1, 0.5}, std::sqrt(5), 100, 0.1);
  const auto in_millimetres = worst_loads(millimetres, {1000, 500}, 1000 * std::sqrt(5), 100, 100);
  REQUIRE((in_metres && in_millimetres));
  for (std::size_t i = 0; i < metres.size(); ++i)
    CHECK((*in_metres)[i] == Approx((*in_millimetres)[i]));
  CHECK((*in_metres)[0] < 99);
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
  // Nothing is promised beyond where a robot goes slack or the object tips.
  CHECK(within(30, 1000) == 20.0);
  CHECK(within(3, 1000) == 3.0);
  // Other changes leave less room.
  const std::vector<std::optional<double>> twelve(2, 12);
  CHECK(radius_within_capacity(springs, 30, twelve, {{.reach = 2}, false, {1, 0}, {}, {}}) == 2.0);
  CHECK(radius_within_capacity(springs, 3, twelve, {{.reach = 2}, false, {0, 0}, {}, {}}) == 1.0);
  CHECK_FALSE(radius_within_capacity(springs, 30, twelve, {{}, false, {2.5, 0}, {}, {}}));
  // On a slope, less weight holds a robot down.
  CHECK(radius_within_capacity(springs, 30, std::vector<std::optional<double>>(2),
                               {{.kept = 0.5}, false, {0, 0}, {}, {}}) == 1.0);
  // Rounding alone overloads no robot.
  CHECK(within(30, 10 * (1 - 1e-12)) == 0.0);
  // If another robot may begin to carry, only the worst loads are known, and only for this C.
  CHECK(radius_within_capacity(springs, 30, twelve, {{}, true, {0, 0}, {12, 12}, {}}) == 0.0);
  CHECK_FALSE(radius_within_capacity(springs, 30, twelve, {{}, true, {0, 0}, {12, 12.1}, {}}));
}
