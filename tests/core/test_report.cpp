// That each quantity is computed once for all outputs together. The linker sends the calls of the
// functions below through counters (--wrap in tests/CMakeLists.txt).
#include "evenlift/report.h"

#include <map>
#include <string>
#include <utility>

#include "evenlift/output/quantities.h"
#include "evenlift/output/requirements.h"
#include "evenlift/request.h"
#include "kit/catch.h"
#include "kit/corpus.h"
#include "kit/json.h"
#include "kit/placed.h"

using namespace evenlift;
using evenlift::testing::Json;

#ifdef EVENLIFT_COUNTS_CALLS
namespace {
std::map<std::string, int>& calls() {
  static std::map<std::string, int> counted;
  return counted;
}
}  // namespace

// NOLINTBEGIN(bugprone-reserved-identifier)
#define COUNTED(result, name, symbol, parameters, arguments) \
  result real_##name parameters asm("__real_" symbol);       \
  result counted_##name parameters asm("__wrap_" symbol);    \
  result counted_##name parameters {                         \
    ++calls()[#name];                                        \
    return real_##name arguments;                            \
  }

using Failures = std::vector<std::optional<RestOfRobots>>;
using Loads = std::optional<std::vector<double>>;
COUNTED(Robustness, robustness, "_ZN8evenlift10robustnessERKNS_9PlacementE", (const Placement& of),
        (of))
COUNTED(Equilibrium, equilibrium, "_ZN8evenlift11equilibriumERKNS_9PlacementE",
        (const Placement& of), (of))
COUNTED(DisturbanceEffect, effect_on, "_ZN8evenlift9effect_onERKNS_14ShownPlacementE",
        (const ShownPlacement& of), (of))
COUNTED(std::optional<ModelLoads>, model_loads,
        "_ZN8evenlift11model_loadsERKNS_9PlacementERKNS_11DisturbanceE",
        (const Placement& of, const Disturbance& within), (of, within))
COUNTED(ModelLoads, with_inaccuracy,
        "_ZN8evenlift15with_inaccuracyENS_10ModelLoadsERKNS_9PlacementE",
        (ModelLoads models, const Placement& of), (std::move(models), of))
COUNTED(Loads, worst_loads, "_ZN8evenlift11worst_loadsERKNS_9PlacementERKNS_17DisturbanceEffectE",
        (const Placement& of, const DisturbanceEffect& effect), (of, effect))
COUNTED(Failures, single_failures,
        "_ZN8evenlift15single_failuresERKNS_9PlacementERKNS_11DisturbanceE",
        (const Placement& of, const Disturbance& within), (of, within))
COUNTED(std::optional<ExtraLoad>, extra_load, "_ZN8evenlift10extra_loadERKNS_14ShownPlacementE",
        (const ShownPlacement& of), (of))
COUNTED(CapacityPlan, plan_capacity, "_ZN8evenlift13plan_capacityERKNS_9PlacementEd",
        (const Placement& of, double capacity), (of, capacity))
COUNTED(FailurePlan, plan_for_failures, "_ZN8evenlift17plan_for_failuresERKNS_14ShownPlacementEd",
        (const ShownPlacement& of, double capacity), (of, capacity))
COUNTED(std::vector<Misfit>, misfits, "_ZN8evenlift7misfitsERKNS_9PlacementE",
        (const Placement& of), (of))
COUNTED(std::vector<PlacedRobot>, placed_robots, "_ZN8evenlift13placed_robotsERKNS_9PlacementE",
        (const Placement& of), (of))
// NOLINTEND(bugprone-reserved-identifier)

TEST_CASE("each quantity is computed once for JSON with failures, plans and all conditions",
          "[report]") {
  std::string conditions;
  for (const Quantity& quantity : quantities())
    if (!quantity.condition.empty())
      conditions += (conditions.empty() ? "" : ", ") + std::string(quantity.condition) +
                    (quantity.unit == Unit::yes_or_no ? "" : ">=0");
  const std::string request =
      R"({"polygon": [[0, 0], [200, 0], [200, 100], [0, 100]], "settings": {"teams": 3, "capacity": 40,)"
      R"( "com_height": 5, "slope": 0.05, "uneven": 0.1, "give": 1, "accuracy": 0.1, "extra": 5},)"
      R"( "failures": true, "require": ")" +
      conditions + "\"}";
  calls().clear();
  const Json result = Json::parse(answer(request));
  REQUIRE(result.contains("capacity"));
  CHECK(result["failures"].size() == result["robots"].size());
  CHECK(result["requirements"].size() > 10);
  REQUIRE(calls().size() == 12);
  for (const auto& [name, times] : calls()) {
    INFO(name);
    CHECK(times == 1);
  }
}
#endif

TEST_CASE("a report that is completed is the same as one made at once", "[report]") {
  Document document = corpus::polygon("grand-piano");
  document.shown.capacity = 17;
  document.shown.carrying = {.com_height = 30, .slope = 0.1};
  const Placement placement = testing::placed(document);
  const ShownPlacement of(placement, document.shown);
  const Asked all{.model = LoadModel::springs, .models = true, .failures = true, .plans = true};
  Report completed = report_of(of);
  for (const Asked& asked : {Asked{.plans = true}, Asked{.failures = true}, all})
    complete(completed, of, asked);
  const Report once = report_of(of, all);
  CHECK(completed.plan == once.plan);
  CHECK(completed.if_one_fails == once.if_one_fails);
  CHECK(completed.model == LoadModel::springs);
  CHECK(completed.greatest == once.greatest);
  CHECK(completed.overloaded == once.overloaded);
  CHECK(completed.overloaded_after == once.overloaded_after);
  REQUIRE(completed.failures.size() == 6);
  REQUIRE(completed.com_radius);
  CHECK(completed.com_radius->within == once.com_radius->within);
  // Loads as planned are told again, from what is known.
  complete(completed, of, {});
  CHECK(completed.greatest == report_of(of).greatest);
}

TEST_CASE("the use is the greatest load under the given conditions, as a part of its capacity",
          "[report][words]") {
  Document document;
  document.vertices = {{0, 0}, {10, 0}, {10, 10}, {0, 10}};
  document.settings.method = Method::given;
  document.settings.supports = document.vertices;
  const Placement placement = testing::placed(document);
  Shown shown;
  const auto use = [&]() -> std::optional<double> {
    return check_conditions({placement, shown}, *read_conditions("use<=0.9"))[0].value;
  };
  CHECK_FALSE(use());
  shown.capacity = 30;
  CHECK(use().value() == Approx(25.0 / 30));
  shown.support_capacities = {20, std::nullopt, std::nullopt, std::nullopt};
  CHECK(use().value() == Approx(25.0 / 20));
  shown.carrying = {.com_height = 1, .slope = 0.2};
  CHECK(use().value() > 25.0 / 20);
  shown.carrying.slope = 6;  // it tips
  CHECK_FALSE(use());
}

TEST_CASE("without robots a report has plans, and nothing about robots", "[report]") {
  Document document = corpus::polygon("grand-piano");
  document.settings.min_ratio = 1;
  document.settings.robot.radius = 1e6;
  document.shown.capacity = 17;
  const Placement none = testing::placed(document);
  REQUIRE(none.teams.empty());
  const Report report =
      report_of({none, document.shown}, {.models = true, .failures = true, .plans = true});
  CHECK(report.plan);
  CHECK(report.has_capacities);
  CHECK_FALSE(report.models);
  CHECK_FALSE(report.tips);
  CHECK(report.failures.empty());
  CHECK(report.loads.empty());
}
