// Searches that end by their limits of work.
#include "evenlift/balanced.h"
#include "evenlift/capacity.h"
#include "evenlift/generate.h"
#include "evenlift/output/words.h"
#include "evenlift/placement.h"
#include "evenlift/swaps.h"
#include "kit/catch.h"
#include "kit/json.h"

#include "evenlift/output/json.h"

using namespace evenlift;

namespace {

Document generated(Family family, std::uint32_t vertices) {
  Document document;
  document.vertices = *generate(family, vertices, 3);
  return document;
}

}  // namespace

TEST_CASE("a search for many robots on a winding outline ends by its limit, and says so",
          "[balanced][slow]") {
  Document document = generated(Family::star, 300);
  document.settings.method = Method::balanced;
  document.settings.robots = 24;
  const Placement placement = place(document).value();
  CHECK(placement.search_ended);
  CHECK(placement.cut_short);
  CHECK(cut_short_in_words(placement) ==
        "The search was cut short by its limit of work: there may be better places.");
  const testing::Json json = testing::Json::parse(placement_json(placement, false, {}));
  CHECK(json["search_ended"] == false);
  // What it found is as good as its start, and in balance.
  const BalancedProblem problem(placement.object, placement.centre_of_mass, document.settings);
  auto search = start_balanced(problem).value();
  const auto robots = lifting_points(placement.teams);
  CHECK_FALSE(is_better(problem, search.robots, robots));
  Vec2 sum;
  for (const LiftingPoint& robot : robots) sum += robot.position - placement.centre_of_mass;
  CHECK(length(sum) <= 1e-9 * 24 * placement.polygon().diameter());
  CHECK(search.work.steps == 0);
  while (!search.finished) {
    REQUIRE(search.work.steps < most_steps);
    search = try_next_triple(problem, std::move(search)).search;
  }
  CHECK(search.cut_short);
  CHECK(search.robots.size() == robots.size());
}

TEST_CASE("robots with a size find places on tens of thousands of short edges",
          "[balanced][stands][slow]") {
  Document document = generated(Family::convex, 50000);
  document.settings.method = Method::balanced;
  document.settings.robots = 5;
  document.settings.robot.radius = 3;
  const Placement placement = place(document).value();
  CHECK(lifting_points(placement.teams).size() == 5);
}

TEST_CASE("a usual search does not meet its limit", "[balanced]") {
  Document document = generated(Family::random, 50);
  document.settings.method = Method::balanced;
  const Placement placement = place(document).value();
  CHECK_FALSE(placement.cut_short);
  CHECK(cut_short_in_words(placement).empty());
}

TEST_CASE("swaps among very many candidates end by their limit, and keep what they have",
          "[swaps][slow]") {
  Document document = generated(Family::comb, 700);
  document.settings.teams = 16;
  document.settings.positions = Positions::range;
  const Placement covering = place(document).value();
  document.settings.goal = Goal::hold;
  const Placement placement = place(document).value();
  CHECK(placement.cut_short);
  CHECK(placement.teams.size() == 16);
  const HoldRequirements hold = hold_requirements(placement);
  const auto keys = [&](const Placement& of) {
    return hold_keys(of.object, of.centre_of_mass, of.candidates, of.team_candidates, hold);
  };
  CHECK_FALSE(better_by(keys(covering), keys(placement)));
  document.settings.teams = 2;
  CHECK_FALSE(place(document).value().cut_short);
}

TEST_CASE("a plan whose searches meet the limit of work tries no further numbers, and says so",
          "[swaps][slow]") {
  Document document = generated(Family::comb, 1000);
  document.settings.goal = Goal::hold;
  document.settings.teams = 1;
  const Placement placement = place(document).value();
  const double capacity = placement.weight() / 16;  // eight teams suffice only if all are even
  const CapacityPlan plan = plan_capacity(placement, capacity);
  CHECK_FALSE(plan.possible);
  CHECK(plan.cut_short);
  CHECK(plan.tried >= 8);
  CHECK(plan.tried < most_swapped_teams);
}
