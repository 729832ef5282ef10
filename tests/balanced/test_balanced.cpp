// Balanced robots are valid sets, whatever the object; examples of their definition.
#include <cmath>
#include <string>

#include "balanced/for_oracle.h"
#include "evenlift/balanced.h"
#include "evenlift/failures.h"
#include "evenlift/generate.h"
#include "evenlift/output/words.h"
#include "evenlift/placement.h"
#include "kit/catch.h"
#include "kit/corpus.h"
#include "kit/placed.h"
#include "shapes/problem_document.h"
#include "shapes/small_polygons.h"

using namespace evenlift;
using evenlift::testing::object_of;
using evenlift::testing::placed;
using evenlift::testing::plain;

namespace {

Document asked(Document document, std::uint32_t robots, std::optional<Goal> goal = {}) {
  document.settings = {};
  document.settings.method = Method::balanced;
  document.settings.robots = robots;
  document.settings.goal = goal;
  return document;
}

Document unit_square() {
  Document document;
  document.vertices = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  return document;
}

// Properties of every balanced placement.
void check(const Placement& placement, std::uint32_t robots) {
  REQUIRE(placement.teams.size() == 1);
  const Team& team = placement.teams[0];
  CHECK(team.robots.size() == robots);
  CHECK(team.ratio == 1);
  for (const Robot& robot : team.robots) CHECK(robot.load == placement.weight() / robots);
  CHECK(placement.loads->spread == 0);

  const set_oracle::Object object = object_of(placement.polygon(), placement.centre_of_mass);
  const std::vector<set_oracle::Point> points = plain(lifting_points(placement.teams));
  const double size = set_oracle::diameter(object);
  for (const set_oracle::Point& p : points)
    CHECK(set_oracle::away_from_outline(object, p) <= 1e-9 * size);
  CHECK(set_oracle::imbalance(object, points) <= 3e-9 * size);
  CHECK(placement.coverage == Approx(set_oracle::coverage(object, points)).margin(1e-9));
  const std::optional<double> margin = set_oracle::margin(object, points);
  if (placement.closure.margin && *placement.closure.margin > 1e-6 && margin)
    CHECK(*placement.closure.margin == Approx(*margin).margin(1e-9));
  if (margin && *margin > 1e-6) CHECK(placement.closure.form_closure);
  const bool holds = goal_of(placement.settings) == Goal::hold;
  CHECK(placement.goal_reached == (!holds || placement.closure.form_closure));
}

}  // namespace

TEST_CASE("balanced robots stand on the outline, about the centre of mass, and carry the same load",
          "[balanced][thorough]") {
  for (const std::string& name : corpus::polygon_names()) {
    INFO(name);
    for (const std::uint32_t robots : {2u, 3u, 5u, 6u})
      check(placed(asked(corpus::polygon(name), robots)), robots);
  }
}

TEST_CASE("hard little shapes have valid balanced robots", "[balanced][slow]") {
  int with_robots = 0;
  for (std::uint64_t number = 0; number < 120; ++number) {
    INFO("case " << number);
    const Document document = testing::document_of(small_polygons::make_plain_case(number).problem);
    const auto robots = static_cast<std::uint32_t>(3 + number % 4);
    const Placement placement = placed(asked(document, robots));
    if (placement.teams.empty()) {
      CHECK_FALSE(placement.goal_reached);
      CHECK_FALSE(placement.loads);
    } else {
      check(placement, robots);
      ++with_robots;
    }
  }
  CHECK(with_robots > 100);
}

TEST_CASE("a square has the known balanced robots", "[balanced]") {
  const auto coverage = [](std::uint32_t robots) {
    return placed(asked(unit_square(), robots)).coverage;
  };
  CHECK(coverage(3) == Approx(3.0 / 8).epsilon(1e-12));
  CHECK(coverage(4) >= 0.482421875 - 1e-9);
  CHECK(coverage(5) >= 0.87353515625 - 1e-9);
  CHECK(coverage(6) >= 0.9970703125 - 1e-9);
  CHECK(*placed(asked(unit_square(), 4)).closure.margin == Approx(0.128153649).epsilon(1e-6));
  CHECK(*placed(asked(unit_square(), 6)).closure.margin == Approx(13.0 / 36).epsilon(1e-9));
}

TEST_CASE("samples have balanced robots as good as the prototype's", "[balanced]") {
  const auto of_sample = [](const char* name, std::uint32_t robots, std::optional<Goal> goal = {}) {
    return placed(asked(corpus::polygon(name), robots, goal));
  };
  // The prototype relied on contacts a hair beside corners.
  const auto by_a_hair = [](const char* name, std::uint32_t robots) {
    Document document = asked(corpus::polygon(name), robots);
    document.settings.clear = 0;
    return placed(document);
  };
  CHECK(by_a_hair("grand-piano", 6).coverage >= 0.9185);
  CHECK(by_a_hair("triangle", 4).coverage >= 0.8775);
  CHECK(of_sample("grand-piano", 6).coverage >= 0.916);
  CHECK(of_sample("triangle", 4).coverage >= 0.8695);
  for (const auto& [name, robots] : {std::pair("grand-piano", 6u), {"triangle", 4u}}) {
    CHECK(of_sample(name, robots).goal_reached);
    CHECK(by_a_hair(name, robots).closure.form_closure);
  }
  const Placement boomerang = of_sample("boomerang", 3, Goal::hold);
  CHECK(boomerang.coverage >= 0.1115);
  CHECK(boomerang.closure.form_closure);
  CHECK(of_sample("boomerang", 3).coverage > 2 * boomerang.coverage);
}

TEST_CASE("with many robots the base is nearly the whole object", "[balanced][slow]") {
  const Placement placement = placed(asked(corpus::polygon("grand-piano"), 20));
  check(placement, 20);
  CHECK(placement.coverage > 0.97);
}

TEST_CASE("robots are as far apart as is asked, where they can be", "[balanced]") {
  Document document = asked(unit_square(), 6);
  const double diagonal = std::sqrt(2.0);
  for (const double apart : {0.0, 0.2, 0.4}) {
    document.settings.apart = apart;
    CHECK(set_oracle::least_distance(plain(lifting_points(placed(document).teams))) >=
          apart - 1e-9 * diagonal);
  }
  // Six robots cannot all be one side apart.
  document.settings.apart = 1;
  CHECK(set_oracle::least_distance(plain(lifting_points(placed(document).teams))) < 1);
}

TEST_CASE("balanced robots survive the failures that they are asked to", "[balanced][slow]") {
  for (const char* name : {"grand-piano", "arrow", "letter-e", "hexagon"}) {
    INFO(name);
    Document document = asked(corpus::polygon(name), 6);
    document.settings.survive = 1;
    const Placement placement = placed(document);
    Points robots;
    for (const Robot& robot : placement.teams[0].robots) robots.push_back(robot.point.position);
    CHECK(failures_steady(robots, placement.centre_of_mass, placement.polygon().diameter()) >= 1);
  }
}

TEST_CASE("settings of balanced robots that do not go together are refused", "[balanced]") {
  Document document = asked(unit_square(), 6);
  document.settings.survive = 2;
  REQUIRE(check_settings(document.settings));
  CHECK(check_settings(document.settings)->place.option == "survive");
  document.settings.robots = 7;
  CHECK_FALSE(check_settings(document.settings));
  document.settings.robots = 65;
  CHECK(check_settings(document.settings)->place.option == "robots");
}

TEST_CASE("where no set has its centroid at the centre of mass, no robot is placed", "[balanced]") {
  // C is in the notch, near the line through both tips but not its middle.
  Document document;
  document.vertices = {{0, 0}, {5, -6}, {10, 0}, {5, -4.8}};
  document.centre_of_mass = Vec2(2.5, -0.05);
  for (const std::uint32_t robots : {2u, 3u, 6u}) {
    const Placement placement = placed(asked(document, robots));
    CHECK(placement.teams.empty());
    CHECK_FALSE(placement.loads);
    CHECK_FALSE(placement.goal_reached);
    CHECK(verdict(placement) == "No robots can be placed. No places were found for " +
                                    std::to_string(robots) +
                                    " balanced robots: their centroid must be the centre of mass.");
  }
}

TEST_CASE("only a start that is quick is shown at once", "[balanced][slow]") {
  const auto at_once = [](const Document& document, std::uint32_t robots) {
    const Result<Placement> placement = place(asked(document, robots), Effort::start);
    REQUIRE(placement.ok());
    CHECK((placement->search_ended || placement->teams.empty() ||
           placement->teams[0].robots.size() == robots));
    return !placement->teams.empty();
  };
  CHECK(at_once(corpus::polygon("grand-piano"), 4));
  CHECK(at_once(corpus::polygon("grand-piano"), 64));
  CHECK(at_once(corpus::polygon("labyrinth"), 6));
  CHECK_FALSE(at_once(corpus::polygon("labyrinth"), 4));
  for (const Family family : {Family::star, Family::comb}) {
    Document spiky;
    spiky.vertices = *generate(family, 2000, 1);
    CHECK_FALSE(at_once(spiky, 3));
    CHECK_FALSE(at_once(spiky, 6));
  }
}
