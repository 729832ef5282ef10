#include "evenlift/capacity.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string_view>
#include <vector>

#include "evenlift/failures.h"
#include "evenlift/generate.h"
#include "evenlift/output/words.h"
#include "evenlift/settings.h"
#include "evenlift/swaps.h"
#include "evenlift/tolerance.h"
#include "kit/catch.h"
#include "kit/corpus.h"
#include "kit/placed.h"

using namespace evenlift;
using evenlift::testing::placed;

namespace {

Shown with_capacity(double capacity) {
  Shown shown;
  shown.capacity = capacity;
  return shown;
}

Document distributed_square() {
  Document square;
  square.vertices = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  square.settings.method = Method::distributed;
  return square;
}

// By definition.
CapacityPlan plan_by_trying(Document document, double capacity, std::uint32_t most) {
  CapacityPlan plan;
  for (std::uint32_t k = 1; k <= most; ++k) {
    document.settings.teams = k;
    const Result<Placement> placement = place(document);
    REQUIRE(placement.ok());
    if (placement->teams.size() < k) return plan;
    plan.tried = k;
    if (!exceeds(placement->loads->max, capacity)) return {true, k, placement->loads->max, k};
  }
  return plan;
}

// The greatest load that a robot carries, intact or after any one failure, by the effects that the
// page shows; infinite if a failure drops the object.
double greatest_with_failures(const ShownPlacement& of) {
  double greatest = 0;
  const Report report = report_of(of);
  const bool tips = report.tips;
  for (const LoadRange& load : report.planned)
    greatest = std::max(greatest, tips ? of.placement.loads->max : load.greatest);
  for (const auto& rest : single_failures(of.placement, disturbance_of(of.shown)))
    greatest = std::max(greatest,
                        rest ? rest->greatest_end.value_or(rest->greatest_by_springs) : HUGE_VAL);
  return greatest;
}

bool survives_failures(const ShownPlacement& of) {
  const auto failures = single_failures(of.placement, disturbance_of(of.shown));
  return std::all_of(failures.begin(), failures.end(),
                     [](const auto& rest) { return rest && rest->clear && rest->stays; });
}

// By definition, for teams of two.
FailurePlan failure_plan_by_trying(Document document, double capacity, std::uint32_t most) {
  FailurePlan plan;
  for (std::uint32_t teams = 1; teams <= most; ++teams) {
    document.settings.teams = teams;
    const Placement placement = placed(document);
    if (placement.teams.size() < teams) return plan;
    plan.tried = 2 * teams;
    const double greatest = greatest_with_failures({placement, document.shown});
    if (exceeds(greatest, capacity)) continue;
    if (survives_failures({placement, document.shown}))
      return {true, false, 2 * teams, greatest, 2 * teams};
    if (!plan.can_tip) plan = {false, true, 2 * teams, greatest, 2 * teams};
  }
  return plan;
}

}  // namespace

TEST_CASE("a robot that carries just its capacity is not overloaded, however the load was rounded",
          "[capacity]") {
  CHECK_FALSE(exceeds(40.00000000000001, 40));
  CHECK(exceeds(40.000001, 40));
  int above = 0;  // loads above capacity as numbers
  for (const char* name : {"puzzle-piece", "thesis-sample", "hexagon"}) {
    for (int weight = 1; weight <= 60; ++weight) {
      for (const Method method : {Method::area, Method::balanced}) {
        Document document = corpus::polygon(name);
        document.settings.method = method;
        document.settings.weight = weight / 10.0;
        const Placement placement = placed(document);
        const double even = document.settings.weight / double(count_robots(placement.teams));
        const Shown limit = with_capacity(even);
        const ShownPlacement shown{placement, limit};
        for (const double load : planned_loads(placement.teams)) above += load > even ? 1 : 0;
        if (placement.loads->max <= even * (1 + 1e-12)) CHECK(overloaded_robots(shown).empty());
      }
    }
  }
  CHECK(above > 0);
}

TEST_CASE("robots needed for a capacity are the fewest that stay within it, by every method",
          "[capacity][slow]") {
  int possible = 0;
  for (const char* name : {"puzzle-piece", "thesis-sample", "kidney-table", "horseshoe", "comb"}) {
    for (const Method method : pair_methods) {
      for (const double capacity : {60.0, 26.0, 12.5, 7.0, 5.0}) {
        Document document = corpus::polygon(name);
        document.settings.method = method;
        const CapacityPlan plan = plan_capacity(placed(document), capacity);
        const CapacityPlan expected = plan_by_trying(document, capacity, 24);
        INFO(name << ", " << evenlift::name(method) << ", " << capacity);
        if (!expected.possible && expected.tried == 24) continue;  // more teams may be enough
        CHECK(plan == expected);
        possible += expected.possible ? 1 : 0;
      }
    }
  }
  CHECK(possible > 60);
}

TEST_CASE("robots needed if any one may fail are the fewest that stay within the capacity",
          "[capacity][slow]") {
  int possible = 0, steep = 0;
  for (const char* name : {"puzzle-piece", "thesis-sample", "kidney-table", "horseshoe"}) {
    for (const Method method : pair_methods) {
      for (const double capacity : {60.0, 40.0, 26.0, 12.5}) {
        for (const double height : {0.0, 0.5}) {  // in parts of L
          Document document = corpus::polygon(name);
          document.settings.method = method;
          const double size = placed(document).polygon().diameter();
          if (height > 0)
            document.shown.carrying = {.com_height = height * size,
                                       .slope = 0.1,
                                       .give = 0.01 * size,
                                       .uneven = 0.001 * size};
          const Placement placement = placed(document);
          const FailurePlan plan = plan_for_failures({placement, document.shown}, capacity);
          const FailurePlan expected = failure_plan_by_trying(document, capacity, 20);
          INFO(name << ", " << evenlift::name(method) << ", " << capacity << ", " << height);
          if (!expected.possible && expected.tried == 40) continue;  // more teams may be enough
          CHECK(plan.possible == expected.possible);
          CHECK(plan.can_tip == expected.can_tip);
          CHECK(plan.robots == expected.robots);
          CHECK(std::abs(plan.greatest_load - expected.greatest_load) <= 1e-12 * capacity);
          (height > 0 ? steep : possible) += expected.possible ? 1 : 0;
        }
      }
    }
  }
  CHECK(possible > 40);
  CHECK(steep > 20);
}

TEST_CASE("rounding does not add robots to those needed if any one may fail", "[capacity]") {
  for (const char* name : {"puzzle-piece", "thesis-sample", "hexagon"}) {
    for (const Method method : {Method::area, Method::distributed, Method::balanced}) {
      Document document = corpus::polygon(name);
      document.settings.method = method;
      const Placement placement = placed(document);
      const FailurePlan plan = plan_for_failures(placement, 30);
      INFO(name << ", " << evenlift::name(method));
      REQUIRE(plan.possible);
      CHECK(plan_for_failures(placement, plan.greatest_load * (1 - 1e-12)) == plan);
    }
  }
}

TEST_CASE("a plan is the least number of teams also where hundreds are needed",
          "[capacity][slow]") {
  for (const Method method : pair_methods) {
    Document document;
    document.vertices = *generate(Family::comb, 300, 1);
    document.settings.method = method;
    const CapacityPlan plan = plan_capacity(placed(document), 0.4);
    INFO(name(method));
    REQUIRE(plan.possible);
    CHECK(plan.teams >= 125);
    document.settings.teams = plan.teams;
    CHECK(placed(document).loads->max == plan.greatest_load);
    CHECK(plan.greatest_load <= 0.4);
    for (std::uint32_t fewer = 1; fewer < plan.teams; fewer += fewer + 8 < plan.teams ? 7 : 1) {
      document.settings.teams = fewer;
      CHECK(placed(document).loads->max > 0.4);
    }
  }
}

TEST_CASE("a plan does not depend on how many teams are placed", "[capacity]") {
  for (const Method method : pair_methods) {
    Document document = corpus::polygon("kidney-table");
    document.settings.method = method;
    document.settings.teams = 1;
    const Placement one = placed(document);
    document.settings.teams = 9;
    const Placement nine = placed(document);
    CHECK(plan_capacity(one, 7) == plan_capacity(nine, 7));
    CHECK(same_plan(one, nine));
    document.settings.weight = 99;
    CHECK_FALSE(same_plan(one, placed(document)));
    document.settings = one.settings;
    document.settings.apart = 30;
    CHECK_FALSE(same_plan(one, placed(document)));
  }
}

TEST_CASE("100 kg on even teams need the robots that arithmetic says", "[capacity]") {
  const CapacityPlan plan = plan_capacity(placed(distributed_square()), 5);
  CHECK(plan.possible);
  CHECK(plan.teams == 10);
}

TEST_CASE("a capacity that no number of teams keeps is said to be impossible", "[capacity]") {
  const CapacityPlan few = plan_capacity(placed(corpus::polygon("thesis-sample")), 5);
  CHECK_FALSE(few.possible);
  CHECK(few.tried == 3);  // the number of its candidates
  Document at_random = distributed_square();
  at_random.settings.method = Method::random;
  for (const Document& document : {distributed_square(), at_random}) {
    const CapacityPlan many = plan_capacity(placed(document), 1e-6);
    CHECK_FALSE(many.possible);
    CHECK(many.tried == most_teams_for_capacity);
  }
}

TEST_CASE("a plan of teams that are swapped says how many were tried", "[capacity][words]") {
  Document comb;
  comb.vertices = *generate(Family::comb, 40, 1);
  comb.settings.goal = Goal::hold;
  comb.settings.min_ratio = 0.5;
  comb.settings.teams = 2;
  const Placement points = placed(comb);
  REQUIRE(points.candidates.size() > most_swapped_teams);
  const CapacityPlan many = plan_capacity(points, 0.5);
  CHECK_FALSE(many.possible);
  CHECK(many.tried == most_teams_tried(points.settings));
  const Shown half = with_capacity(0.5);
  Report report = report_of({points, half});
  report.plan = many;
  CHECK(capacity_in_words({{points, half}, report}).ends_with("Even 64 robots are too few."));

  comb.settings.robot.radius = 20;
  const CapacityPlan few = plan_capacity(placed(comb), 0.5);
  comb.settings.teams = most_swapped_teams;
  comb.settings.goal.reset();
  CHECK_FALSE(few.possible);
  CHECK(few.tried == placed(comb).teams.size());
  CHECK(few.tried < most_swapped_teams);
}

TEST_CASE("robots that carry more than the capacity are told by number", "[capacity]") {
  Document document = corpus::polygon("grand-piano");
  const Placement placement = placed(document);
  const double most = placement.loads->max;
  CHECK(overloaded_robots({placement, with_capacity(most)}).empty());
  const std::vector<std::size_t> over =
      overloaded_robots({placement, with_capacity(most * (1 - 1e-6))});
  REQUIRE(over.size() == 1);
  CHECK(placement.teams[over[0] / 2].robots[over[0] % 2].load == most);
  CHECK(overloaded_robots({placement, with_capacity(1e-9)}).size() == 2 * placement.teams.size());
}

TEST_CASE("a plan of teams that are swapped begins with the fewest that could be enough",
          "[capacity]") {
  Document document;
  document.vertices = {{0, 0}, {4, 0}, {4, 2}, {2, 2}, {2, 4}, {0, 4}};
  document.settings.goal = Goal::hold;
  const Placement placement = placed(document);
  for (const std::uint32_t teams : {1u, 2u, 3u}) {
    // Its candidates are even.
    const CapacityPlan plan = plan_capacity(placement, 51.0 / teams);
    INFO(teams);
    REQUIRE(plan.possible);
    CHECK(plan.teams == teams);
    CHECK(plan.greatest_load == Approx(50.0 / teams));
  }
}

TEST_CASE("balanced robots that are to survive failures are at least as many as that takes",
          "[capacity][balanced]") {
  Document document = distributed_square();
  document.settings.method = Method::balanced;
  document.settings.robots = 7;
  for (const std::uint32_t survive : {0u, 1u, 2u}) {
    document.settings.survive = survive;
    const Placement placement = placed(document);
    INFO(survive);
    CHECK(plan_capacity(placement, 1000).team_size == (survive == 0 ? 2 : 2 * survive + 3));
    CHECK(plan_capacity(placement, 12.5).team_size == 8);
  }
}

TEST_CASE("a plan is made anew when anything changes on which it depends", "[capacity]") {
  Document document = distributed_square();
  document.settings.method = Method::area;
  const Placement before = placed(document);
  CHECK(same_plan(before, placed(document)));
  const std::vector<void (*)(Document&)> edits{
      [](Document& d) {
        d.vertices[2] = {1, 2};
      },
      [](Document& d) { d.centre_of_mass = Vec2(0.1, 0); },
      [](Document& d) { d.settings.method = Method::circle; },
      [](Document& d) { d.settings.min_ratio = 0.5; },
      [](Document& d) { d.settings.weight = 99; },
      [](Document& d) { d.settings.seed = 2; },
      [](Document& d) { d.settings.survive = 1; },
      [](Document& d) { d.settings.positions = Positions::range; },
      [](Document& d) { d.settings.goal = Goal::hold; },
      [](Document& d) { d.settings.min_margin = 0.1; },
      [](Document& d) { d.settings.clear = 0.1; },
      [](Document& d) { d.settings.robot.radius = 0.1; },
      [](Document& d) {
        d.settings.no_go = {{0, 0, 0.5}};
      }};
  for (std::size_t i = 0; i < edits.size(); ++i) {
    Document edited = document;
    edits[i](edited);
    INFO("edit " << i);
    CHECK_FALSE(same_plan(before, placed(edited)));
  }
}

TEST_CASE("no setting changes a plan unnoticed", "[capacity][slow]") {
  // For each setting that affects where robots stand or what they carry.
  const std::map<std::string_view, std::vector<const char*>> values = {
      {"teams", {"1", "9"}},
      {"metric", {"circle", "distance", "distributed", "random", "balanced"}},
      {"min_ratio", {"0.3", "0.97"}},
      {"com", {"300,300", "420,560"}},
      {"weight", {"60", "170"}},
      {"seed", {"2", "77"}},
      {"robot", {"r=20,reach=5,depth=0,width=10,gap=2", "r=90"}},
      {"no_go", {"1,3,5", "2:0.2-0.9"}},
      {"goal", {"hold", "cover"}},
      {"robots", {"4", "11"}},
      {"positions", {"range"}},
      {"min_margin", {"0", "0.3"}},
      {"apart", {"100", "400"}},
      {"survive", {"1", "3"}},
      {"clear", {"0", "60"}},
      {"accuracy", {"5", "60"}},
      {"robot_radius", {"25", "120"}},
      {"robot_reach", {"10"}},
      {"robot_depth", {"30"}},
      {"robot_width", {"40"}},
      {"robot_gap", {"50"}},
      {"supports", {"0,0 500,0 400,900"}},
      {"snap", {"5"}},
      {"support_capacities", {"none"}},
      {"support_names", {"north"}},
      {"cargo", {"300,300:40", "500,500:300"}},
      {"readings", {"10 20 30"}},
      {"reading_error", {"1%", "2"}},
      {"level_error", {"0.1"}},
      {"readings_tilted", {"10 20 30"}},
      {"tilted", {"0.1"}},
      {"heading", {"1,0"}},
  };
  std::vector<Document> documents(5, corpus::polygon("grand-piano"));
  constexpr Method methods[] = {Method::area, Method::random, Method::distributed,
                                Method::balanced};
  for (std::size_t i = 0; i < std::size(methods); ++i) documents[i].settings.method = methods[i];
  documents.back().settings.positions = Positions::range;  // teams that are swapped
  documents.back().settings.goal = Goal::hold;
  int changed_plans = 0;
  for (const SettingRow& row : all_settings()) {
    if (row.changes != Changes::stands && row.changes != Changes::loads) continue;
    INFO("the setting " << row.name);
    REQUIRE(values.contains(row.name));
    for (const Document& document : documents) {
      const Placement before = placed(document);
      for (const char* value : values.at(row.name)) {
        Document changed = document;
        if (read_setting(row.setting, value, changed)) continue;
        const Result<Placement> after = place(changed);
        if (!after || !same_plan(before, *after)) {
          changed_plans += after.ok();
          continue;
        }
        INFO(value << " with the method " << name(document.settings.method));
        for (const double capacity : {4.0, 11.0, 24.0, 60.0})
          CHECK(plan_capacity(before, capacity) == plan_capacity(*after, capacity));
      }
    }
  }
  CHECK(changed_plans > 100);
}
