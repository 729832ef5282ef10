#include "evenlift/supports.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "evenlift/capacity.h"
#include "evenlift/import.h"
#include "evenlift/link.h"
#include "evenlift/output/json.h"
#include "evenlift/output/poses.h"
#include "evenlift/output/robustness_words.h"
#include "evenlift/output/svg.h"
#include "evenlift/output/verdict.h"
#include "evenlift/output/words.h"
#include "evenlift/placed_robots.h"
#include "evenlift/random.h"
#include "evenlift/report.h"
#include "evenlift/request.h"
#include "evenlift/settings.h"
#include "kit/catch.h"
#include "kit/corpus.h"
#include "kit/json.h"
#include "kit/placed.h"
#include "kit/polygons.h"
#include "kit/random_documents.h"
#include "kit/texts.h"

using namespace evenlift;
using evenlift::testing::Json;
using evenlift::testing::placed;
using evenlift::testing::plainly;

namespace {

const Points unit_square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};

Document standing_on(const Points& supports, const Points& vertices = unit_square) {
  Document document;
  document.vertices = vertices;
  document.settings.method = Method::given;
  document.settings.supports = supports;
  return document;
}

std::vector<double> loads_on(const Points& supports) {
  return planned_loads(placed(standing_on(supports)).teams);
}

Json json_of(const Document& document) {
  const Placement placement = placed(document);
  return Json::parse(placement_json({placement, document.shown}, false));
}

InputError refusal(const Document& document) {
  const auto placement = place(document);
  REQUIRE_FALSE(placement.ok());
  return placement.error();
}

void check_loads(const std::vector<double>& loads, const std::vector<double>& expected) {
  REQUIRE(loads.size() == expected.size());
  for (std::size_t i = 0; i < loads.size(); ++i)
    CHECK(loads[i] == Approx(expected[i]).margin(1e-6));
}

}  // namespace

TEST_CASE("supports carry what equilibrium and equal springs demand", "[supports]") {
  check_loads(loads_on(unit_square), {25, 25, 25, 25});
  check_loads(loads_on({{0, 0}, {1, 0}, {0.5, 1}}), {25, 25, 50});
  check_loads(loads_on({{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0.5, 0.5}}), {20, 20, 20, 20, 20});
  check_loads(loads_on({{0.25, 0}, {0.75, 1}, {0.5, 0.5}}), {100.0 / 3, 100.0 / 3, 100.0 / 3});
  check_loads(loads_on({{0, 0.5}, {0.75, 0.5}}), {100.0 / 3, 200.0 / 3});  // the lever
  check_loads(loads_on({{0.5, 0.5}}), {100});
}

TEST_CASE("four robots at the corners cover all and hold nothing", "[supports]") {
  const Placement corners = placed(standing_on(unit_square));
  CHECK(corners.coverage == 1);
  CHECK_FALSE(corners.closure.margin);
  CHECK(model_loads(corners)->worst == std::vector<double>{50, 50, 50, 50});
  CHECK(placed(standing_on({{0, 0}, {1, 0}, {0.5, 1}})).coverage == Approx(0.5));
  const Placement middles = placed(standing_on({{0.5, 0}, {1, 0.5}, {0.5, 1}, {0, 0.5}}));
  CHECK(middles.coverage == Approx(0.5));
  CHECK_FALSE(middles.closure.form_closure);  // to first order it turns about its middle
  CHECK(middles.closure.second_order);
}

TEST_CASE("an object falls if its centre of mass is outside the lifting base", "[supports]") {
  const Document document = standing_on({{0, 0}, {0.4, 0}, {0, 0.4}});
  const Placement placement = placed(document);
  CHECK_FALSE(placement.loads);
  CHECK(placement.coverage == Approx(0.08));
  const Equilibrium balance = equilibrium(placement);
  CHECK_FALSE(balance.stands);
  CHECK(balance.com_margin == Approx(-0.6 / std::sqrt(2)));
  CHECK(balance.tips_over == std::vector<std::uint32_t>{1, 2});
  const Json result = json_of(document);
  CHECK(result["loads"].is_null());
  CHECK(result["robots"][0]["load"].is_null());
  CHECK(result["stands"] == false);
  CHECK(result["tips_over"] == std::vector<double>{1, 2});
  CHECK(result["verdict"]["kind"] == "bad");
  CHECK(plainly(loads_in_words(placement)) ==
        "It falls: the centre of mass is 0.424 outside the lifting base, beyond robots 2 and 3.");
  CHECK(poses_text(placement, PoseFormat::csv).find(",,,kg") != std::string::npos);
  CHECK_FALSE(placement_svg(placement).empty());
}

TEST_CASE("what an object tips over is an edge of its base, or one robot", "[supports]") {
  const auto over = [](const Points& supports) {
    return equilibrium(placed(standing_on(supports))).tips_over;
  };
  CHECK(over({{0, 0}}) == std::vector<std::uint32_t>{0});
  CHECK(over({{0, 0}, {1, 0}}) == std::vector<std::uint32_t>{0, 1});
  CHECK(over({{0, 0}, {0.25, 0.25}}) == std::vector<std::uint32_t>{1});  // on their line
  CHECK(over({{0.6, 0.1}, {0.6, 0.9}, {1, 0.9}, {1, 0.1}}) == std::vector<std::uint32_t>{0, 1});
  // C is as far beyond two edges: the one with the robot of the smallest number counts.
  CHECK(over({{0.25, 0}, {0, 0}, {0, 0.25}, {0.25, 0.25}}) == std::vector<std::uint32_t>{0, 3});
  CHECK(over({{0, 0.25}, {0, 0}, {0.25, 0}, {0.25, 0.25}}) == std::vector<std::uint32_t>{0, 3});
  CHECK(over(unit_square).empty());
}

TEST_CASE("a support near the outline stands at the edge, and farther inside beneath",
          "[supports]") {
  const auto one = [](const Vec2& at, std::optional<double> snap = std::nullopt) {
    Document document = standing_on({at, {1, 1}}, {{0, 0}, {2, 0}, {2, 2}, {0, 2}});
    document.settings.snap = snap;
    return placed_robots(placed(document)).front();
  };
  CHECK_FALSE(one({1, 0}).beneath);
  CHECK(one({1, 1e-7}).at == Vec2(1, 0));
  CHECK(one({1, -1e-7}).at == Vec2(1, 0));
  CHECK(one({1e-9, 1e-9}).at == Vec2(0, 0));
  CHECK_FALSE(one({1, 1e-4}).beneath);
  CHECK(one({1, 1e-3}).beneath);
  CHECK(one({1, 1e-3}, 1e-2).at == Vec2(1, 0));
  CHECK(one({1, 1e-12}, 0.0).beneath);
  CHECK_FALSE(one({1, 0}, 0.0).beneath);
}

TEST_CASE("a support outside the object is refused by its number", "[supports][errors]") {
  const auto refused = [](const Vec2& at) {
    return refusal(standing_on({{0, 0}, {160, 0}, {80, 90}, at}, {{0, 0}, {160, 0}, {80, 90}}));
  };
  const InputError right = refused({170, 0});
  CHECK(right.message == "(170, 0) is 10 outside the object");
  CHECK(right.place.option == "supports[3]");
  // Nearly at the edge: L is 184.
  CHECK(refused({-0.0213, 0}).message ==
        "(-0.0213, 0) is 0.0213 outside the object; --snap 0.03 puts it at the edge");
  CHECK(refused({-0.02, 0}).message ==
        "(-0.02, 0) is 0.02 outside the object; --snap 0.02 puts it at the edge");
  CHECK(refused({1e-200, 0}).place.option == "supports[3]");
  CHECK(refusal(standing_on({})).place.option == "supports");
  Document capacities = standing_on(unit_square);
  capacities.shown.support_capacities = {30, std::nullopt};
  CHECK(refusal(capacities).message == "2 capacities are given for 4 supports");
  Document moved = standing_on(unit_square);
  moved.moved.robots = {{0, 0.5}};
  refusal(moved);
}

TEST_CASE("a support that is left out changes nothing but the numbers", "[supports][left-out]") {
  Rng random(5);
  for (int i = 0; i < 300; ++i) {
    Points places(4 + random.below(5));
    for (Vec2& place : places) place = Vec2(random.uniform(), random.uniform());
    Document all = standing_on({});
    std::vector<double> own;
    std::vector<std::uint32_t> standing;
    for (std::uint32_t k = 0; k < places.size(); ++k) {
      const bool out = random.below(3) == 0;
      all.settings.supports.push_back(out ? places[k] + Vec2(2, 0) : places[k]);
      all.shown.support_capacities.push_back(10.0 + k);
      if (!out) standing.push_back(k);
    }
    if (standing.empty()) continue;
    Document fewer = standing_on({});
    for (const std::uint32_t k : standing) {
      fewer.settings.supports.push_back(places[k]);
      fewer.shown.support_capacities.push_back(10.0 + k);
    }
    const auto kept = place(all, Effort::whole, Misfitting::left_out);
    REQUIRE(kept);
    const Placement expected = placed(fewer);
    const ShownPlacement of(*kept, all.shown), without(expected, fewer.shown);
    CHECK(planned_loads(kept->teams) == planned_loads(expected.teams));
    CHECK(kept->lifting_base == expected.lifting_base);
    CHECK(kept->coverage == expected.coverage);
    CHECK(overloaded_robots(of) == overloaded_robots(without));
    CHECK(report_of(of, {.failures = true}).overloaded_after ==
          report_of(without, {.failures = true}).overloaded_after);
    CHECK(kept->left_out.size() == places.size() - standing.size());
    for (std::size_t robot = 0; robot < standing.size(); ++robot)
      CHECK(kept->number_of(robot) == standing[robot] + 1);
    if (kept->left_out.empty()) CHECK(kept->supports.empty());
  }
}

TEST_CASE("people know robots by the numbers of their supports, also when others are left out",
          "[supports][left-out]") {
  Document document = standing_on({{5, 5}, {0, 0}, {1, 0}, {0.5, 1}, {0.5, 0.5}});
  document.holes = {{{0.4, 0.4}, {0.6, 0.4}, {0.6, 0.6}, {0.4, 0.6}}};
  document.shown.support_capacities = {90, 30, 20, std::nullopt, 90};
  CHECK(plainly(refusal(document).message) == "(5, 5) is 5.66 outside the object");
  const auto kept = place(document, Effort::whole, Misfitting::left_out);
  REQUIRE(kept);
  const Reported of(ShownPlacement(*kept, document.shown), {.failures = true});
  CHECK(plainly(capacity_in_words(of)) == "1 of 3 robots is overloaded: robot 3.");
  CHECK(plainly(failures_in_words(of)) == "The object falls whichever robot fails.");
  CHECK(left_out_in_words(*kept) ==
        std::vector<std::string>{"Robot 1 is outside the object: it carries nothing.",
                                 "Robot 5 is in hole 1: it carries nothing."});
  CHECK(judge(of).codes[1] == "left_out");
  CHECK(poses_text(of, PoseFormat::csv).find("\n4,1,0.5,1,") != std::string::npos);
  CHECK(placement_svg(of).find(">4<") != std::string::npos);
  // All are left out.
  document.settings.supports = {{5, 5}, {6, 5}};
  document.shown.support_capacities.clear();
  const auto none = place(document, Effort::whole, Misfitting::left_out);
  REQUIRE(none);
  CHECK(none->teams.empty());
  CHECK(judge(*none).reasons ==
        std::vector<std::string>{"Robots 1 and 2 are outside the object: they carry nothing."});
  CHECK(judge(*none).kind == VerdictKind::bad);
}

TEST_CASE("holes that do not fit are left out, the later of two that meet",
          "[supports][left-out][holes]") {
  const auto square = [](double x, double y, double size) {
    return Points{{x, y}, {x + size, y}, {x + size, y + size}, {x, y + size}};
  };
  Document document = standing_on({{0, 0}, {1, 0}, {0.5, 1}, {0.68, 0.68}});
  document.holes = {square(0.9, 0.1, 0.3), square(0.2, 0.2, 0.2), square(0.3, 0.3, 0.2),
                    square(0.6, 0.6, 0.15)};
  CHECK_FALSE(place(document).ok());
  const auto kept = place(document, Effort::whole, Misfitting::left_out);
  REQUIRE(kept);
  CHECK(kept->object.rings_of_holes() == std::vector<Points>{document.holes[1], document.holes[3]});
  CHECK(kept->left_out == std::vector<Misplaced>{{Misplaced::Kind::hole, 0, {}},
                                                 {Misplaced::Kind::hole, 2, {}},
                                                 {Misplaced::Kind::support, 3, 3u}});
  CHECK(left_out_in_words(*kept) ==
        std::vector<std::string>{"Holes 1 and 3 do not fit the object, and are left out.",
                                 "Robot 4 is in hole 4: it carries nothing."});
  document.vertices = {{0, 0}, {1, 0}, {0, 1}, {1, 1}};  // the outline itself must be valid
  CHECK_FALSE(place(document, Effort::whole, Misfitting::left_out).ok());
}

TEST_CASE("readings of a support that is left out still count: they were taken before",
          "[supports][left-out][weigh]") {
  Document document = standing_on({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  document.settings.weighed.readings = {10, 20, 30, 40};
  const Placement before = placed(document);
  document.vertices = {{0, 0}, {1, 0}, {0.8, 0.8}, {0, 1}};
  const auto after = place(document, Effort::whole, Misfitting::left_out);
  REQUIRE(after);
  REQUIRE(after->weighing);
  CHECK(after->weighing->weight == before.weighing->weight);
  CHECK(after->weighing->centre == before.weighing->centre);
  CHECK(after->number_of(2) == 4);
}

TEST_CASE("a request leaves out what does not fit only if it asks for it",
          "[supports][left-out][request]") {
  const auto asked = [](const std::string& more) {
    return Json::parse(answer(R"({"polygon": [[0, 0], [1, 0], [1, 1], [0, 1]],
                                  "supports": [[0, 0], [3, 0], [1, 0], [0.5, 1]])" +
                              more + "}"));
  };
  CHECK(asked("")["error"]["place"]["setting"] == "supports[1]");
  CHECK(asked(R"(, "keep_misfits": false)")["error"]["place"]["setting"] == "supports[1]");
  const Json kept = asked(R"(, "keep_misfits": true)");
  CHECK(kept["left_out"] == Json::parse(R"([{"kind": "support", "index": 1, "in_hole": null}])"));
  CHECK(kept["robots"][1]["support"] == 2.0);
  CHECK(kept["robots"].size() == 3);
  CHECK(asked(R"(, "keep_misfits": 1)").contains("error"));
}

TEST_CASE("a support near a notch stands in it", "[supports]") {
  Document document =
      standing_on({{5.0002, 0.9999}}, {{0, 0}, {4, 0}, {5, 1}, {6, 0}, {10, 0}, {10, 10}, {0, 10}});
  CHECK(placed_robots(placed(document))[0].at == Vec2(5, 1));
  document.settings.snap = 1e-5;
  CHECK(placed_robots(placed(document))[0].at != Vec2(5, 1));
}

TEST_CASE("what the snap distance does is told", "[supports]") {
  const auto notes = [](const Points& supports) {
    const Document document = standing_on(supports, {{0, 0}, {100, 0}, {100, 100}, {0, 100}});
    return snap_notes(placed(document).object, document.settings);
  };
  CHECK(notes({{0, 0}, {50, 50}}).empty());
  CHECK(notes({{0, 0}, {50, 1e-5}}).empty());  // L is 141
  CHECK(notes({{0, 0}, {50, 0.0101}, {50, 100.01}}) ==
        std::vector<std::string>{"2 supports were put at the edge, at most 0.0101 away"});
  CHECK(notes({{50, 0.02}, {50, 0.13}}) ==
        std::vector<std::string>{
            "robot 1 is beneath the object, 0.02 from the edge; --snap 0.02 puts it at the edge"});
  CHECK(notes({{50, 0.13}, {50, 0.02}, {50, 0.1}}) ==
        std::vector<std::string>{
            "robot 2 is beneath the object, 0.02 from the edge; --snap 0.02 puts it at the edge"});
}

TEST_CASE("robots beneath touch nothing sideways", "[supports]") {
  const Points inside{{0.2, 0.2}, {0.8, 0.2}, {0.5, 0.8}};
  const Placement placement = placed(standing_on(inside));
  CHECK_FALSE(placement.closure.margin);
  const Json result = json_of(standing_on(inside));
  CHECK(result["robots"][1]["place"] == "beneath");
  CHECK(result["robots"][1]["contact"].is_null());
  CHECK(placement_svg(placement).find("robot beneath") != std::string::npos);
}

TEST_CASE("the robots of every method, given as supports, have the same results",
          "[supports][slow]") {
  int compared = 0;
  const auto compare = [&](const Document& document) {
    const Placement placement = placed(document);
    if (placement.teams.empty()) return;
    Document given = document;
    given.settings.method = Method::given;
    given.settings.supports = positions(lifting_points(placement.teams));
    const Placement same = placed(given);
    CHECK(same.lifting_base.size() == placement.lifting_base.size());
    CHECK(same.coverage == Approx(placement.coverage));
    CHECK(same.closure.form_closure == placement.closure.form_closure);
    CHECK(same.closure.second_order == placement.closure.second_order);
    CHECK(same.closure.margin.has_value() == placement.closure.margin.has_value());
    if (same.closure.margin) CHECK(*same.closure.margin == Approx(*placement.closure.margin));
    const auto a = model_loads(same), b = model_loads(placement);
    check_loads(a->springs.loads, b->springs.loads);
    CHECK(a->best == Approx(b->best));
    check_loads(a->worst, b->worst);
    const Robustness mine = robustness(same), theirs = robustness(placement);
    CHECK(mine.failures_carried == theirs.failures_carried);
    CHECK(mine.failures_steady == theirs.failures_steady);
    CHECK(mine.tipping_distance == Approx(theirs.tipping_distance).margin(1e-6));
    const auto lost = single_failures(same), lost_there = single_failures(placement);
    for (std::size_t i = 0; i < lost.size(); ++i) {
      CHECK(lost[i].has_value() == lost_there[i].has_value());
      if (lost[i])
        CHECK(lost[i]->greatest_by_springs == Approx(lost_there[i]->greatest_by_springs));
    }
    ++compared;
  };
  for (const std::string& name : corpus::polygon_names()) {
    INFO(name);
    Document document = corpus::polygon(name);
    for (const Method method : pair_methods)
      for (std::uint32_t teams = 1; teams <= 6; teams += 2) {
        document.settings.method = method;
        document.settings.teams = teams;
        compare(document);
      }
    document.settings.method = Method::balanced;
    for (std::uint32_t robots = 3; robots <= 5; ++robots) {
      document.settings.robots = robots;
      if (document.vertices.size() <= 100) compare(document);
    }
  }
  CHECK(compared > 200);
}

TEST_CASE("robots with a size are told where they do not fit", "[supports]") {
  Document document = standing_on({{1, 0}, {1.1, 0}, {0, 0}, {1, 2}, {1, 1}}, testing::square);
  document.settings.robot.radius = 0.2;
  document.settings.no_go = {{2, 0, 1}};
  const Placement placement = placed(document);
  std::vector<std::string> why;
  for (const Misfit& misfit : misfits(placement))
    why.push_back(std::to_string(misfit.robot + 1) + " " + misfit_in_words(misfit));
  CHECK(why == std::vector<std::string>{"2 too near robot 1", "3 outside", "4 no-go"});
  CHECK(judge(placement).kind == VerdictKind::warning);
  CHECK(json_of(document)["misfits"][0] ==
        Json::parse(R"({"robot": 1, "why": "too near robot 1", "other": 0})"));

  document.settings.supports = {{3, 0}, {3, 4}, {0, 3}};
  document.vertices = testing::u_shape;
  document.settings.no_go.clear();
  document.settings.robot = {0.3, 3, 2.5, 0.2, 0};
  document.settings.supports = {{3, 2}, {5, 0}, {0.5, 4}};
  std::vector<Misfit::Why> causes;
  for (const Misfit& misfit : misfits(placed(document))) causes.push_back(misfit.why);
  CHECK(std::find(causes.begin(), causes.end(), Misfit::Why::hand) != causes.end());

  document.settings.robot = {0, 0, 50, 1, 0};  // fits nowhere: told, not refused
  document.vertices = testing::square;
  document.settings.supports = {{1, 0}, {1, 2}};
  CHECK(misfits(placed(document)).size() >= 2);

  // Two points at one place.
  const Placement twice = placed(standing_on({{0, 0}, {1, 0}, {0.5, 1}, {1, 0}}));
  REQUIRE(misfits(twice).size() == 1);
  CHECK(misfit_in_words(misfits(twice)[0]) == "too near robot 2");
}

TEST_CASE("supports are evened out by the least moves", "[supports]") {
  const Document document = standing_on({{0, 0}, {0.9, 0}, {1, 0.9}, {0, 1}});
  const auto even = with_even_supports(document);
  REQUIRE(even.ok());
  const Placement placement = placed(*even);
  CHECK(placement.loads->spread <= 1e-9 * 100);
  CHECK(even->settings.supports[2] == Vec2(1, 0.9));
  const Document two = standing_on({{0, 0.4}, {1, 0.5}});
  CHECK(placed(*with_even_supports(two)).loads->spread <= 1e-9 * 100);
  CHECK(with_even_supports(standing_on({{0.4, 0.5}})).error().place.option == "even_out");
  // Three must move; the two that go to the upper side have the least squares if they divide the way
  // nearly equally.
  const Document crowded = standing_on({{0, 0.7}, {0, 0.7}, {0, 0.3}, {0, 0.1}, {0.4, 0}});
  const Points moved = with_even_supports(crowded)->settings.supports;
  CHECK(moved[0] == Vec2(0.78125, 1));
  CHECK(moved[1] == Vec2(0.71875, 1));
  const Document already = standing_on(unit_square);
  CHECK(with_even_supports(already)->settings.supports == unit_square);
  Document area = document;
  area.settings.method = Method::area;
  CHECK(with_even_supports(area).error().place.option == "even_out");
  // Those that are left out stay where they are.
  const Document misfit = standing_on({{3, 3}, {0, 0}, {0.9, 0}, {1, 0.9}, {0, 1}});
  const auto kept = with_even_supports(misfit, Misfitting::left_out);
  REQUIRE(kept.ok());
  CHECK(kept->settings.supports[0] == Vec2(3, 3));
  CHECK(Points(kept->settings.supports.begin() + 1, kept->settings.supports.end()) ==
        even->settings.supports);
}

TEST_CASE("a support that is moved to even out the loads collides with no other", "[supports]") {
  Document crowded =
      standing_on({{0.734, 0}, {0.812, 0}, {0.474, 0}, {0, 0.774}, {0.527, 0}, {0.659, 0}});
  crowded.settings.robot = {0.12, 0.3, 0, 0, 0};
  const Document even = *with_even_supports(crowded);
  const auto moves = [&](std::size_t robot) {
    return even.settings.supports[robot] != crowded.settings.supports[robot];
  };
  CHECK(moves(0) + moves(1) + moves(2) + moves(3) + moves(4) + moves(5) == 3);
  for (const Misfit& misfit : misfits(placed(even)))
    CHECK((misfit.why == Misfit::Why::too_near && !moves(misfit.robot) && !moves(misfit.other)));
}

TEST_CASE("each support may have a capacity of its own", "[supports][capacity]") {
  Document document = standing_on({{0, 0}, {1, 0}, {0.5, 1}});
  document.shown.support_capacities = {30, 20, std::nullopt};
  const Placement placement = placed(document);
  const ShownPlacement of(placement, document.shown);
  CHECK(overloaded_robots(of) == std::vector<std::size_t>{1});
  CHECK(plainly(capacity_in_words(of)) == "1 of 3 robots is overloaded: robot 2.");
  Shown both = document.shown;
  both.capacity = 45;
  CHECK(overloaded_robots({placement, both}) == std::vector<std::size_t>{1, 2});
  CHECK_FALSE(report_of({placement, both}, {.plans = true}).plan->possible);

  // After a failure, each other robot has its own capacity.
  Document four = standing_on(unit_square);
  four.centre_of_mass = Vec2(0.5, 0.5);
  four.shown.support_capacities = {60, 60, 40, 60};
  const Placement corners = placed(four);
  CHECK(overloaded_after({corners, four.shown}, single_failures(corners)) ==
        std::vector<std::vector<std::size_t>>{{}, {2}, {}, {2}});
}

TEST_CASE("supports are read from text, and a wrong one is quoted", "[supports][settings]") {
  Document document;
  CHECK_FALSE(read_setting(Setting::supports, "0,0  160,0@30\n80,90", document));
  CHECK(document.settings.method == Method::given);
  CHECK(document.settings.supports == Points{{0, 0}, {160, 0}, {80, 90}});
  CHECK(document.shown.support_capacities ==
        std::vector<std::optional<double>>{std::nullopt, 30, std::nullopt});
  CHECK(text_of(Setting::supports, document) == "0,0 160,0 80,90");
  CHECK(text_of(Setting::support_capacities, document) == "none,30,none");
  for (const char* bad : {"", " ", "1", "1,2,3", "1,2@", "1,2@0", "1,2@-1", "a,b", "1, 2"}) {
    INFO(bad);
    Document unchanged;
    CHECK(read_setting(Setting::supports, bad, unchanged));
    CHECK(unchanged.settings == Settings{});
  }
  const auto error = read_setting(Setting::supports, "0,0 1;2", document);
  CHECK(error->message.ends_with(", not \"1;2\""));
  CHECK_FALSE(read_setting(Setting::supports, "none", document));
  CHECK(document.settings.supports.empty());
}

TEST_CASE("links carry supports with every bit", "[supports][link]") {
  Rng rng(30);
  for (int i = 0; i < 300; ++i) {
    Document document = testing::random_document(rng, 20);
    testing::take_random_supports(rng, document);
    const auto link = encode_link(document);
    REQUIRE(link.ok());
    const auto back = decode_link(*link);
    REQUIRE(back.ok());
    CHECK(testing::same_document(*back, document));
  }
  // Coordinates cost as little as vertices.
  Document document = standing_on({{10, 0}, {150, 0}, {80, 90}, {20, 40}},
                                  {{0, 0}, {160, 0}, {160, 100}, {0, 100}});
  CHECK(encode_link(document)->size() < 55);
}

TEST_CASE("results with supports reopen", "[supports][import]") {
  Document document = standing_on({{0.25, 0}, {1, 0.5}, {0.5, 0.75}});
  document.centre_of_mass = Vec2(0.5, 0.45);
  document.settings.snap = 0.01;
  document.shown.support_capacities = {50, std::nullopt, 60};
  const Placement placement = placed(document);
  const ShownPlacement of(placement, document.shown);
  const auto read = read_shapes(placement_json(of, false, {.plans = true}));
  REQUIRE(read.ok());
  CHECK(testing::same_document(read->shapes.at(0).document, document));
  const auto decoded = read_shapes(document_json(document));
  CHECK(testing::same_document(decoded->shapes.at(0).document, document));
}

TEST_CASE("a request may give supports as arrays, in any order", "[supports][request]") {
  const std::string polygon = R"("polygon": [[0, 0], [1, 0], [1, 1], [0, 1]])";
  const auto asked = [&](const std::string& settings, const std::string& more = "") {
    return Json::parse(answer("{" + polygon + more + R"(, "settings": {)" + settings + "}}"));
  };
  const std::string arrays = R"("support_capacities": [30, null, 20],
                                "supports": [[0, 0], [1, 0], [0.5, 1]])";
  const Json result = asked(arrays);
  CHECK(result["metric"] == "given");
  CHECK(result["capacity"]["overloaded"] == std::vector<double>{2});
  CHECK(result == asked(R"("metric": "given", "supports": "0,0@30 1,0 0.5,1@20")"));
  CHECK(asked(R"("supports": "0,0 1,0", "metric": "area")")["metric"] == "area");
  CHECK(asked(R"("supports": [[0, 0], [1]])").contains("error"));
  for (const char* bad : {"[null]", "[0, 0]", "[\"0,0\"]", "[true]"})
    CHECK(asked(std::string(R"("supports": )") + bad)["error"]["path"] == "supports[0]");
  for (const char* bad : {"[true, 30]", "[\"30\", null]", "[[30]]"})
    CHECK(asked(R"("supports": [[0, 0], [1, 0]], "support_capacities": )" +
                std::string(bad))["error"]["place"]["setting"] == "support_capacities");
  CHECK(asked(R"("supports": [[0, 5]])")["error"]["place"]["setting"] == "supports[0]");
  const Json required = asked(arrays, R"(, "require": "stands, max<=40")");
  CHECK(required["requirements"] ==
        Json::parse(R"([{"condition": "stands", "value": true, "kept": true},
                        {"condition": "max<=40", "value": 50, "kept": false}])"));
  CHECK(asked(arrays, R"(, "require": "max")").contains("error"));
  const Json even =
      asked(R"("supports": [[0, 0], [0.9, 0], [1, 0.9], [0, 1]])", R"(, "even_out": true)");
  CHECK(even["loads"]["spread"].number() <= 1e-7);
}

TEST_CASE("supports are read from tables, results and poses", "[supports][import]") {
  const auto read = [](const std::string& text) { return *read_support_file(text); };
  const Points three{{0, 0}, {160, 0}, {80, 90}};
  CHECK(read("x,y\n0,0\n160,0\n80,90\n").places == three);
  const SupportFile table = read("name;y;X;capacity (kg)\na;0;0;30\nb;0;160;\nc;90,0;80;1,5");
  CHECK(table.places == three);
  CHECK(table.capacities == std::vector<std::optional<double>>{30, std::nullopt, 1.5});
  CHECK(read("[[0, 0], [160, 0], [80, 90]]").places == three);
  CHECK(read(R"([{"x": 0, "y": 0, "capacity": 7}])").capacities.at(0) == 7.0);
  const Document document = standing_on({{0, 0}, {1, 0}, {0.5, 1}});
  const Placement placement = placed(document);
  for (const std::string& text :
       {placement_json(placement, false), poses_text(placement, PoseFormat::json),
        poses_text(placement, PoseFormat::csv), poses_text(placement, PoseFormat::yaml)}) {
    INFO(text);
    CHECK(read(text).places == document.settings.supports);
  }
  CHECK(read(poses_text(placement, PoseFormat::yaml)).unit == LengthUnit::m);
  CHECK(table.unit == LengthUnit::none);
  Shown in_millimetres;
  in_millimetres.units.length = LengthUnit::mm;
  const ShownPlacement shown{placement, in_millimetres};
  for (const std::string& text : {placement_json(shown, false), poses_text(shown, PoseFormat::json),
                                  poses_text(shown, PoseFormat::csv)}) {
    INFO(text);
    CHECK(read(text).unit == LengthUnit::mm);
  }
  CHECK(read("x,y,unit\n0,0,pallet\n1,1,\n").unit == LengthUnit::none);
  CHECK(read("x,y,unit\n0,0,millimetres\n1,1,mm\n").unit == LengthUnit::mm);
  const SupportFile feet = read("x,y,unit\n1,0,ft\n2,1,feet\n36,0,in\n");
  CHECK(feet.unit == LengthUnit::in);
  CHECK(feet.places == Points{{12, 0}, {24, 12}, {36, 0}});
  CHECK(read("x,y,unit\n1,0,ft\n2,1,\n").places == Points{{12, 0}, {24, 12}});
  CHECK(read("x (cm),y (cm),SWL\n1,2,3").unit == LengthUnit::cm);
  CHECK(read("x (cm),y (cm),SWL\n1,2,3").capacities.at(0) == 3.0);
  CHECK(read("x,y,Rated capacity (kg)\n1,2,3").capacities.at(0) == 3.0);
  for (const char* bad :
       {"", "a,b\n1,2", "x,y\n1", "x,y\n1,b", "{}", "[1]", "[[1,2,3]]", "[", "x,y",
        "x,y,capacity\n1,2,-3", "x,y\n1,5,2", "x,y,unit\n1,2,yards", "x,y,unit\n1,2,\n3,4,ft",
        "x (m),y (mm)\n1,2", R"({"origin": "com", "robots": []})", "poses:\n - position: {x: 1}"})
    CHECK_FALSE(read_support_file(bad).ok());
}

TEST_CASE("turned and moved, an object stands on its supports as before", "[supports]") {
  const Document document = corpus::polygon("grand-piano");
  Document plain = document;
  plain.settings.method = Method::given;
  plain.settings.supports = positions(lifting_points(placed(document).teams));
  const Placement before = placed(plain);
  // Turned by the 3-4-5 triangle's angle, and moved.
  const auto turned = [](const Vec2& p) {
    return Vec2(0.6 * p.x - 0.8 * p.y + 1000, 0.8 * p.x + 0.6 * p.y - 300);
  };
  Document other = plain;
  for (Vec2& vertex : other.vertices) vertex = turned(vertex);
  for (Vec2& support : other.settings.supports) support = turned(support);
  if (other.centre_of_mass) other.centre_of_mass = turned(*other.centre_of_mass);
  const Placement after = placed(other);
  CHECK(after.coverage == Approx(before.coverage));
  CHECK(after.closure.form_closure == before.closure.form_closure);
  const std::vector<double> a = planned_loads(after.teams), b = planned_loads(before.teams);
  for (std::size_t i = 0; i < a.size(); ++i) CHECK(a[i] == Approx(b[i]));
}

TEST_CASE("a requirement names a quantity, and is kept within tolerance", "[supports][require]") {
  const Placement placement = placed(standing_on(unit_square));
  Shown shown;
  const auto kept = [&](const char* text) {
    std::string marks;
    for (const Requirement& requirement :
         check_conditions({placement, shown}, *read_conditions(text)))
      marks += requirement.kept ? '+' : '-';
    return marks;
  };
  CHECK(kept("held, stands, steady") == "-+-");
  CHECK(kept("coverage>=1, coverage >= 1.1, coverage<=0.5") == "+--");
  CHECK(kept("max<=25,min>=25,spread<=0,robots<=4,robots>=5") == "++++-");
  CHECK(kept("margin>=0") == "-");  // no contacts, so no margin
  CHECK(kept("tipping_distance>=0.5, tipping_distance>=0.51") == "+-");
  // C is on the line between a failed corner's neighbours.
  CHECK(kept("max_after_failure<=50, max_after_failure<=49") == "+-");
  CHECK(kept("capacity") == "+");
  shown.support_capacities = {25, 30, 30, 24};
  CHECK(kept("capacity") == "-");
  shown.support_capacities = {25, 30, 30, 30};
  CHECK(kept("capacity, max<=25") == "++");
  // Loads change by 25 % of the weight for each half side that C moves.
  shown.com_radius = 0.1;
  CHECK(kept("capacity, max<=25, max<=33, min>=17, min>=25") == "--++-");
  shown.com_radius = 0.6;  // beyond the lifting base
  CHECK(kept("capacity, max<=100, min>=0, spread<=0") == "---+");
  const Placement falls = placed(standing_on({{0, 0}}));
  for (const Requirement& requirement :
       check_conditions({falls, {}}, *read_conditions("max<=1000")))
    CHECK(requirement_in_words(requirement) == "max<=1000: no value, not kept");
  const Requirement missed{read_conditions("coverage>=0.8")->front(), 0.79999999, false};
  CHECK(requirement_in_words(missed) == "coverage>=0.8: 0.79999999, not kept");
  CHECK(value_in_words(missed, {}).starts_with("79.999999"));
  for (const char* bad : {"", ",", "held,", "hold", "held>=1", "max", "max<20", "max=<20", "max<=x",
                          "max<=20 held", "MAX<=20"}) {
    INFO(bad);
    const auto read = read_conditions(bad);
    REQUIRE_FALSE(read.ok());
    CHECK(read.error().message.find("coverage>=0.8") != std::string::npos);
  }
  std::string many = "held";
  for (std::size_t i = 1; i < most_conditions; ++i) many += ",held";
  CHECK(read_conditions(many).ok());
  CHECK(read_conditions(many + ",held").error().message == "there are more than 100 conditions");
}

TEST_CASE(
    "robots to be placed stand apart enough to be told from each other, wherever that is possible",
    "[supports]") {
  int apart = 0, samples = 0;
  for (const std::string& name : corpus::polygon_names()) {
    const Placement placement = placed(corpus::polygon(name));
    const double diameter = placement.polygon().diameter();
    const Points supports = supports_to_place(placement.object, placement.centre_of_mass, 4, {});
    REQUIRE(supports.size() == 4);
    double least = diameter;
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = 0; j < i; ++j)
        least = std::min(least, length(supports[i] - supports[j]));
    ++samples;
    apart += least >= 0.05 * diameter ? 1 : 0;
    if (name == "worktop") CHECK(least >= 0.05 * diameter);
  }
  INFO(apart << " of " << samples);
  CHECK(apart >= 0.7 * samples);
}
