#include "evenlift/accuracy.h"

#include <cmath>
#include <string>

#include "evenlift/output/requirements.h"
#include "evenlift/output/robustness_words.h"
#include "evenlift/output/verdict.h"
#include "evenlift/placed_robots.h"
#include "evenlift/placement.h"
#include "evenlift/supports.h"
#include "evenlift/tolerance.h"
#include "kit/catch.h"
#include "kit/corpus.h"
#include "kit/placed.h"
#include "kit/polygons.h"
#include "kit/texts.h"

using namespace evenlift;
using evenlift::testing::placed;
using evenlift::testing::plainly;

namespace {

// A square of side 10 on these supports.
Document on_square(const Points& supports) {
  Document document;
  document.vertices = {{0, 0}, {10, 0}, {10, 10}, {0, 10}};
  document.settings.method = Method::given;
  document.settings.supports = supports;
  return document;
}

Accuracy accuracy_of(const Document& document) {
  const Placement placement = placed(document);
  return report_of({placement, document.shown}).accuracy;
}

const Points held_square{{7, 0}, {10, 3}, {3, 10}, {0, 7}};

}  // namespace

TEST_CASE("what ends first is the least of what holds", "[accuracy]") {
  const Document document = on_square(held_square);
  const Accuracy all = accuracy_of(document);
  CHECK(*all[Promise::hold] == Approx(2).epsilon(1e-10));
  // The nearest edge of H is that between (10, 3) and (3, 10).
  CHECK(*all[Promise::stands] == Approx(3 / std::sqrt(2)).epsilon(1e-9));
  CHECK_FALSE(all[Promise::fits]);
  CHECK_FALSE(all[Promise::capacity]);
  REQUIRE(all.first);
  CHECK(all.first->what == Promise::hold);
  CHECK(all.first->within == Approx(2).epsilon(1e-10));
}

TEST_CASE("what does not hold anyway does not count", "[accuracy]") {
  const Accuracy beneath = accuracy_of(on_square({{3, 3}, {7, 3}, {7, 7}, {3, 7}}));
  CHECK_FALSE(beneath[Promise::hold]);
  REQUIRE(beneath.first);
  CHECK(beneath.first->what == Promise::stands);
  CHECK(beneath.first->within == Approx(2));
  const Accuracy falls = accuracy_of(on_square({{1, 1}, {3, 1}, {1, 3}}));
  CHECK_FALSE(falls.first);
}

TEST_CASE("a capacity ends where a load exceeds it, with all robots off in the worst sense",
          "[accuracy]") {
  Document document = on_square({{0, 3}, {10, 3}, {5, 10}});
  document.settings.weight = 100;
  document.shown.capacity = 40;
  const Accuracy all = accuracy_of(document);
  REQUIRE(all[Promise::capacity]);
  const double within = *all[Promise::capacity];
  // By hand: the lower two move up or down by `within`, or the upper one sideways.
  const auto greatest = [&](double a, double b, double c) {
    const Placement moved = placed(on_square({{0, 3 + a}, {10, 3 + b}, {5 + c, 10}}));
    return moved.loads->max;
  };
  double most = 0;
  for (const double a : {-within, within})
    for (const double b : {-within, within})
      for (const double c : {-within, within}) most = std::max(most, greatest(a, b, c));
  CHECK(most == Approx(40).epsilon(0.01));
}

TEST_CASE("ranges of loads include what changes with robots that are off", "[accuracy]") {
  Document document;
  document.vertices = {{0, 0}, {100, 0}, {110, 70}, {10, 80}};
  document.settings.method = Method::balanced;
  document.settings.robots = 5;
  const auto ranges = [&](LoadModel model) {
    const Placement placement = placed(document);
    return loads_by(model, placement, with_inaccuracy(*model_loads(placement), placement));
  };
  for (const LoadRange& range : ranges(LoadModel::plan)) CHECK(range.least == range.greatest);
  document.settings.accuracy = 1;
  const Placement placement = placed(document);
  const auto found = ranges(LoadModel::springs);
  CHECK_FALSE(may_let_go(LoadModel::springs, placement,
                         with_inaccuracy(*model_loads(placement), placement)));
  // All robots off by 1 along their edges, in each combination of senses.
  std::vector<double> greatest(5, 0), least(5, 100);
  const std::vector<LiftingPoint> robots = lifting_points(placement.teams);
  for (unsigned senses = 0; senses < 32; ++senses) {
    Points places;
    for (std::size_t i = 0; i < robots.size(); ++i) {
      const Vec2 edge = placement.polygon().edge_end(robots[i].edge) -
                        placement.polygon().edge_start(robots[i].edge);
      places.push_back(robots[i].position +
                       edge * ((senses >> i & 1u ? 1.0 : -1.0) / length(edge)));
    }
    const auto springs = spring_loads(places, placement.centre_of_mass,
                                      placement.polygon().diameter(), placement.weight());
    for (std::size_t i = 0; i < robots.size(); ++i) {
      greatest[i] = std::max(greatest[i], springs->loads[i]);
      least[i] = std::min(least[i], springs->loads[i]);
    }
  }
  for (std::size_t i = 0; i < robots.size(); ++i) {
    CHECK(found[i].greatest == Approx(greatest[i]).epsilon(0.01));
    CHECK(found[i].least == Approx(least[i]).epsilon(0.01));
  }
}

TEST_CASE("a robot at a corner may be off along either of its edges", "[accuracy]") {
  const Points corners{{0, 0}, {10, 0}, {10, 10}, {0, 10}};
  Document document = on_square(corners);
  document.shown.capacity = 27;
  const double within = *accuracy_of(document)[Promise::capacity];
  const auto greatest = [&](double off) {
    double load = 0;
    for (unsigned senses = 0; senses < 16; ++senses) {
      Points places;
      for (std::size_t i = 0; i < 4; ++i) {
        const Vec2 way = corners[(i + (senses >> i & 1u ? 1 : 3)) % 4] - corners[i];
        places.push_back(corners[i] + way * (off / length(way)));
      }
      const auto springs = spring_loads(places, {5, 5}, 14, 100);
      for (const double each : springs->loads) load = std::max(load, each);
    }
    return load;
  };
  // The limit to first order is safe here, by a third of what the loads may change.
  CHECK(greatest(within) <= 27.27);
  CHECK(greatest(within) >= 26.3);
}

TEST_CASE("robots with a size may be off until they have no room, or are too near",
          "[accuracy][stands]") {
  Document document = on_square({{5, 0}, {10, 5}, {5, 10}, {0, 5}});
  document.settings.robot.radius = 1;
  document.settings.no_go = {{0, 0.6, 0.7}};
  const Accuracy beside_no_go = accuracy_of(document);
  REQUIRE(beside_no_go[Promise::fits]);
  CHECK(*beside_no_go[Promise::fits] == Approx(1));
  document.settings.no_go.clear();
  document.settings.supports = {{4, 0}, {7, 0}, {5, 10}, {0, 5}};
  const Accuracy too_near = accuracy_of(document);
  CHECK(*too_near[Promise::fits] == Approx(0.5));
  CHECK(too_near.first->robots == std::vector<std::size_t>{0, 1});
  CHECK_FALSE(too_near.first->edge);
}

TEST_CASE("bodies that pass bends come nearer to each other than their contacts", "[accuracy]") {
  Document document;
  document.vertices = {
      {445.94, 2.931},    {554.06, 2.931},    {659.651, 26.173},  {757.777, 71.571},
      {843.85, 137.002},  {913.844, 219.406}, {964.488, 314.931}, {993.413, 419.109},
      {999.267, 527.069}, {981.775, 633.764}, {941.756, 734.204}, {881.081, 823.693},
      {802.587, 898.047}, {709.945, 953.788}, {607.485, 988.31},  {500, 1000},
      {392.515, 988.31},  {290.055, 953.788}, {197.413, 898.047}, {118.919, 823.693},
      {58.244, 734.204},  {18.225, 633.764},  {0.733, 527.069},   {6.587, 419.109},
      {35.512, 314.931},  {86.156, 219.406},  {156.15, 137.002},  {242.223, 71.571},
      {340.349, 26.173}};
  document.settings.method = Method::given;
  document.settings.supports = {{118.863, 823.61},   {10.8447, 403.774},   {295.252, 47.0373},
                                {708.714, 48.872},   {977.9935, 363.5732}, {888.234, 813.143},
                                {500.0993, 999.9892}};
  document.settings.robot.radius = 26.2089;
  // Robots 4 and 5 pass two bends each before they touch, at 188.24 (measured along the outline).
  const Accuracy all = accuracy_of(document);
  REQUIRE(all[Promise::fits]);
  CHECK(*all[Promise::fits] <= 188.24);
  CHECK(*all[Promise::fits] > 170);
}

TEST_CASE("searches keep the accuracy that is asked for", "[accuracy][slow]") {
  int reached = 0;
  for (const char* name : {"grand-piano", "letter-e", "star", "arrow", "bracket"})
    for (const double accuracy : {4.0, 25.0})
      for (const Method method : {Method::area, Method::balanced}) {
        INFO(name << ", " << accuracy);
        Document document = corpus::polygon(name);
        document.settings.method = method;
        document.settings.goal = Goal::hold;
        document.settings.positions = Positions::range;
        document.settings.robot = {20, 5, 0, 10, 5};
        document.settings.accuracy = accuracy;
        const auto placement = place(document);
        if (!placement || placement->teams.empty()) continue;
        const Accuracy all = report_of({*placement, document.shown}).accuracy;
        const double near = 10 * near_distance(placement->polygon().diameter());
        if (all[Promise::fits]) CHECK(*all[Promise::fits] >= accuracy - near);
        if (!placement->goal_reached) continue;
        ++reached;
        if (all[Promise::hold]) CHECK(*all[Promise::hold] >= accuracy - near);
      }
  CHECK(reached > 8);
}

TEST_CASE("a hold that is reached allows the accuracy that is asked for", "[accuracy]") {
  std::size_t reached = 0;
  for (const char* name :
       {"arrow", "l-shaped-desk", "oval-table", "stone-slab", "grand-piano", "cross"})
    for (const Method method : {Method::balanced, Method::area})
      for (const double part : {0.01, 0.03}) {
        Document document = corpus::polygon(name);
        document.settings.method = method;
        document.settings.robots = document.settings.teams.emplace(5);
        document.settings.goal = Goal::hold;
        document.settings.accuracy = part * bounding_box(document.vertices).diagonal();
        const Result<Placement> placement = place(document);
        if (!placement || !placement->goal_reached) continue;
        INFO(name << ", " << evenlift::name(method) << ", " << part);
        ++reached;
        CHECK(placement->closure.clearance.tolerance >= *document.settings.accuracy * (1 - 1e-9));
      }
  CHECK(reached >= 8);
}

TEST_CASE("the bodies of teams never collide, by any metric", "[placement][stands]") {
  std::size_t pairs = 0;
  for (const char* name :
       {"arrow", "l-shaped-desk", "oval-table", "stone-slab", "letter-e", "cross", "grand-piano"})
    for (const Method method : {Method::area, Method::circle, Method::distance}) {
      Document document = corpus::polygon(name);
      const double size = bounding_box(document.vertices).diagonal();
      document.settings.method = method;
      document.settings.teams = 8;
      document.settings.min_ratio = 0.6;
      document.settings.robot = {.radius = 0.04 * size, .reach = 0.01 * size, .gap = 0.01 * size};
      const Result<Placement> placement = place(document);
      if (!placement) continue;
      const std::vector<PlacedRobot> robots = placed_robots(*placement);
      INFO(name << ", " << evenlift::name(method));
      for (std::size_t i = 0; i < robots.size(); ++i)
        for (std::size_t j = 0; j < i; ++j, ++pairs)
          CHECK(length(robots[i].stand - robots[j].stand) >= (2 * 0.04 + 0.01) * size * (1 - 1e-9));
    }
  CHECK(pairs > 300);
}

TEST_CASE("an accuracy that leaves no room is refused", "[accuracy][errors]") {
  Document document = on_square({});
  document.settings.supports.clear();
  document.settings.method = Method::balanced;
  document.settings.accuracy = 6;
  const auto refused = place(document);
  REQUIRE_FALSE(refused.ok());
  CHECK(refused.error().message ==
        "no edge has room for robots that may be off by 6; with 4.5 there is room for 6");
}

TEST_CASE("where robots that may be off have no room, it is told with which accuracy they would",
          "[accuracy][words]") {
  Document document = corpus::polygon("guitar");
  document.settings.method = Method::balanced;
  document.settings.robots = 6;
  document.settings.robot.radius = 20;
  document.settings.accuracy = 140;
  const Placement placement = placed(document);
  REQUIRE(placement.teams.empty());
  REQUIRE(placement.accuracy_with_room);
  CHECK(plainly(verdict({placement, document.shown})) ==
        "No robots can be placed. No places were found for 6 balanced robots of this size: their "
        "centroid must be the centre of mass. That is for robots that may be off by 140; with 43 "
        "there is room for 6 robots.");
  document.settings.accuracy = placement.accuracy_with_room;
  CHECK(count_robots(placed(document).teams) == 6);
}

TEST_CASE("teams without room tell the number of their robots", "[accuracy][words]") {
  std::size_t told = 0;
  for (const char* name : {"arrow", "guitar", "cross", "letter-e", "stone-slab", "grand-piano"}) {
    Document document = corpus::polygon(name);
    document.settings.method = Method::area;
    document.settings.teams = 3;
    document.settings.robot.radius = 0.02 * bounding_box(document.vertices).diagonal();
    document.settings.accuracy = 0.2 * bounding_box(document.vertices).diagonal();
    const Result<Placement> placement = place(document);
    if (!placement || !placement->accuracy_with_room || !placement->teams.empty()) continue;
    ++told;
    INFO(name);
    CHECK(plainly(verdict({*placement, document.shown})).find("there is room for 6 robots.") !=
          std::string::npos);
  }
  CHECK(told > 0);
}

TEST_CASE("how far robots may be off is told in a sentence", "[accuracy][words]") {
  Document document = on_square(held_square);
  const auto words = [&] {
    const Placement placement = placed(document);
    return plainly(accuracy_in_words({placement, document.shown}));
  };
  CHECK(words() == "All of this holds if robots stand within 1.9 units of their places.");
  document.settings.accuracy = 1;
  CHECK(words() ==
        "With robots off by up to 1 all of this still holds; robot 1 then carries up to about "
        "33.4 kg.");
  document.settings.accuracy = 3;
  CHECK(words() == "With robots off by 1.9 units or more, the robots may no longer hold it.");
  const Placement placement = placed(document);
  CHECK(judge({placement, document.shown}).kind == VerdictKind::warning);
}

TEST_CASE("an object on the tipping line does not stand clearly", "[accuracy][verdict]") {
  // C is at (5, 5); with a clearance of 2 % of R it must be 0.14 inside.
  const auto upright = [](double y) {
    const Document document = on_square({{0, y}, {10, y}, {10, 10}, {0, 10}});
    const Placement placement = placed(document);
    return report_of({placement, document.shown}).upright;
  };
  CHECK(upright(4.8));
  CHECK_FALSE(upright(4.9));
  CHECK_FALSE(upright(5));
  const Document document = on_square({{0, 4.9}, {10, 4.9}, {10, 10}, {0, 10}});
  const Placement placement = placed(document);
  const Judgement judgement = judge({placement, document.shown});
  CHECK(judgement.kind == VerdictKind::warning);
  CHECK(plainly(judgement.reasons.front()) ==
        "C is only 0.099 units inside the line from robot 1 to robot 2.");
  const auto conditions = read_conditions("upright, within>=0.05, within>=1");
  REQUIRE(conditions.ok());
  const auto checked = check_conditions({placement, document.shown}, *conditions);
  CHECK_FALSE(checked[0].kept);
  CHECK(checked[1].kept);
  CHECK_FALSE(checked[2].kept);
}
