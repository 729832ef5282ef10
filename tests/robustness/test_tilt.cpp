#include "evenlift/tilt.h"

#include <cmath>

#include "evenlift/angles.h"
#include "evenlift/extra_load.h"
#include "evenlift/failures.h"
#include "evenlift/output/carrying_words.h"
#include "evenlift/output/requirements.h"
#include "evenlift/output/svg.h"
#include "evenlift/output/verdict.h"
#include "evenlift/placed_robots.h"
#include "evenlift/settings.h"
#include "kit/catch.h"
#include "kit/texts.h"

using namespace evenlift;
using evenlift::testing::occurrences;
using evenlift::testing::plainly;

namespace {

// Of side 1 with robots at the corners, and a weight of 100.
Document square() {
  Document document;
  document.vertices = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  document.settings.method = Method::given;
  document.settings.supports = document.vertices;
  return document;
}

Placement placed(const Document& document) { return place(document).value(); }

std::optional<Tilt> tilt_of(const Placement& placement, const Shown& shown) {
  return report_of({placement, shown}).tilt;
}

}  // namespace

TEST_CASE("an object tips at the slope at which its weight leaves the lifting base", "[tilt]") {
  Document document = square();
  document.shown.carrying.com_height = 1;
  const Placement placement = placed(document);
  const auto tilt = tilt_of(placement, document.shown);
  REQUIRE(tilt);
  CHECK(tilt->slope == 0.5);
  CHECK(tilt->acceleration == 0.5);
  CHECK(tilt->degrees == Approx(26.565).epsilon(1e-5));
  CHECK(tilt->reach == 0);
  CHECK(tilt->stays);

  document.shown.carrying.slope = 0.5;
  CHECK(tilt_of(placement, document.shown)->reach == 0.5);
  CHECK(tilt_of(placement, document.shown)->stays);  // on the edge within tolerance
  document.shown.carrying.slope = 0.3;
  document.shown.com_radius = 0.21;
  CHECK_FALSE(tilt_of(placement, document.shown)->stays);
  document.shown.com_radius = 0.1;
  document.shown.carrying.acceleration = 0.2;
  const auto off = tilt_of(placement, document.shown);
  CHECK_FALSE(off->stays);
  CHECK(off->slope == Approx(0.4));
  document.shown.com_radius = 2;
  CHECK(tilt_of(placement, document.shown)->slope == 0);
  CHECK_FALSE(tilt_of(placement, document.shown)->stays);
  document.shown.carrying.com_height = 0;
  CHECK_FALSE(tilt_of(placement, document.shown));
}

TEST_CASE("an object that falls on level ground does not stay upright", "[tilt]") {
  Document document = square();
  document.settings.supports = {{0, 0}, {0.2, 0}, {0, 0.2}};
  document.shown.carrying.com_height = 1;
  const auto tilt = tilt_of(placed(document), document.shown);
  REQUIRE(tilt);
  CHECK_FALSE(tilt->stays);
  CHECK(tilt->slope == 0);
}

TEST_CASE("each direction has its own slope", "[tilt]") {
  const Points hull{{0, 0}, {4, 0}, {4, 2}, {0, 2}};
  Shown shown;
  shown.carrying.com_height = 2;
  CHECK(tipping_slope(hull, {1, 1}, {3, 0}, shown) == 1.5);
  CHECK(tipping_slope(hull, {1, 1}, {-1, 0}, shown) == 0.5);
  CHECK(tipping_slope(hull, {1, 1}, {0, 1}, shown) == 0.5);
  CHECK(tipping_slope(hull, {1, 1}, {1, 1}, shown) == Approx(std::sqrt(2) / 2));
  shown.com_radius = 0.5;
  CHECK(tipping_slope(hull, {1, 1}, {3, 0}, shown) == 1.25);
  CHECK(tipping_slope({{0, 0}, {4, 0}}, {1, 0}, {1, 0}, shown) == 0);
}

TEST_CASE("slopes are ratios, percentages or angles", "[tilt][settings]") {
  const auto read = [](const char* text) -> std::optional<double> {
    Document document;
    if (read_setting(Setting::slope, text, document)) return std::nullopt;
    return document.shown.carrying.slope;
  };
  CHECK(read("0.08") == 0.08);
  CHECK(read("8%") == 0.08);
  CHECK(read("100%") == 1.0);
  CHECK(read("45deg") == 1.0);
  CHECK(read("4.6deg").value() == Approx(std::tan(4.6 * pi / 180)).epsilon(1e-14));
  CHECK(read("0deg") == 0.0);
  CHECK(read("8 %") == 0.08);
  CHECK(read("45 deg") == 1.0);
  CHECK(read("45\u00B0") == 1.0);
  for (const char* wrong :
       {"8", "101%", "45.1deg", "90deg", "-1%", "-1deg", "%", "deg", " 8%", "8 % ", "x"})
    CHECK_FALSE(read(wrong));
  for (const double degrees : {0.0, 1e-9, 10.0, 30.0, 45.0, 60.0, 89.9})
    CHECK(slope_degrees(slope_ratio(degrees)) == Approx(degrees).epsilon(1e-12));
}

TEST_CASE("accelerations are in g, or have their unit", "[tilt][settings]") {
  const auto read = [](const char* text) -> std::optional<double> {
    Document document;
    if (read_setting(Setting::acceleration, text, document)) return std::nullopt;
    return document.shown.carrying.acceleration;
  };
  CHECK(read("0.2") == 0.2);
  CHECK(read("0.2g") == 0.2);
  CHECK(read("9.80665 m/s2") == 1.0);
  CHECK(read("4.903325m/s\u00B2") == 0.5);
  for (const char* wrong : {"g", "m/s2", "1 m/s", "-1g", "1000 m/s2"}) CHECK_FALSE(read(wrong));
}

TEST_CASE("where another load may stand", "[tilt][extra]") {
  Document document = square();
  document.shown.carrying.extra = 50;
  const Placement placement = placed(document);
  const auto free = extra_load({placement, document.shown});
  REQUIRE(free);
  CHECK(free->share == Approx(1));
  CHECK(free->anywhere.value() == Approx(100));
  document.shown.capacity = 50;
  const auto bounded = extra_load({placement, document.shown});
  CHECK(bounded->share == Approx(0.5));
  CHECK(bounded->anywhere.value() == Approx(100.0 / 3));
  CHECK(bounded->region.size() == 4);
  for (const Vec2& corner : bounded->region)
    CHECK(std::fabs(corner.x - 0.5) + std::fabs(corner.y - 0.5) == Approx(0.5));
  document.shown.carrying.uneven = 1;  // changes each load by 6.25
  document.shown.carrying.give = 4;
  CHECK(extra_load({placement, document.shown})->anywhere.value() == Approx(25));
  document.shown.carrying.uneven = 0;
  document.shown.capacity = 20;  // overloaded without it
  CHECK(extra_load({placement, document.shown})->region.empty());
  CHECK(extra_load({placement, document.shown})->anywhere == 0.0);
  document.shown.carrying.extra.reset();
  CHECK_FALSE(extra_load({placement, document.shown}));
}

TEST_CASE("three robots at the corners bear any load on the triangle between them",
          "[tilt][extra]") {
  Document document;
  document.vertices = {{0, 0}, {3, 0}, {0, 3}};
  document.settings.method = Method::given;
  document.settings.supports = document.vertices;
  document.shown.carrying.extra = 1000;
  const auto extra = extra_load({placed(document), document.shown});
  CHECK(extra->share == Approx(1));
  CHECK_FALSE(extra->anywhere);
  // Nothing has a place beside a line of robots.
  document.settings.supports = {{0, 1}, {2, 1}};
  const auto on_line = extra_load({placed(document), document.shown});
  REQUIRE(on_line);
  CHECK(on_line->region.empty());
  CHECK(on_line->anywhere == 0.0);
}

TEST_CASE("slopes and another load are told in sentences", "[tilt][words]") {
  Document document = square();
  document.shown.carrying.com_height = 1;
  document.shown.units.length = LengthUnit::m;
  const Placement placement = placed(document);
  const auto tips = [&] { return plainly(tipping_in_words({placement, document.shown})); };
  CHECK(plainly(tilt_in_words({placement, document.shown})) ==
        "In the worst direction it tips at a slope of 26.5° (50 %) or, on level ground, when it is "
        "braked at 0.5 g.");
  CHECK(tips().empty());
  document.shown.carrying.slope = 0.6;
  CHECK(tips() == "On a slope of 60 % it tips.");
  const Judgement judgement = judge({placement, document.shown});
  CHECK(judgement.kind == VerdictKind::bad);
  CHECK(plainly(judgement.reasons.front()) == "On a slope of 60 % it tips.");
  document.shown.carrying.acceleration = 0.1;
  CHECK(tips() == "On a slope of 60 %, braked at 0.1 g, it tips.");
  document.shown.com_radius = 0.02;
  document.shown.carrying.slope = 0;
  document.shown.carrying.acceleration = 0.5;
  CHECK(tips() == "With C off by up to 0.02 m, braked at 0.5 g on level ground, it tips.");
  document.shown.carrying = {.extra = 50};
  document.shown.com_radius = 0;
  const auto extra = [&] {
    const ShownPlacement of{placement, document.shown};
    return plainly(extra_in_words(of));
  };
  CHECK(
      extra() ==
      "Another 50 kg may stand anywhere on the object without lifting a robot off, if all robots are equally stiff and level and the object does not bend.");
  document.shown.capacity = 50;
  CHECK(
      extra() ==
      "Another 50 kg may stand on 50 % of the object without lifting a robot off or overloading "
      "one, if all robots are equally stiff and level and the object does not bend. Up to 33.3 kg may stand anywhere on it.");
  const ShownPlacement of{placement, document.shown};
  CHECK(plainly(extra_here_in_words(*extra_load(of), {0.5, 0.5}, of).words) ==
        "50 kg here: robots carry 37.5 kg");
  CHECK(extra_here_in_words(*extra_load(of), {0.5, 0.5}, of).is_fine);
  CHECK(plainly(extra_here_in_words(*extra_load(of), {0, 0}, of).words) ==
        "50 kg here: robots carry 12.5–62.5 kg · overloaded: robot 1");
  CHECK_FALSE(extra_here_in_words(*extra_load(of), {0, 0}, of).is_fine);
  CHECK(plainly(extra_here_in_words({500}, {5, 5}, of).words) == "500 kg here tips it");
}

TEST_CASE("a height next to nothing tips at no slope, and says so without overflow", "[tilt]") {
  Document document = square();
  document.shown.carrying.com_height = 5e-324;
  const Placement placement = placed(document);
  const auto tilt = tilt_of(placement, document.shown);
  CHECK(tilt->degrees == 90);
  CHECK(std::isfinite(100 * tilt->slope));
  CHECK_FALSE(tilt_in_words({placement, document.shown}).empty());
}

TEST_CASE("after a failure uneven heights change loads by as much weight as before", "[tilt]") {
  Document document = square();
  document.settings.supports.push_back({0.5, 0});
  const Placement placement = placed(document);
  const auto rests = single_failures(placement.object, placement.centre_of_mass, 100,
                                     placement.teams, 0, {.uneven = 1, .give = 4});
  REQUIRE(rests.size() == 5);
  // A quarter of the mean load of five robots, 20, on top of a quarter of the weight.
  CHECK(rests[4]->greatest_by_springs == Approx(25));
  CHECK(rests[4]->greatest_end == Approx(25 + 5));
}

TEST_CASE("what is given in part is said", "[tilt][words]") {
  Document document = square();
  const Placement placement = placed(document);
  Shown& shown = document.shown;
  const auto words = [&] { return plainly(given_in_part_in_words({placement, shown})); };
  CHECK(words().empty());
  shown.carrying.acceleration = 0.1;
  CHECK(words() == "The acceleration changes nothing without the height of the centre of mass.");
  shown.carrying = {.slope = 0.14};
  CHECK(words() ==
        "Without the height of the centre of mass, a slope counts only because less of the weight "
        "acts across it: whether the object tips on it is not known.");
  shown.carrying = {.uneven = 2};
  CHECK(words() ==
        "Without the give of the robots, the loads can reach those at worst, up to 50.0 kg.");
  shown.carrying.give = 4;
  CHECK(words().empty());
  // Three robots stand on any ground.
  document.settings.supports.pop_back();
  shown.carrying = {.uneven = 2};
  CHECK(given_in_part_in_words({placed(document), shown}).empty());
}

TEST_CASE("a slope at which it tips can be required", "[tilt][requirements]") {
  Document document = square();
  const Placement placement = placed(document);
  const auto kept = [&](const char* condition) {
    return check_conditions({placement, document.shown}, read_conditions(condition).value())[0]
        .kept;
  };
  CHECK_FALSE(kept("tip>=1"));  // the height of C is not known
  document.shown.carrying.com_height = 1;
  CHECK(kept("tip>=26.5"));
  CHECK_FALSE(kept("tip>=26.6"));
}

TEST_CASE("an object is steady on a slope if it stays upright there after any one failure",
          "[tilt][requirements]") {
  Document document = square();
  document.settings.supports = {{0, 0}, {0.5, 0}, {1, 0}, {1, 0.5},
                                {1, 1}, {0.5, 1}, {0, 1}, {0, 0.5}};
  const Placement placement = placed(document);
  const auto steady = [&](double slope) {
    document.shown.carrying = {};
    document.shown.carrying.com_height = 1;
    document.shown.carrying.slope = slope;
    return check_conditions({placement, document.shown}, read_conditions("steady").value())[0].kept;
  };
  // Without a corner, C is sqrt(1/8) = 0.354 inside the others' base.
  CHECK(steady(0));
  CHECK(steady(0.35));
  CHECK_FALSE(steady(0.36));
}

TEST_CASE("a picture has the loads on a slope, and marks those above the capacity", "[tilt][svg]") {
  Document document = square();
  document.shown.capacity = 30;
  const Placement placement = placed(document);
  const auto count = [&](const std::string& words) {
    return occurrences(placement_svg({placement, document.shown}), words);
  };
  CHECK(count("class=\"load\"") == 4);
  CHECK(count(">25.0") == 4);
  document.shown.carrying.com_height = 1;
  document.shown.carrying.slope = 0.2;  // 25 ± 14.1, and on a slope the least is a little less
  CHECK(count("class=\"load overload\"") == 4);
  CHECK(count(">10.3–39.2") == 4);
}
