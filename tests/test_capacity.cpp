#include "evenlift/capacity.h"

#include "corpus.h"
#include "evenlift/placement.h"

using namespace evenlift;

namespace {

// The plan by its definition: place one number of teams after the other.
CapacityPlan plan_by_trying(Document document, double capacity, std::uint32_t most) {
  CapacityPlan plan;
  for (std::uint32_t k = 1; k <= most; ++k) {
    document.settings.teams = k;
    const Result<Placement> placement = place(document);
    REQUIRE(placement.ok());
    if (placement->teams.size() < k) return plan;
    plan.tried = k;
    if (placement->loads->max <= capacity) return {true, k, placement->loads->max, k};
  }
  return plan;
}

}  // namespace

TEST_CASE("robots needed for a capacity are the fewest that stay within it, by every method",
          "[capacity]") {
  for (const char* name : {"puzzle-piece", "thesis-sample", "kidney-table", "horseshoe"}) {
    for (const Metric metric : all_metrics) {
      for (const double capacity : {60.0, 26.0, 12.5, 7.0, 5.0}) {
        Document document = corpus::polygon(name);
        document.settings.metric = metric;
        const Result<CapacityPlan> plan = plan_capacity(document, capacity);
        REQUIRE(plan.ok());
        const CapacityPlan expected = plan_by_trying(document, capacity, 24);
        INFO(name << ", " << evenlift::name(metric) << ", " << capacity);
        CHECK(plan->possible == expected.possible);
        if (!expected.possible) continue;
        CHECK(plan->teams == expected.teams);
        CHECK(plan->greatest_load == expected.greatest_load);
      }
    }
  }
}

TEST_CASE("100 kg on even teams need the robots that arithmetic says", "[capacity]") {
  Document square;
  square.vertices = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  square.settings.metric = Metric::distributed;
  const Result<CapacityPlan> plan = plan_capacity(square, 5);
  REQUIRE(plan.ok());
  CHECK(plan->possible);
  CHECK(plan->teams == 10);
}

TEST_CASE("a capacity that no number of teams keeps is said to be impossible", "[capacity]") {
  const Result<CapacityPlan> few = plan_capacity(corpus::polygon("thesis-sample"), 5);
  REQUIRE(few.ok());
  CHECK_FALSE(few->possible);
  CHECK(few->tried == 3);  // its candidates
  Document square;
  square.vertices = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  square.settings.metric = Metric::distributed;
  const Result<CapacityPlan> many = plan_capacity(square, 1e-6);
  REQUIRE(many.ok());
  CHECK_FALSE(many->possible);
  CHECK(many->tried == most_teams_for_capacity);
}

TEST_CASE("planning refuses what placing refuses", "[capacity]") {
  Document bow;
  bow.vertices = {{0, 0}, {2, 2}, {2, 0}, {0, 2}};
  CHECK_FALSE(plan_capacity(bow, 5).ok());
}
