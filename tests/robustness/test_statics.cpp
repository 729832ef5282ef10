// Sentences and numbers about slopes, braking, uneven ground and failures that were once false, and
// the examples that were worked out by hand for them.
#include <cmath>

#include "evenlift/capacity.h"
#include "evenlift/extra_load.h"
#include "evenlift/output/carrying_words.h"
#include "evenlift/output/requirements.h"
#include "evenlift/output/robustness_words.h"
#include "evenlift/output/svg.h"
#include "evenlift/output/verdict.h"
#include "evenlift/placed_robots.h"
#include "evenlift/tilt.h"
#include "kit/catch.h"
#include "kit/texts.h"

using namespace evenlift;
using evenlift::testing::plainly;

namespace {

// An object that stands on robots at its corners, with a weight of 100.
class Lifted {
 public:
  explicit Lifted(const Points& corners, const Points& more = {}) {
    document.vertices = corners;
    document.settings.method = Method::given;
    document.settings.supports = corners;
    for (const Vec2& support : more) document.settings.supports.push_back(support);
    placement = place(document).value();
  }

  ShownPlacement of() const { return {*placement, document.shown}; }
  Tilt tilt() const { return report_of(of()).tilt.value(); }
  std::vector<LoadRange> loads() const { return report_of(of()).planned; }
  bool may_let_go() const {
    return evenlift::may_let_go(LoadModel::plan, *placement,
                                model_loads(*placement, disturbance_of(document.shown)));
  }
  std::string sentences() const { return plainly(verdict(of())); }
  std::vector<std::optional<RestOfRobots>> failures() const {
    return single_failures(*placement, disturbance_of(document.shown));
  }
  std::string failures_in_words() const {
    return plainly(evenlift::failures_in_words({of(), Asked{.failures = true}}));
  }
  Requirement required(const char* condition) const {
    return check_conditions(of(), read_conditions(condition).value())[0];
  }
  Carrying& carrying() { return document.shown.carrying; }

  Document document;
  std::optional<Placement> placement;
};

const Points square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};

Points hexagon() {
  const double high = std::sqrt(0.75);
  return {{1, 0}, {0.5, high}, {-0.5, high}, {-1, 0}, {-0.5, -high}, {0.5, -high}};
}

}  // namespace

TEST_CASE("slope and braking together reach farther than their sum", "[tilt][statics]") {
  Lifted lifted(square);
  lifted.carrying() = {.com_height = 1.24, .slope = 0.1, .acceleration = 0.3};
  CHECK(lifted.tilt().reach == Approx(0.4979).epsilon(1e-4));
  CHECK(lifted.tilt().stays);
  lifted.carrying() = {.com_height = 0.49, .slope = 0.5, .acceleration = 0.5};
  CHECK(lifted.tilt().reach == Approx(0.5189).epsilon(1e-4));
  CHECK_FALSE(lifted.tilt().stays);
  CHECK(
      lifted.sentences().starts_with("On a slope of 50 %, braked at 0.5 g, it tips. On level "
                                     "ground and with C as given, 4 equally stiff robots carry "
                                     "25.0 kg each (100 kg in all)."));
  CHECK(judge(lifted.of()).kind == VerdictKind::bad);
  CHECK(
      plainly(placement_svg(lifted.of()))
          .find(
              "<desc id=\"evenlift-description\">On a slope of 50 %, braked at 0.5 g, it tips.") !=
      std::string::npos);
  // The ends of the loads' ranges are bounds with the sum.
  lifted.carrying() = {.com_height = 1, .slope = 0.2};
  CHECK(lifted.loads()[0].greatest == Approx(25 + 14.142).epsilon(1e-5));
  CHECK(lifted.loads()[0].least == Approx(0.980581 * 25 - 14.142136).epsilon(1e-5));
}

TEST_CASE("what is left on a slope, or when braked, is said", "[tilt][statics]") {
  Lifted lifted(square);
  lifted.carrying() = {.com_height = 1};
  CHECK_FALSE(lifted.tilt().acceleration_left);
  CHECK_FALSE(lifted.tilt().slope_left);
  const auto words = [&] { return plainly(tilt_in_words(lifted.of())); };
  const std::string alone =
      "In the worst direction it tips at a slope of 26.5° (50 %) or, on level ground, when it is "
      "braked at 0.5 g.";
  CHECK(words() == alone);
  lifted.carrying().slope = 0.4;
  CHECK(lifted.tilt().acceleration_left.value() == Approx(0.0928).epsilon(1e-3));
  CHECK(words() == alone + " On the slope of 40 % it tips when it is braked at 0.0928 g.");
  lifted.carrying() = {.com_height = 1, .acceleration = 0.3};
  CHECK(lifted.tilt().slope_left.value() == Approx(0.19438).epsilon(1e-4));
  CHECK(words() == alone + " Braked at 0.3 g, it tips at a slope of 19.4 %.");
  // What is left tips it, within rounding, and a hair less does not.
  for (const double k2 : {0.01, 0.3, 0.49}) {
    lifted.carrying() = {.com_height = 1, .acceleration = k2};
    lifted.carrying().slope = lifted.tilt().slope_left.value();
    CHECK(lifted.tilt().reach == Approx(0.5).epsilon(1e-12));
    CHECK(lifted.tilt().acceleration_left.value() == Approx(k2).epsilon(1e-12));
  }
  // Nothing is left beyond, also for large numbers.
  lifted.carrying() = {.com_height = 1, .slope = 0.6, .acceleration = 0.7};
  CHECK(lifted.tilt().acceleration_left == 0.0);
  CHECK(lifted.tilt().slope_left == 0.0);
  lifted.carrying() = {.com_height = 0.1, .acceleration = 1};
  CHECK(lifted.tilt().slope_left.value() == Approx(24.0 / 10));  // (D^2 - 1) / 2D for k2 = 1
}

TEST_CASE("uneven heights tilt the object", "[tilt][statics]") {
  Lifted lifted(square);
  lifted.carrying() = {.com_height = 1, .give = 1, .uneven = 0.1};
  CHECK(effect_on(lifted.of()).tilt == Approx(0.2));  // 2 uneven / side
  CHECK(lifted.tilt().reach == Approx(0.2));
  CHECK(lifted.tilt().slope == 0.5);  // alone
  CHECK(plainly(tilt_in_words(lifted.of()))
            .ends_with("With heights off by up to 0.1, it tips at a slope of 30 %."));
  lifted.carrying().uneven = 0.26;
  CHECK_FALSE(lifted.tilt().stays);
  CHECK(lifted.sentences().starts_with("With heights off by up to 0.26 it tips."));
  // Three robots, too.
  Lifted three({{0, 0}, {1, 0}, {0, 1}});
  three.carrying() = {.com_height = 1, .uneven = 0.1};
  CHECK(effect_on(three.of()).tilt > 0.2);
  // In any direction the sum is at most that of the zonotope's farthest corner.
  Lifted six(hexagon());
  six.carrying() = {.com_height = 1, .uneven = 1};
  double greatest = 0;
  for (int i = 0; i < 3600; ++i) {
    const double angle = i * std::acos(-1.0) / 1800;
    double sum = 0;
    for (const Vec2& corner : hexagon())
      sum += std::fabs(dot(corner, Vec2(std::cos(angle), std::sin(angle)))) / 3;
    greatest = std::max(greatest, sum);
  }
  CHECK(effect_on(six.of()).tilt == Approx(greatest).epsilon(1e-6));
}

TEST_CASE("least loads are bounds although robots go slack", "[tilt][statics]") {
  Lifted five(square, {{0.5, 0.5}});
  five.document.shown.com_radius = 0.45;
  CHECK(five.may_let_go());
  CHECK(five.loads()[4].least == 0);
  Lifted off(square);
  off.document.centre_of_mass = Vec2(0.25, 0.25);
  off.placement = place(off.document).value();
  off.carrying() = {.com_height = 0.3, .slope = 0.3, .acceleration = 0.5};
  CHECK(off.may_let_go());
  CHECK(off.loads()[0].least == Approx(14.487).epsilon(1e-4));
  CHECK(off.loads()[2].least == 0);
}

TEST_CASE("on a slope, less weight holds a robot down", "[tilt][statics]") {
  Lifted lifted(square);
  lifted.carrying() = {.slope = 0.5, .give = 1, .uneven = 0.95};
  CHECK(lifted.may_let_go());
  for (const LoadRange& load : lifted.loads()) {
    CHECK(load.least == 0);
    CHECK(load.greatest == Approx(50));
  }
  lifted.carrying() = {.slope = 0.5, .give = 1, .uneven = 0.5, .extra = 10};
  CHECK(extra_load(lifted.of())->anywhere.value() == Approx(44.0983).epsilon(1e-5));
}

TEST_CASE("uneven heights without a known give can do their worst", "[tilt][statics]") {
  Lifted lifted(square);
  lifted.carrying() = {.uneven = 5};
  CHECK(lifted.may_let_go());
  for (const LoadRange& load : lifted.loads()) {
    CHECK(load.least == 0);
    CHECK(load.greatest == Approx(50));
  }
  CHECK(lifted.sentences().starts_with(
      "4 equally stiff robots carry 0.0–50.0 kg each, with heights off by up to 5 (100 kg in all)."));
  lifted.carrying().extra = 10;
  CHECK(extra_load(lifted.of())->region.empty());
  CHECK(extra_load(lifted.of())->anywhere == 0.0);
  Lifted three({{0, 0}, {1, 0}, {0, 1}});
  three.carrying() = {.uneven = 5};
  CHECK_FALSE(three.may_let_go());
  CHECK(three.loads()[0].greatest == Approx(100.0 / 3));
}

TEST_CASE("what tips after a failure carries nothing", "[tilt][statics][failures]") {
  Lifted lifted(hexagon());
  lifted.carrying() = {.com_height = 1, .slope = 0.6};
  for (const auto& rest : lifted.failures()) {
    REQUIRE(rest);
    CHECK_FALSE(rest->stays);
    CHECK_FALSE(rest->greatest_end);
  }
  CHECK(lifted.failures_in_words() == "Whichever robot fails, it tips on a slope of 60 %.");
  const Requirement required = lifted.required("max_after_failure<=90");
  CHECK_FALSE(required.value);
  CHECK_FALSE(required.kept);
  lifted.carrying().slope = 0.4;
  CHECK(lifted.required("max_after_failure<=90").kept);
}

TEST_CASE("a plan for one failure asks whether the object stays upright", "[statics][capacity]") {
  Document document;
  document.vertices = {{0, 0}, {1000, 0}, {1000, 1000}, {0, 1000}};
  document.settings.teams = 2;
  document.shown.capacity = 60;
  const Placement placement = place(document).value();
  const auto plan = [&] { return plan_for_failures({placement, document.shown}, 60); };
  // With two teams, C is on the edge of what a failure leaves.
  CHECK(plan().possible);
  CHECK(plan().robots > 4);
  const auto stays = [&](std::uint32_t robots) {
    Document with = document;
    with.settings.teams = robots / 2;
    const Placement placed = place(with).value();
    const auto failures = single_failures(placed, disturbance_of(document.shown));
    return std::all_of(failures.begin(), failures.end(), [](const auto& rest) {
      return rest && rest->clear && rest->stays && *rest->greatest_end <= 60;
    });
  };
  CHECK(stays(plan().robots));
  CHECK_FALSE(stays(plan().robots - 2));
  document.shown.carrying = {.com_height = 200, .slope = 0.08};
  CHECK(stays(plan().robots));
  // No number stands on a slope that is too steep for robots all around.
  document.shown.carrying = {.com_height = 2000, .slope = 0.6};
  CHECK_FALSE(plan().possible);
  CHECK(plan().can_tip);
  Report report = report_of({placement, document.shown});
  report.if_one_fails = plan();
  CHECK(
      plainly(needs_in_words({{placement, document.shown}, report})) ==
      "To allow for any one failure: 4 robots, at most 50.0 kg each at rest if equally stiff, but "
      "the object can then tip.");
}

TEST_CASE("a plan names only numbers that were tried", "[statics][capacity]") {
  Document document;
  document.vertices = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  document.settings.teams = 2;
  document.shown.capacity = 5;
  const Placement placement = place(document).value();
  REQUIRE(placement.candidates.size() == 4);
  // It would take 22 robots, and only eight can be placed.
  const FailurePlan plan = plan_for_failures({placement, document.shown}, 5);
  CHECK_FALSE(plan.possible);
  CHECK(plan.tried == 0);
  Report report = report_of({placement, document.shown});
  report.if_one_fails = plan;
  CHECK(needs_in_words({{placement, document.shown}, report}) ==
        "No number of robots was found to allow for any one failure.");
}

TEST_CASE("greatest ends of ranges can be exceeded, but not all at once", "[statics][words]") {
  Lifted lifted(hexagon());
  lifted.document.shown.capacity = 20;
  lifted.carrying() = {.com_height = 0.3, .slope = 0.6};
  const Judgement judgement = judge(lifted.of());
  CHECK(judgement.kind == VerdictKind::bad);
  CHECK(plainly(judgement.reasons.front()) ==
        "All 6 robots can be overloaded, with more than 20 kg.");
  CHECK(lifted.sentences().starts_with(
      "All 6 robots can be overloaded, with more than 20 kg. 6 equally stiff robots carry "));
  lifted.carrying() = {};
  lifted.document.shown.capacity = 10;
  CHECK(plainly(judge(lifted.of()).reasons.front()) ==
        "All 6 robots are overloaded, with more than 10 kg.");
}

TEST_CASE("a floor that is not even is the second thing that given supports say",
          "[statics][words]") {
  Lifted lifted({{0, 0}, {3, 0}, {3, 1}, {0, 1}});
  lifted.document.centre_of_mass = Vec2(1, 0.5);
  lifted.placement = place(lifted.document).value();
  const std::string level = "4 equally stiff robots carry 16.7–33.3 kg each (100 kg in all). ",
                    high = "If one of them stands a little high, robots 1 and 4 can come to carry ";
  CHECK(lifted.sentences().starts_with(level + high + "50.0 kg. "));
  lifted.document.shown.capacity = 40;
  CHECK(capacity_in_words(lifted.of()).empty());  // not that none carries more
  CHECK(lifted.sentences().starts_with(
      level + high +
      "50.0 kg. 2 of 4 robots can be overloaded, with more than 40 kg: robots 1 and 4. "));
  CHECK(lifted.required("worst<=50").kept);
  CHECK_FALSE(lifted.required("worst<=49.9").kept);
  CHECK(lifted.required("worst<=50").value.value() == Approx(50));
  lifted.carrying() = {.com_height = 0.1, .slope = 0.2};
  CHECK(lifted.required("worst<=60").value.value() > 50.1);
  lifted.carrying() = {.com_height = 10, .slope = 0.2};
  CHECK_FALSE(lifted.required("worst<=100").value);  // it tips
  // Nobody can be high among three.
  Lifted three({{0, 0}, {1, 0}, {0, 1}});
  CHECK(three.sentences().find("little high") == std::string::npos);
}

TEST_CASE("a press tips sooner on a slope", "[statics][stability]") {
  Lifted lifted({{-1, 0}, {2, 0}, {2, 1}, {-1, 1}});
  lifted.document.settings.supports = square;
  lifted.placement = place(lifted.document).value();
  CHECK(tipping_force(lifted.of(), {1.1, 0.5}) == Approx(500));
  CHECK(std::isinf(tipping_force(lifted.of(), {0.5, 0.5})));
  lifted.carrying() = {.com_height = 1, .slope = 0.4};
  CHECK(tipping_force(lifted.of(), {1.1, 0.5}) == Approx(100));
  CHECK(std::isinf(tipping_force(lifted.of(), {0.5, 0.5})));
  lifted.carrying().slope = 0.6;
  CHECK(tipping_force(lifted.of(), {1.1, 0.5}) == 0);
  CHECK(tipping_force(lifted.of(), {0.5, 0.5}) == 0);
}

TEST_CASE("limits are rounded so that they stay true", "[words]") {
  CHECK(amount(276.66, 276.66, Toward::down) == "276");
  CHECK(amount(276.1, 276.1, Toward::up) == "277");
  CHECK(amount(45.158, 45.158, Toward::down) == "45.1");
  CHECK(significant(27.87, 3, Toward::down) == "27.8");
  CHECK(significant(27.81, 3, Toward::up) == "27.9");
  // What only rounding puts beyond a decimal is that decimal.
  CHECK(amount(0.1 + 0.2, 0.3, Toward::up) == "0.300");
  CHECK(amount(100.0 / 3 * 3 - 1e-14, 100, Toward::down) == "100");
  CHECK(amount(0, 0, Toward::down) == "0");
  CHECK(amount(0, 50, Toward::up) == "0.0");
  CHECK(amount(1e-30, 50, Toward::up) == "0.1");
  CHECK(amounts(LoadRange{15.26, 18.11}, 18.11) == "15.2–18.2");
  CHECK(amounts(LoadRange{15.26, 15.26}, 18.11) == "15.3");
}
