// Loads by the law of the lever.
#include "evenlift/loads.h"

#include "kit/catch.h"
#include "kit/property.h"

using namespace evenlift;

namespace {

Chord chord(double arm1, double arm2) {
  Chord c;
  c.r1.position = {-arm1, 0};
  c.r2.position = {arm2, 0};
  c.arm1 = arm1;
  c.arm2 = arm2;
  c.ratio = std::min(arm1, arm2) / std::max(arm1, arm2);
  return c;
}

}  // namespace

TEST_CASE("the robot nearer to the centre of mass carries more, by the lever", "[loads]") {
  const std::vector<Team> teams = distribute_weight({chord(1, 3)}, 100);
  REQUIRE(teams.size() == 1);
  CHECK(teams[0].robots[0].load == 75);
  CHECK(teams[0].robots[1].load == 25);
  const auto summary = summarize_loads(teams);
  REQUIRE(summary);
  CHECK(summary->min == 25);
  CHECK(summary->mean == 50);
  CHECK(summary->max == 75);
  CHECK(summary->spread == 50);
  CHECK(summary->max_share == 0.75);
}

TEST_CASE("teams share the weight equally, whatever their chords", "[loads]") {
  const std::vector<Team> teams =
      distribute_weight({chord(1, 3), chord(2, 2), chord(5, 0.5), chord(4, 1)}, 440);
  REQUIRE(teams.size() == 4);
  for (const Team& team : teams)
    CHECK(team.robots[0].load + team.robots[1].load == Approx(110).epsilon(1e-15));
  CHECK(teams[1].robots[0].load == 55);
  CHECK(teams[2].robots[0].load == Approx(10).epsilon(1e-15));
  CHECK(teams[2].robots[1].load == Approx(100).epsilon(1e-15));
  const auto summary = summarize_loads(teams);
  REQUIRE(summary);
  CHECK(summary->min == Approx(10).epsilon(1e-15));
  CHECK(summary->max == Approx(100).epsilon(1e-15));
  CHECK(summary->mean == Approx(55).epsilon(1e-15));
  CHECK(summary->max_share == Approx(10.0 / 11).epsilon(1e-15));
}

TEST_CASE("the mean load is the weight divided by the robots, also of a team of five", "[loads]") {
  Team team;
  for (const double load : {10.0, 20.0, 30.0, 25.0, 15.0}) team.robots.emplace_back().load = load;
  const auto summary = summarize_loads({team});
  REQUIRE(summary);
  CHECK(summary->mean == 20);
  CHECK(summary->min == 10);
  CHECK(summary->max == 30);
}

TEST_CASE("an even pair shares evenly and its greatest share is a half", "[loads]") {
  const auto summary = summarize_loads(distribute_weight({chord(7, 7)}, 30));
  REQUIRE(summary);
  CHECK(summary->min == 15);
  CHECK(summary->spread == 0);
  CHECK(summary->max_share == 0.5);
}

TEST_CASE("without teams no robot carries anything", "[loads]") {
  CHECK(distribute_weight({}, 100).empty());
  CHECK_FALSE(summarize_loads({}));
}

TEST_CASE("loads balance about the centre of mass and add up to the weight", "[loads]") {
  property::holds([] {
    const auto lengths = *rc::gen::nonEmpty(rc::gen::container<std::vector<std::pair<int, int>>>(
        rc::gen::pair(rc::gen::inRange(1, 1000000), rc::gen::inRange(1, 1000000))));
    const double weight = *rc::gen::inRange(1, 100000) / 16.0;
    std::vector<Chord> chords;
    for (const auto& [arm1, arm2] : lengths) chords.push_back(chord(arm1 / 64.0, arm2 / 64.0));
    const std::vector<Team> teams = distribute_weight(chords, weight);
    double sum = 0;
    for (const Team& team : teams) {
      const Robot &r1 = team.robots[0], &r2 = team.robots[1];
      const double torque = r1.load * r1.arm - r2.load * r2.arm;
      RC_ASSERT(std::fabs(torque) <= 1e-14 * r1.load * r1.arm);
      // The ratio of a team's loads is its load ratio.
      const double ratio = std::min(r1.load, r2.load) / std::max(r1.load, r2.load);
      RC_ASSERT(std::fabs(ratio - team.ratio) <= 1e-14);
      sum += r1.load + r2.load;
    }
    RC_ASSERT(std::fabs(sum - weight) <= 1e-12 * weight);
  });
}
