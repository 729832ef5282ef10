#include "evenlift/placed_robots.h"

#include <cmath>
#include <string>

#include "evenlift/angles.h"
#include "evenlift/plane.h"
#include "kit/catch.h"
#include "kit/corpus.h"
#include "kit/placed.h"
#include "kit/polygons.h"
#include "kit/solid.h"

using namespace evenlift;
using evenlift::testing::placed;

namespace {

// At the point of the edge.
double heading(const Points& vertices, const Vec2& at, std::uint32_t edge) {
  Placement placement(solid(testing::polygon(vertices)));
  placement.teams = {Team{{Robot{{at, edge}, 1, 1}}, 1}};
  return placed_robots(placement).at(0).heading_deg;
}

}  // namespace

TEST_CASE("a robot faces the object", "[robustness][robots]") {
  const Points square{{0, 0}, {4, 0}, {4, 4}, {0, 4}};
  CHECK(heading(square, {1, 0}, 0) == 90);
  CHECK(heading(square, {4, 1}, 1) == 180);
  CHECK(heading(square, {1, 4}, 2) == -90);
  CHECK(heading(square, {0, 1}, 3) == 0);
  const Points clockwise{{0, 4}, {4, 4}, {4, 0}, {0, 0}};
  CHECK(heading(clockwise, {1, 4}, 0) == -90);
  CHECK(heading(clockwise, {0, 1}, 3) == 0);
}

TEST_CASE("a robot at a vertex faces the middle between the directions of its edges",
          "[robustness][robots]") {
  const Points l_shape{{0, 0}, {4, 0}, {4, 2}, {2, 2}, {2, 4}, {0, 4}};
  CHECK(heading(l_shape, {0, 0}, 0) == Approx(45));
  CHECK(heading(l_shape, {0, 0}, 5) == Approx(45));
  CHECK(heading(l_shape, {4, 0}, 0) == Approx(135));
  CHECK(heading(l_shape, {2, 2}, 2) == Approx(-135));  // an inward corner
  CHECK(heading(l_shape, {2, 2 + 1e-9}, 3) == Approx(-135));
  CHECK(heading(l_shape, {2, 3}, 3) == Approx(180));
  const Points clockwise(l_shape.rbegin(), l_shape.rend());
  CHECK(heading(clockwise, {2, 2}, 2) == Approx(-135));
  CHECK(heading(clockwise, {0, 0}, 5) == Approx(45));
}

TEST_CASE("a step ahead of each robot of the samples is the object", "[robustness][robots]") {
  int robots = 0;
  for (const std::string& name : corpus::polygon_names()) {
    Document document = corpus::polygon(name);
    document.settings.method = Method::distributed;
    document.settings.teams = 6;
    const Placement placement = placed(document);
    const double step = 1e-6 * bounding_box(placement.vertices()).diagonal();
    INFO(name);
    for (const PlacedRobot& robot : placed_robots(placement)) {
      const double angle = robot.heading_deg * pi / 180;
      CHECK(inside(placement.vertices(), robot.at + step * Vec2(cosine(angle), sine(angle))));
      CHECK_FALSE(inside(placement.vertices(), robot.at - step * Vec2(cosine(angle), sine(angle))));
      CHECK(robot.heading_deg > -180);
      CHECK(robot.heading_deg <= 180);
      ++robots;
    }
  }
  CHECK(robots > 1000);
}

TEST_CASE("robots come team after team with their loads", "[robustness][robots]") {
  Document document = corpus::polygon("grand-piano");
  const Placement placement = placed(document);
  const auto robots = placed_robots(placement);
  REQUIRE(robots.size() == 6);
  for (std::size_t i = 0; i < robots.size(); ++i) {
    CHECK(robots[i].team == i / 2);
    CHECK(robots[i].at == placement.teams[i / 2].robots[i % 2].point.position);
    CHECK(robots[i].load == placement.teams[i / 2].robots[i % 2].load);
  }
}

TEST_CASE("every sample is carried in every model, by every method",
          "[robustness][robots][thorough]") {
  int carried = 0;
  for (const std::string& name : corpus::polygon_names()) {
    for (const Method method : all_methods) {
      Document document = corpus::polygon(name);
      document.settings.method = method;
      const Placement placement = placed(document);
      INFO(name << " by " << evenlift::name(method));
      const auto loads = model_loads(placement);
      REQUIRE(loads.has_value() == !placement.teams.empty());
      if (!loads) continue;
      ++carried;
      double sum = 0;
      for (const double load : loads->springs.loads) sum += load;
      CHECK(sum == Approx(placement.weight()).epsilon(1e-9));
      CHECK(loads->best <= placement.loads->max * (1 + 1e-9));
    }
  }
  CHECK(carried > 500);
}

TEST_CASE("even teams share evenly by themselves if the robots are equally stiff",
          "[robustness][robots]") {
  Document document = corpus::polygon("grand-piano");
  document.settings.min_ratio = 1;
  const Placement placement = placed(document);
  REQUIRE(placement.teams.size() == 3);
  const auto loads = model_loads(placement);
  REQUIRE(loads);
  for (const double load : loads->springs.loads) CHECK(load == Approx(100.0 / 6).epsilon(1e-9));
}

TEST_CASE("with a robot that fails the others are in equilibrium, on what is left of the base",
          "[robustness][robots]") {
  int held = 0;
  for (const char* name : {"grand-piano", "boomerang", "square", "letter-e"}) {
    const Placement placement = placed(corpus::polygon(name));
    const auto rests = single_failures(placement);
    for (std::size_t robot = 0; robot < rests.size(); ++robot) {
      INFO(name << ", robot " << robot);
      const Placement failing = with_failure(placement, robot);
      REQUIRE(count_robots(failing.teams) == rests.size());
      CHECK(failing.loads.has_value() == rests[robot].has_value());
      CHECK(single_failure(placement, robot).has_value() == rests[robot].has_value());
      CHECK(ranges_without(placement, robot, {}).has_value() == rests[robot].has_value());
      const std::vector<double> loads = planned_loads(failing.teams);
      CHECK(loads[robot] == 0);
      held += rests[robot].has_value();
      if (!rests[robot]) {
        CHECK(failing.coverage == 0);
        continue;
      }
      double sum = 0;
      Vec2 moment;
      const std::vector<LiftingPoint> points = lifting_points(failing.teams);
      for (std::size_t i = 0; i < loads.size(); ++i) {
        sum += loads[i];
        moment += loads[i] * (points[i].position - placement.centre_of_mass);
      }
      CHECK(std::abs(sum - 100) < 1e-9 * 100);
      CHECK(length(moment) < 1e-9 * 100 * placement.polygon().diagonal());
      CHECK(failing.loads->max == rests[robot]->greatest_by_springs);
      CHECK(failing.loads->min > -1e-12);
      CHECK(failing.coverage <= placement.coverage + 1e-12);
    }
  }
  CHECK(held > 10);
}

TEST_CASE(
    "where the others do not carry the object nothing of it is covered, else they share it all",
    "[robustness][robots]") {
  Document document;
  document.vertices = {{-2, -2}, {2, -2}, {2, 2}, {-2, 2}};
  document.settings.method = Method::balanced;
  document.settings.robots = 5;
  // Without the first robot, all others are on the right of C.
  const Placement placement = with_robots(
      placed(document),
      {{{-2, 0}, 3}, {{0.25, 2}, 2}, {{0.25, -2}, 0}, {{0.75, 2}, 2}, {{0.75, -2}, 0}}, true);
  const Placement falling = with_failure(placement, 0);
  CHECK_FALSE(falling.loads);
  CHECK_FALSE(falling.lifting_base.empty());
  CHECK(falling.coverage == 0);
  for (std::size_t robot = 1; robot < 5; ++robot) {
    const Placement carried = with_failure(placement, robot);
    REQUIRE(carried.loads);
    CHECK(carried.loads->mean == 25);
    CHECK(carried.coverage > 0);
  }
}

TEST_CASE("the loads that are shown are those of the model, with ranges where it has some",
          "[robustness][robots]") {
  const Placement placement = placed(corpus::polygon("grand-piano"));
  const std::optional<ModelLoads> models = model_loads(placement);
  REQUIRE(models);
  const auto shown = [&](LoadModel model, double radius) {
    return loads_by(model, placement, model_loads(placement, {.com_radius = radius}));
  };
  for (std::size_t i = 0; i < count_robots(placement.teams); ++i) {
    CHECK(shown(LoadModel::plan, 0)[i].least == planned_loads(placement.teams)[i]);
    CHECK(shown(LoadModel::springs, 0)[i].greatest == models->springs.loads[i]);
    CHECK(shown(LoadModel::best, 5)[i].least == models->best);
    CHECK(shown(LoadModel::worst, 5)[i].greatest == models->worst[i]);
    const double change = 5 * models->springs.per_length[i];
    CHECK(shown(LoadModel::springs, 5)[i].greatest == Approx(models->springs.loads[i] + change));
    CHECK(loads_by(LoadModel::worst, placement, std::nullopt)[i].least ==
          planned_loads(placement.teams)[i]);
  }
}
