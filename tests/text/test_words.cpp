// The one formatter for all text that users read.
#include "evenlift/output/quantities.h"
#include "evenlift/output/words.h"

#include <cmath>

#include "evenlift/import.h"
#include "evenlift/output/json.h"
#include "evenlift/random.h"
#include "evenlift/settings.h"
#include "evenlift/swaps.h"
#include "kit/catch.h"
#include "kit/corpus.h"
#include "kit/polygons.h"
#include "kit/solid.h"
#include "kit/texts.h"

using namespace evenlift;
using evenlift::testing::plainly;

namespace {

Team bearing(double load1, double load2) { return {{{{}, 0, load1}, {{}, 0, load2}}, 1}; }

Placement nothing_placed() { return Placement(solid(testing::polygon(testing::square))); }

Placement three_teams() {
  Placement placement = nothing_placed();
  placement.requested_teams = 3;
  placement.teams.resize(3);
  for (Team& team : placement.teams) team = bearing(15.24, 18.06);
  // A wide base around C.
  placement.lifting_base = {{-3, -3}, {6, -3}, {6, 6}, {-3, 6}};
  for (std::size_t i = 0; i < placement.teams.size(); ++i)
    for (std::size_t end = 0; end < 2; ++end)
      placement.teams[i].robots[end].point.position =
          placement.lifting_base[std::min<std::size_t>(2 * i + end, 3)];
  placement.coverage = 0.814;
  placement.loads = LoadSummary{15.24, 100.0 / 6, 18.06, 2.82, 0.54};
  placement.closure.margin = -0.1;
  placement.closure.translation_free = false;
  placement.closure.clockwise.exists = true;
  return placement;
}

}  // namespace

TEST_CASE("marked parts of the boundary are named while they are few", "[words]") {
  CHECK(no_go_in_words({}).empty());
  CHECK(plainly(no_go_in_words({{2, 0, 1}})) == "No robot touches edge 3.");
  CHECK(plainly(no_go_in_words({{0, 0.3088, 0.7576}, {2, 0, 1}})) ==
        "No robot touches edge 1 between 31 % and 76 % of its length, nor edge 3.");
  CHECK(no_go_in_words(std::vector<EdgePart>(4)) ==
        "No robot touches the 4 no-go parts of the boundary.");
}

TEST_CASE("the verdict is a few plain sentences", "[words]") {
  Placement placement = three_teams();
  CHECK(verdict(placement) ==
        "6 robots carry 15.2–18.1\u00A0kg each (100\u00A0kg in all). It can still turn clockwise. "
        "81\u00A0% of the object can be pressed down on without tipping it.");
  placement.coverage = 0.4;
  CHECK(
      plainly(detail_in_words(placement)) ==
      "Only 40 % of the object, less than half, can be pressed down on without tipping it. It can still turn clockwise.");
  placement.requested_teams = 5;
  placement.loads = LoadSummary{16.66, 16.66, 16.66, 0, 0.5};
  CHECK(plainly(loads_in_words(placement)) == "6 robots carry 16.7 kg each (100 kg in all).");
  CHECK(shortage_in_words(placement) ==
        "There is room for only 3 of 5 teams at this minimum load ratio.");
  placement.settings.method = Method::random;
  CHECK(shortage_in_words(placement) == "There is room for only 3 of 5 teams.");
}

TEST_CASE("units are labels in words and JSON, and change no number", "[words][json][units]") {
  Document document;
  document.vertices = {{0, 0}, {4, 0}, {4, 3}, {0, 3}};
  const std::string usual = placement_json(*place(document), true), kept = document_json(document);
  const Units units = document.shown.units = {LengthUnit::cm, WeightUnit::N};
  CHECK(plainly(loads_in_words({three_teams(), document.shown})) ==
        "6 robots carry 15.2–18.1 N each (100 N in all).");
  CHECK(with_length_unit("2.5", units) == "2.5\u00A0cm");
  CHECK(with_length_unit("2.5", {}) == "2.5");
  std::string labelled = placement_json({*place(document), document.shown}, true);
  for (const std::string line : {"  \"unit\": \"cm\",\n", "  \"weight_unit\": \"N\",\n"}) {
    REQUIRE(labelled.find(line) != std::string::npos);
    labelled.erase(labelled.find(line), line.size());
  }
  CHECK(labelled == usual);
  CHECK(kept.find("unit") == std::string::npos);
  const auto read = read_shapes(document_json(document));
  REQUIRE(read.ok());
  CHECK(read->shapes[0].document.shown == document.shown);
}

TEST_CASE("holes and cargo are named only where there are any", "[words][holes][cargo]") {
  Placement placement = three_teams();
  CHECK(weight_in_words(placement) == "100\u00A0kg");
  CHECK(plainly(loads_in_words(placement)) == "6 robots carry 15.2–18.1 kg each (100 kg in all).");
  CHECK(outline_in_words(placement.object) == "4 vertices");
  placement.settings.weight = 96;
  placement.settings.cargo = {{{0, 0}, 20, "motor"}, {{1, 0}, 4, ""}};
  CHECK(weight_in_words(placement) == "120\u00A0kg with its cargo of 24\u00A0kg");
  CHECK(plainly(loads_in_words(placement)) ==
        "6 robots carry 15.2–18.1 kg each (120 kg with its cargo of 24 kg).");
  const Polygon plate = testing::polygon({{0, 0}, {10, 0}, {10, 10}});
  CHECK(outline_in_words(*PolygonWithHoles::create(plate, {{{5, 1}, {6, 1}, {6, 2}}})) ==
        "3 vertices, 1 hole");
}

TEST_CASE("with no team the reason is given, and what helps", "[words]") {
  Placement placement = nothing_placed();
  placement.requested_teams = 3;
  CHECK(verdict(placement) ==
        "No team can be placed. The centre of mass is outside the object, beyond all places for "
        "robots.");
  placement.centre_of_mass = placement.polygon().centroid();
  CHECK(verdict(placement) ==
        "No team can be placed. No chord through the centre of mass meets the minimum load ratio. "
        "Lower the minimum, or move the centre of mass.");
  placement.settings.method = Method::distributed;
  CHECK(
      verdict(placement) ==
      "No team can be placed. No line through the centre of mass meets the boundary on both sides "
      "of it.");
}

TEST_CASE("on what part of the object a push does not tip it is said in words", "[words]") {
  Placement placement = three_teams();
  const auto coverage = [&](double share) {
    placement.coverage = share;
    return plainly(coverage_in_words(placement));
  };
  CHECK(coverage(0.5) == "50 % of the object can be pressed down on without tipping it.");
  CHECK(coverage(1) == "Pressing down anywhere on the object does not tip it.");
  CHECK(coverage(1 - 1e-12) == "Pressing down anywhere on the object does not tip it.");
  CHECK(coverage(0.999) ==
        "More than 99 % of the object can be pressed down on without tipping it.");
  CHECK(coverage(0.004) ==
        "Less than 1 % of the object can be pressed down on without tipping it.");
  CHECK(coverage(0) == "Pressing down anywhere on the object can tip it.");
  CHECK(coverage(1e-12) == "Pressing down anywhere on the object can tip it.");
  placement.lifting_base.resize(2);
  CHECK(coverage(0) == "They stand on one line, so the object can tip.");
}

TEST_CASE("what can still move is named, and what holds the object", "[words]") {
  Placement placement = three_teams();
  placement.closure.translation_free = true;
  CHECK(closure_in_words(placement) == "It can still turn clockwise and slide.");
  placement.closure.counterclockwise.exists = true;
  CHECK(closure_in_words(placement) == "It can still turn either way and slide.");
  placement.closure.clockwise.exists = false;
  CHECK(closure_in_words(placement) == "It can still turn counter-clockwise and slide.");
  placement.closure.counterclockwise.exists = false;
  CHECK(closure_in_words(placement) == "It can still slide.");
  placement.closure.translation_free = false;
  placement.closure.second_order = true;
  CHECK(closure_in_words(placement) ==
        "It is held only to second order: any movement jams as soon as it begins.");
  placement.closure.form_closure = true;
  placement.closure.second_order = false;
  placement.closure.clearance = {100, 4, 12.9};
  CHECK(plainly(closure_in_words(placement)) ==
        "The robots hold it: it can neither slide nor turn, even without friction.");
  CHECK(is_held(placement));
  // A hold by a hair is unreliable.
  placement.settings.clear = 0.1;
  placement.closure.clearance = {0.0912, 4, 0.05};
  CHECK(
      plainly(closure_in_words(placement)) ==
      "It is held only as long as robot 5 stands accurately: it is only 0.091 units from a corner.");
  CHECK_FALSE(is_held(placement));
  placement.settings.clear = 0.09;
  CHECK(is_held(placement));
  placement.closure.clearance.tolerance = 0.0449;
  CHECK(plainly(closure_in_words(placement)) ==
        "It is held only as long as robots stand within 0.044 units of their places.");
  CHECK_FALSE(is_held(placement));
  placement.closure = {};
  placement.closure.margin.reset();
  CHECK(closure_in_words(placement) ==
        "All robots stand on corners, where contacts are not counted: nothing else keeps it from "
        "sliding or turning.");
}

TEST_CASE("a capacity names the robots that are overloaded and the robots that are needed",
          "[words][capacity]") {
  Placement placement = three_teams();
  const auto words = [&](double capacity, const CapacityPlan* plan = nullptr) {
    Shown shown;
    shown.capacity = capacity;
    Report report = report_of({placement, shown});
    if (plan) report.plan = *plan;
    return plainly(capacity_in_words({{placement, shown}, report}));
  };
  CHECK(words(18.06) == "No robot carries more than 18.06 kg.");
  CHECK(words(16) == "3 of 6 robots are overloaded, with more than 16 kg: robots 2, 4 and 6.");
  CHECK(words(15) == "All 6 robots are overloaded, with more than 15 kg.");
  placement.teams[0] = placement.teams[2] = bearing(16, 16);
  CHECK(words(17) == "1 of 6 robots is overloaded, with more than 17 kg: robot 4.");
  CapacityPlan plan{true, 4, 12.48, 4};
  CHECK(
      words(20, &plan) ==
      "No robot carries more than 20 kg. Considering load only, this method needs 8 robots, with at most 12.5 kg each.");
  placement.settings.method = Method::balanced;  // whose places are not tried
  CHECK(
      words(20, &plan) ==
      "No robot carries more than 20 kg. Considering load only, it takes 8 robots, with 12.5 kg each.");
  placement.settings.method = Method::area;
  plan = {false, 0, 0, 9};
  CHECK(words(20, &plan) ==
        "No robot carries more than 20 kg. Even all 18 robots that can be placed are too few.");
  plan.tried = most_teams_for_capacity;
  CHECK(words(20, &plan) == "No robot carries more than 20 kg. Even 1024 robots are too few.");
  // More teams may find room, but no more can be swapped for a hold.
  placement.settings.goal = Goal::hold;
  placement.candidates.assign(most_swaps / 10 + 1, Candidate{});
  plan.tried = 9;
  CHECK(words(20, &plan) == "No robot carries more than 20 kg. Even 18 robots are too few.");
  placement.candidates.clear();
  placement.settings.goal.reset();
  placement.teams.resize(12, bearing(30, 30));
  CHECK(words(17) ==
        "19 of 24 robots are overloaded, with more than 17 kg: robots 4, 7, 8, 9, 10, 11, 12 and "
        "12 more.");
}

TEST_CASE("a capacity says of which loads and of which robots it speaks", "[words][capacity]") {
  const Placement placement = three_teams();
  const CapacityPlan plan{true, 4, 12.48, 4}, none{false, 0, 0, 9};
  Shown shown;
  shown.capacity = 17;
  const auto words = [&](LoadModel model, const std::vector<std::size_t>& robots,
                         const CapacityPlan& needed, std::optional<std::size_t> failed = {}) {
    Report report = report_of({placement, shown});
    report.plan = needed;
    report.overloaded = robots;
    report.model = model;
    report.failed = failed;
    return plainly(capacity_in_words({{placement, shown}, report}));
  };
  CHECK(
      words(LoadModel::springs, {0, 3}, plan) ==
      "2 of 6 robots are overloaded, with more than 17 kg: robots 1 and 4. Considering load only, as planned, this method "
      "needs 8 robots, with at most 12.5 kg each.");
  CHECK(
      words(LoadModel::worst, {}, none) ==
      "No robot carries more than 17 kg. Considering load only, as planned, even all 18 robots that can be placed are too "
      "few.");
  // A failed robot carries nothing.
  CHECK(
      words(LoadModel::springs, {2, 3, 5}, plan, 1) ==
      "3 of the other 5 robots are overloaded, with more than 17 kg: robots 3, 4 and 6. Considering load "
      "only, with no failures, this method needs 8 robots, with at most 12.5 kg each.");
  CHECK(words(LoadModel::springs, {0, 2, 3, 4, 5}, plan, 1)
            .starts_with("All the other 5 robots are overloaded, with more than 17 kg. "));
}

TEST_CASE("loads that a model only bounds are not shown as if they were known", "[words]") {
  const LoadRange range{15.2, 18.06}, bound{18.06, 18.06};
  CHECK(plainly(load_in_words(LoadModel::plan, range, 20, {})) == "15.2–18.1 kg");
  CHECK(plainly(load_in_words(LoadModel::springs, bound, 20, {})) == "18.1 kg");
  CHECK(plainly(load_in_words(LoadModel::best, bound, 20, {})) == "≤ 18.1 kg");
  CHECK(plainly(load_in_words(LoadModel::worst, bound, 20, {})) == "≤ 18.1 kg");
}

TEST_CASE("a number is rounded as its shortest decimal, a half away from zero", "[words]") {
  CHECK(fixed(2.345, 2) == "2.35");  // its double is a little less
  CHECK(fixed(1.005, 2) == "1.01");
  CHECK(fixed(0.285, 2) == "0.29");
  CHECK(fixed(2.5, 0) == "3");
  CHECK(fixed(1234.5, 0) == "1235");
  CHECK(fixed(0.05, 1) == "0.1");
  CHECK(fixed(-1.5, 0) == "−2");
  CHECK(fixed(-2.345, 2) == "−2.35");
  CHECK(fixed(0.5, 0) == "1");
  CHECK(fixed(0.49999999999999994, 0) == "0");
  CHECK(fixed(999.995, 2) == "1000.00");
  CHECK(fixed(3, 9) == "3.000000000");
  CHECK(fixed(5e-324, 9) == "0.000000000");
  CHECK(fixed(123456789012345.6, 1) == "123456789012345.6");
  CHECK(fixed(1e20, 3) == "100000000000000000000");
  CHECK(fixed(1e300, 3) == "1e+300");
}

TEST_CASE("zero has no minus", "[words]") {
  CHECK(fixed(-0.0, 2) == "0.00");
  CHECK(fixed(-0.001, 2) == "0.00");
  CHECK(fixed(-0.005, 2) == "−0.01");
  CHECK(plain(-0.0) == "0");
  CHECK(plain(-0.5) == "−0.5");
  CHECK(significant(-0.0, 3) == "0");
  CHECK(given_point({-0.0, -2.5}) == "(0, −2.5)");
}

TEST_CASE("fixed decimals are within half a unit and keep the order of numbers", "[words][slow]") {
  Rng rng(3);
  for (int i = 0; i < 20000; ++i) {
    const int decimals = static_cast<int>(rng.below(7));
    const double a = (rng.uniform() - 0.3) * std::pow(10.0, static_cast<double>(rng.below(8)));
    const auto read = [&](double value) {
      std::string text = fixed(value, decimals);
      if (text.starts_with("−")) text.replace(0, std::string("−").size(), "-");
      return std::stod(text);
    };
    INFO(a << " with " << decimals << " decimals: " << fixed(a, decimals));
    CHECK(std::fabs(read(a) - a) <= 0.5 * std::pow(10.0, -decimals) * (1 + 1e-9) + 1e-9);
    CHECK(read(a) <= read(std::nextafter(a, 1e300)));
    CHECK(read(-a) == -read(a));
  }
}

TEST_CASE("values of a kind have three significant digits of the largest", "[words]") {
  CHECK(decimals_for(16.7) == 1);
  CHECK(decimals_for(100) == 0);
  CHECK(decimals_for(99.94) == 1);
  CHECK(decimals_for(99.95) == 0);
  CHECK(decimals_for(99.97) == 0);
  CHECK(decimals_for(9.995) == 1);
  CHECK(decimals_for(9.99) == 2);
  CHECK(decimals_for(0.0123) == 4);
  CHECK(decimals_for(-16.7) == 1);
  CHECK(decimals_for(0) == 0);
  CHECK(decimals_for(1e9) == 0);
  CHECK(decimals_for(1e-12) == 9);
  CHECK(amount(15.24, 18.06) == "15.2");
  CHECK(amount(0.5, 150) == "1");
  CHECK(amount(1.2345e-20, 2e-20) == "1.23e−20");
  CHECK(amount(1.2345e29, 1e30) == "1.23e+29");
  CHECK(amount(0, 0) == "0");
  CHECK(plainly(load_in_words(15.24, 18.06, 18.06, {})) == "15.2–18.1 kg");
  CHECK(plainly(load_in_words(18.04, 18.02, 18.04, {})) == "18.0 kg");
}

TEST_CASE("a weight that was converted has six digits, and all of its whole part", "[words]") {
  const Units units;
  CHECK(given_weight(100, units) == "100\u00A0kg");
  CHECK(given_weight(22.6796185, units) == "22.6796\u00A0kg");
  CHECK(given_weight(2.5, units) == "2.5\u00A0kg");
  CHECK(given_weight(12345678, units) == "12345678\u00A0kg");
  CHECK(given_weight(12345678.9, units) == "12345679\u00A0kg");
}

TEST_CASE("significant digits are rounded to, and zeros at the end are left out", "[words]") {
  CHECK(significant(0.0016666, 3) == "0.00167");
  CHECK(significant(1.6666e-21, 3) == "1.67e−21");
  CHECK(significant(123456, 3) == "123000");
  CHECK(significant(-9.996, 3) == "−10");
  CHECK(significant(2.5, 6) == "2.5");
  CHECK(given_point({12.4302, 340.15249}) == "(12.4302, 340.152)");
}

TEST_CASE("only nothing is 0 % and only all of it is 100 %", "[words]") {
  const auto percent = [](double share, int decimals = 0) {
    return plainly(percentage(share, decimals));
  };
  CHECK(percent(0) == "0 %");
  CHECK(percent(1e-10) == "0 %");  // within tolerance
  CHECK(percent(1e-8) == "< 1 %");
  CHECK(percent(0.004) == "< 1 %");
  CHECK(percent(0.005) == "1 %");
  CHECK(percent(0.0514) == "5 %");
  CHECK(percent(0.285) == "29 %");  // 28.499999999999996 in doubles
  CHECK(percent(0.814) == "81 %");
  CHECK(percent(0.994) == "99 %");
  CHECK(percent(0.995) == "> 99 %");
  CHECK(percent(0.99999) == "> 99 %");
  CHECK(percent(1) == "100 %");
  CHECK(percent(0.8144, 1) == "81.4 %");
  CHECK(percent(0.0004, 1) == "< 0.1 %");
  CHECK(percent(0.9996, 1) == "> 99.9 %");
  CHECK(percent(0.5, 1) == "50.0 %");
}

TEST_CASE("coordinates show where a point is on the object", "[words]") {
  CHECK(coordinate_decimals({{0, 0}, {724, 0}, {0, 892}}) == 1);
  CHECK(coordinate_decimals({{0, 0}, {1, 0}, {0, 1}}) == 3);
  CHECK(coordinate_decimals({{0, 0}, {1e-9, 0}, {0, 1e-9}}) == 9);
  CHECK(point_in_words({-3.25, 2}, 1) == "(−3.3, 2.0)");
}

TEST_CASE("an error is a sentence that begins with its place", "[words]") {
  InputError error{ErrorCode::edges_cross, "the edges cross", {Place::Kind::edge, 1, 6, {}}};
  CHECK(sentence(error) == "Edges 2 and 7 cross");
  error.message = "it ends here";
  CHECK(sentence(error) == "Edges 2 and 7: it ends here");
  error.place = {};
  CHECK(sentence(error) == "It ends here");
  error.place = {Place::Kind::option, 0, 0, "min_ratio"};
  CHECK(sentence(error) == "min_ratio: it ends here");
}

TEST_CASE("what is said of a setting does not name it twice", "[words]") {
  CHECK(sentence(setting_error(Setting::weight)) ==
        "The weight must be a number greater than 0, from 1e-100 to 1e100");
  CHECK(sentence(setting_error(Setting::goal)) == "The goal must be cover or hold");
  CHECK(sentence(setting_error(Setting::robot, "no edge has room for a robot of radius 9")) ==
        "No edge has room for a robot of radius 9");
  CHECK(sentence(setting_error(Setting::no_go, "there is no edge 9; the polygon has 4")) ==
        "There is no edge 9; the polygon has 4");
  const Place link{Place::Kind::link, 0, 0, {}}, character{Place::Kind::link, 7, 0, {}};
  CHECK(sentence({ErrorCode::bad_link, "the link is cut off", link}) == "The link is cut off");
  CHECK(sentence({ErrorCode::bad_link, "'.' cannot be in a link", character}) ==
        "Link, character 7: '.' cannot be in a link");
}

TEST_CASE("how firmly an object is held is a number only where it is held", "[words]") {
  const auto hold = [](const Closure& closure) {
    Placement placement = three_teams();
    placement.closure = closure;
    for (const Fact& fact : facts_in_words(placement))
      if (fact.label == std::string("Margin")) return fact.value;
    return std::string();
  };
  Closure closure;
  CHECK(hold(closure) == "not held");
  closure.margin = -0.058;
  CHECK(hold(closure) == "not held");
  closure.second_order = true;
  CHECK(hold(closure) == "by curvature alone");
  closure.second_order = false;
  closure.form_closure = true;
  closure.margin = 0.104;
  CHECK(hold(closure) == "0.104");
}

TEST_CASE("the facts of every sample have a label, a value and a meaning", "[words]") {
  for (const std::string& name : corpus::polygon_names()) {
    const Result<Placement> placement = place(corpus::polygon(name));
    REQUIRE(placement.ok());
    const std::vector<Fact> facts = facts_in_words(*placement);
    CHECK(facts.size() >= 6);
    for (const Fact& fact : facts) {
      CHECK_FALSE(std::string(fact.label).empty());
      CHECK_FALSE(fact.value.empty());
      CHECK_FALSE(std::string(fact.about).empty());
      CHECK(fact.value.find("nan") == std::string::npos);
    }
  }
}
