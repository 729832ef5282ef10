// In JSON and in words.
#include <algorithm>
#include <numeric>

#include "evenlift/output/carrying_words.h"
#include "evenlift/output/json.h"
#include "evenlift/output/quantities.h"
#include "evenlift/output/robustness_words.h"
#include "kit/catch.h"
#include "kit/corpus.h"
#include "kit/json.h"
#include "kit/placed.h"
#include "kit/polygons.h"
#include "kit/solid.h"
#include "kit/texts.h"

using namespace evenlift;
using evenlift::testing::Json;
using evenlift::testing::plainly;
using Names = std::vector<std::string>;

namespace {

Placement placed(const std::string& name, std::uint32_t teams) {
  return testing::placed(corpus::polygon(name), Method::area, teams);
}

Json json_of(const Placement& placement, const Shown& shown = {}, bool failures = false) {
  return Json::parse(
      placement_json({placement, shown}, false, {.failures = failures, .plans = true}));
}

RestOfRobots rest(bool steady, double greatest) {
  RestOfRobots rest;
  rest.steady = rest.clear = steady;
  rest.greatest_by_springs = greatest;
  return rest;
}

// A report about robots of which nothing else is known.
std::string words_of(const Report& report, std::string (*words)(const Reported&),
                     const Shown& shown = {}) {
  const Placement placement(solid(testing::polygon(testing::square)));
  return words({{placement, shown}, report});
}

std::string failure_words(std::size_t robot, std::size_t robots,
                          const std::optional<RestOfRobots>& rest, const Shown& shown = {}) {
  Placement placement(solid(testing::polygon(testing::square)));
  placement.teams = {Team{}};
  placement.teams[0].robots.resize(robots);
  return plainly(failure_in_words({placement, shown}, robot, rest));
}

}  // namespace

TEST_CASE("the JSON says of each robot where it stands and faces and its load",
          "[json][robustness]") {
  const Placement placement = placed("grand-piano", 3);
  const Json json = json_of(placement);
  REQUIRE(json["robots"].size() == 6);
  for (std::size_t i = 0; i < 6; ++i) {
    const Json& robot = json["robots"][i];
    CHECK(robot.names() == Names{"at", "team", "load", "contact", "stand", "heading", "place"});
    CHECK(robot["team"] == i / 2);
    CHECK(robot["at"] == json["teams"][i / 2]["ends"][i % 2]);
    CHECK(robot["load"] == json["teams"][i / 2]["loads"][i % 2]);
    CHECK(robot["contact"] == robot["at"]);
    CHECK(robot["stand"] == robot["at"]);
  }
}

TEST_CASE("the JSON always has the loads of all models and the robustness", "[json][robustness]") {
  const Placement placement = placed("grand-piano", 3);
  const Json json = json_of(placement);
  const auto loads = model_loads(placement);
  REQUIRE(loads);
  CHECK(json["loads"]["models"].names() == Names{"springs", "best", "worst"});
  CHECK(json["loads"]["models"]["springs"] == loads->springs.loads);
  CHECK(json["loads"]["models"]["best"] == loads->best);
  CHECK(json["loads"]["models"]["worst"] == loads->worst);
  CHECK(json["robustness"].names() == Names{"com_margin", "failures_carried", "failures_steady",
                                            "failures_clear", "load_per_length"});
  CHECK(json["robustness"]["failures_carried"] == 2);
  CHECK(json["robustness"]["failures_steady"] == 1);
  CHECK(json["robustness"]["load_per_length"] == loads->springs.per_length);
  CHECK_FALSE(json.contains("failures"));
  const Json one_team = json_of(placed("grand-piano", 1));
  CHECK(one_team["robustness"]["com_margin"] == 0);
  CHECK(one_team["robustness"]["failures_carried"] == 0);
  CHECK(one_team["robustness"]["failures_steady"] == -1);
}

TEST_CASE("without teams the JSON has no robots", "[json][robustness]") {
  Document document;
  document.vertices = {{-1, -1}, {101, -1}, {101, 60}, {100, 60},
                       {100, 0}, {0, 0},    {0, 60},   {-1, 60}};
  document.centre_of_mass = Vec2(10, 50);
  const Result<Placement> placement = place(document);
  REQUIRE(placement.ok());
  REQUIRE(placement->teams.empty());
  const Json json = json_of(*placement, {.com_radius = 1, .capacity = 20}, true);
  for (const char* name : {"robots", "robustness", "failures"}) CHECK_FALSE(json.contains(name));
  CHECK(json["loads"].is_null());
}

TEST_CASE("with a C uncertainty the JSON has ranges", "[json][robustness]") {
  const Placement placement = placed("grand-piano", 3);
  const Json json = json_of(placement, {.com_radius = 20, .capacity = 18.5})["robustness"];
  CHECK(json["com_radius"] == 20);
  CHECK(json["exact_within"].number() > 20);
  const auto loads = model_loads(placement);
  for (std::size_t i = 0; i < 6; ++i) {
    const double change = 20 * loads->springs.per_length[i];
    CHECK(json["springs_ranges"][i][0] == Approx(loads->springs.loads[i] - change));
    CHECK(json["springs_ranges"][i][1] == Approx(loads->springs.loads[i] + change));
    const double load = placement.teams[i / 2].robots[i % 2].load;
    CHECK(json["plan_ranges"][i][0] == Approx(load - change));
    CHECK(json["plan_ranges"][i][1] == Approx(load + change));
  }
  // At the radius that the capacity allows, the greatest load reaches it.
  const Json capacity = json_of(placement, {.capacity = 18.5})["capacity"];
  const double radius = capacity["com_radius"].number();
  double greatest = 0;
  for (std::size_t i = 0; i < 6; ++i)
    greatest = std::max(greatest, loads->springs.loads[i] + radius * loads->springs.per_length[i]);
  CHECK(greatest == Approx(18.5));
  CHECK(json_of(placement, {.capacity = 17})["capacity"]["com_radius"].is_null());
}

TEST_CASE("with a C uncertainty the first sentence has the ranges, of balanced robots too",
          "[words][robustness]") {
  Document document = corpus::polygon("corner-sofa");
  document.shown.com_radius = 3;
  document.shown.units.length = LengthUnit::cm;
  for (const Method method : {Method::area, Method::balanced}) {
    document.settings.method = method;
    document.settings.robots = 5;
    const Placement placement = place(document).value();
    const auto loads = model_loads(placement, {.com_radius = 3});
    REQUIRE(loads);
    const std::vector<LoadRange> ranges = loads_by(LoadModel::plan, placement, loads);
    double least = 100, greatest = 0;
    for (const LoadRange& range : ranges) {
      least = std::min(least, range.least);
      greatest = std::max(greatest, range.greatest);
    }
    const std::string robots = std::to_string(count_robots(placement.teams)) + " robots";
    CHECK(plainly(loads_in_words({placement, document.shown})) ==
          robots + " carry " + amounts(LoadRange{least, greatest}, greatest) +
              " kg each, with a C uncertainty of 3 cm (100 kg in all).");
    // Other models' loads have their own sentences; the plan's assume C as given.
    const Asked springs{.model = LoadModel::springs};
    CHECK(loads_in_words({{placement, document.shown}, springs}) ==
          loads_in_words({placement, springs}));
  }
}

TEST_CASE("with failures the JSON has a row for each robot", "[json][robustness]") {
  const Json json = json_of(placed("grand-piano", 3), {}, true);
  REQUIRE(json["failures"].size() == 6);
  for (std::size_t i = 0; i < 6; ++i) {
    const Json& row = json["failures"][i];
    CHECK(row.names() == Names{"robot", "carried", "steady", "clear", "com_margin", "coverage",
                               "form_closure", "margin", "plan_max", "springs_max", "best_max",
                               "springs"});
    const std::vector<double> springs = row["springs"].numbers();
    REQUIRE(springs.size() == 6);
    CHECK(springs[i] == 0);
    CHECK(std::accumulate(springs.begin(), springs.end(), 0.0) == Approx(100));
    CHECK(row["springs_max"] == *std::max_element(springs.begin(), springs.end()));
    CHECK(row["robot"] == i);
    CHECK(row["carried"] == true);
    CHECK(row["best_max"].number() <= row["springs_max"].number());
  }
  const Json one_team = json_of(placed("grand-piano", 1), {}, true);
  for (const Json& row : one_team["failures"]) {
    CHECK(row["carried"] == false);
    CHECK(row["steady"] == false);
    CHECK(row["clear"] == false);
    for (const char* name : {"com_margin", "coverage", "form_closure", "margin", "plan_max",
                             "springs_max", "best_max", "springs"})
      CHECK(row[name].is_null());
  }
}

TEST_CASE("a row of failures has the numbers of what is left without that robot",
          "[json][robustness]") {
  const Placement placement = placed("grand-piano", 3);
  const Json json = json_of(placement, {}, true);
  const auto failures = single_failures(placement);
  REQUIRE(failures.size() == 6);
  for (std::size_t i = 0; i < 6; ++i) {
    INFO(i);
    const Json& row = json["failures"][i];
    REQUIRE(failures[i]);
    CHECK(row["steady"] == failures[i]->steady);
    CHECK(row["clear"] == failures[i]->clear);
    CHECK(row["com_margin"] == failures[i]->tipping_distance);
    CHECK(row["coverage"] == failures[i]->coverage);
    CHECK(row["form_closure"] == failures[i]->form_closure);
    CHECK(row["margin"].is_null() == !failures[i]->margin);
    if (failures[i]->margin) CHECK(row["margin"] == *failures[i]->margin);
    CHECK(row["plan_max"] == failures[i]->greatest_by_plan.value());
    CHECK(row["springs_max"] == failures[i]->greatest_by_springs);
    CHECK(row["best_max"] == failures[i]->least_greatest);
    CHECK(failures[i]->greatest_by_springs > failures[i]->least_greatest);
  }
}

TEST_CASE("the models of loads are told in a sentence", "[words][robustness]") {
  ModelLoads loads{{{15.2, 0, 18.1, 0}, {}, 0}, 17.04, {50, 20, 54.04, 10}};
  const auto words = [&](LoadModel model) {
    Report report;
    report.model = model;
    report.models = loads;
    return plainly(words_of(report, model_in_words));
  };
  CHECK(words(LoadModel::plan).empty());
  CHECK(words(LoadModel::springs) ==
        "If all robots are equally stiff and level and the object does not bend, they carry "
        "0.0–18.1 kg each. Robots 2 and 4 go slack.");
  loads.springs.loads = {15.2, 1, 18.1, 0};
  CHECK(words(LoadModel::springs) ==
        "If all robots are equally stiff and level and the object does not bend, they carry "
        "0.0–18.1 kg each. Robot 4 goes slack.");
  CHECK(words(LoadModel::best) ==
        "However well the weight is shared, some robot carries at least 17.0 kg.");
  CHECK(
      words(LoadModel::worst) ==
      "On level ground and with C as given, a robot may have to carry up to 54.1 kg if heights are "
      "unequal or the object bends.");
}

TEST_CASE("a C uncertainty is told in sentences", "[words][robustness]") {
  const auto words = [](double radius, double tips) {
    const LoadChanges changes{{.reach = radius}, false, {radius / 2, radius}, {12, 11.5}, {3, 1}};
    Shown shown;
    shown.com_radius = radius;
    Report report;
    report.disturbance = {.com_radius = radius};
    report.models = {{{40, 20}, {0.5, 1}, 20}, 6, {}, report.disturbance, changes};
    report.robustness.tipping_distance = tips;
    return words_of(report, uncertainty_in_words, shown);
  };
  const std::string off = "If C is off by up to ",
                    change = ", the loads of equally stiff robots change by up to ";
  CHECK(plainly(words(4, 30)) == off + "4" + change + "4.00 kg.");
  CHECK(plainly(words(25, 30)) ==
        off +
            "25, one of equally stiff robots may go slack, and another may have to carry up to "
            "12.0 kg.");
  CHECK(plainly(words(31, 30)) == "If C is off by 30.0 or more, the object can tip.");
  CHECK(plainly(words(1, 0)) == "Even the smallest error of C can tip the object.");
  CHECK(words_of({}, uncertainty_in_words).empty());
}

TEST_CASE("how far C may be off for a capacity is told, with the other conditions",
          "[words][robustness]") {
  // Four robots at the corners of a square of side 10: 25 kg each, and 5 kg per unit.
  Document document;
  document.vertices = {{0, 0}, {10, 0}, {10, 10}, {0, 10}};
  document.settings.method = Method::given;
  document.settings.supports = document.vertices;
  const auto words = [&] {
    const Placement placement = place(document).value();
    const std::string text = plainly(uncertainty_in_words({placement, document.shown}));
    return text.substr(std::min(text.size(), text.rfind(". ", text.size() - 2) + 2));
  };
  document.shown.com_radius = 0.001;
  document.shown.capacity = 35;
  const std::string stay = "Equally stiff robots stay within ";
  CHECK(words() == stay + "35 kg as long as C is off by at most 1.41.");
  document.shown.capacity = 20;
  CHECK(words() == "If all robots are equally stiff, some may carry more than 20 kg.");
  document.shown.capacity = std::nullopt;
  document.shown.support_capacities = {35, std::nullopt, std::nullopt, std::nullopt};
  CHECK(words() == stay + "their capacities as long as C is off by at most 1.41.");
  document.shown.carrying = {.com_height = 5, .slope = 0.2};
  CHECK(words() == stay + "their capacities as long as C is off by at most 0.414.");
  document.shown.carrying.slope = 0.3;
  CHECK(words() == "If all robots are equally stiff, some may carry more than they can.");
}

TEST_CASE("an object can tip from the very distance on at which it tips", "[words][robustness]") {
  const Placement placement(solid(testing::polygon(testing::square)));
  const auto words = [&](double radius, double distance = 20) {
    Shown shown;
    shown.com_radius = radius;
    Report report;
    report.disturbance = disturbance_of(shown);
    report.effect.reach = radius;
    report.robustness.tipping_distance = distance;
    return plainly(tipping_in_words({{placement, shown}, report}));
  };
  const std::string tips = ", and 20.0 in one direction is enough.";
  CHECK(words(0).empty());
  CHECK(words(19.99).empty());
  CHECK(words(20) == "It can tip: the centre of mass may be off by 20" + tips);
  CHECK(words(25) == "It can tip: the centre of mass may be off by 25" + tips);
  // Without a place for C there is no message, even if the smallest error tips the object.
  CHECK(words(0, 0).empty());
}

TEST_CASE("failures are told in sentences", "[words][robustness]") {
  Shown steep;
  steep.carrying.slope = 0.6;
  const auto words = [](const std::vector<std::optional<RestOfRobots>>& failures,
                        const Shown& shown = {}) {
    Report report;
    report.failures = failures;
    return plainly(words_of(report, failures_in_words, shown));
  };
  const std::string sudden =
      " At a sudden failure loads swing beyond this, those of the nearest robots by about twice the "
      "change, others by more.";
  CHECK(words({rest(true, 20), rest(true, 21.34), rest(true, 5)}) ==
        "Whichever robot fails, the others carry the object, at most 21.4 kg each if equally "
        "stiff." +
            sudden);
  CHECK(words({std::nullopt, std::nullopt}) == "The object falls whichever robot fails.");
  CHECK(words({std::nullopt, rest(true, 20), rest(false, 30), std::nullopt}) ==
        "The object falls if any of robots 1 and 4 fails. If another fails, the others carry "
        "it, at most 30.0 kg each if equally stiff. It can tip if robot 3 fails." +
            sudden);
  CHECK(failure_words(2, 6, rest(true, 21.34)) ==
        "Robot 3 fails: the other five carry the object, at most 21.4 kg each.");
  CHECK(failure_words(0, 14, rest(false, 21.34)) ==
        "Robot 1 fails: the other 13 carry the object, at most 21.4 kg each, but it can tip.");
  CHECK(failure_words(2, 6, rest(true, 21.34), {.capacity = 21.4}) ==
        "Robot 3 fails: the other five carry the object, at most 21.4 kg each.");
  CHECK(failure_words(2, 6, rest(true, 21.34), {.capacity = 20.0}) ==
        "Robot 3 fails: the other five carry the object, at most 21.4 kg each. Capacity: 20 kg.");
  // What tips under the given conditions carries nothing.
  RestOfRobots leaves = rest(true, 20);
  leaves.stays = false;
  CHECK(words({rest(true, 20), leaves}, steep) ==
        "If robot 2 fails, it tips on a slope of 60 %. If another fails, the others carry it, at "
        "most 20.0 kg each if equally stiff." +
            sudden);
  CHECK(words({leaves, leaves}, steep) == "Whichever robot fails, it tips on a slope of 60 %.");
  CHECK(words({std::nullopt, leaves}, steep) ==
        "The object falls if robot 1 fails. If robot 2 fails, it tips on a slope of 60 %.");
  CHECK(failure_words(1, 6, leaves, steep) == "Robot 2 fails: it tips on a slope of 60 %.");
  CHECK(failure_words(1, 2, std::nullopt) ==
        "Robot 2 fails: the other one cannot carry the object.");
}

TEST_CASE("what may go wrong is told in two facts", "[words][robustness]") {
  const Placement placement = placed("grand-piano", 3);
  const auto facts = [&](int carried, int steady) {
    Report report = report_of(placement);
    report.robustness = {carried, steady, 117.2, steady};
    return facts_in_words({placement, report});
  };
  const auto value = [](const std::vector<Fact>& all, const std::string& label) {
    for (const Fact& fact : all)
      if (fact.label == label) return fact.value;
    return std::string();
  };
  const auto may_fail = [&](int carried, int steady) {
    return value(facts(carried, steady), "Robots that may fail");
  };
  CHECK(may_fail(2, 1) == "any 1; any 2 if it may tip");
  CHECK(may_fail(2, 2) == "any 2");
  CHECK(may_fail(1, 0) == "any 1, but it can tip then");
  CHECK(may_fail(0, 0) == "none");
  CHECK(may_fail(0, -1) == "none");
  CHECK(value(facts(2, 1), "Tipping distance") == "117");
  const auto none = facts_in_words(Placement(solid(testing::polygon(testing::square))));
  REQUIRE(none.size() == 1);
  CHECK(none[0].label == std::string("Candidate teams"));
}
