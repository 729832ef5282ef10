// The weight and C from readings (weighing.h), and how much of each robot is used.
#include "evenlift/weighing.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "evenlift/angles.h"
#include "evenlift/capacity.h"
#include "evenlift/cases.h"
#include "evenlift/import.h"
#include "evenlift/link.h"
#include "evenlift/load_models.h"
#include "evenlift/output/json.h"
#include "evenlift/output/requirements.h"
#include "evenlift/output/weighing_words.h"
#include "evenlift/placed_robots.h"
#include "evenlift/random.h"
#include "evenlift/request.h"
#include "evenlift/settings.h"
#include "evenlift/tilt.h"
#include "kit/catch.h"
#include "kit/json.h"
#include "kit/placed.h"
#include "kit/texts.h"

using namespace evenlift;
using evenlift::testing::Json;
using evenlift::testing::placed;
using evenlift::testing::plainly;

namespace {

const Points unit_square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};

Document weighed_on(const Points& supports, std::vector<double> readings,
                    const Points& vertices = unit_square) {
  Document document;
  document.vertices = vertices;
  document.settings.method = Method::given;
  document.settings.supports = supports;
  document.settings.weighed.readings = std::move(readings);
  return document;
}

Weighing weighing_of(const Document& document) {
  const Placement placement = placed(document);
  REQUIRE(placement.weighing);
  return *placement.weighing;
}

std::string refused(const Document& document) {
  const auto placement = place(document);
  return placement.ok() ? "placed"
                        : placement.error().place.option + ": " + placement.error().message;
}

// The greatest length of a sum of all vectors with either sign, by trying every choice.
double longest_by_trying(const Points& vectors) {
  double longest = 0;
  for (std::size_t signs = 0; signs < std::size_t{1} << vectors.size(); ++signs) {
    Vec2 sum;
    for (std::size_t i = 0; i < vectors.size(); ++i)
      sum += (signs >> i & 1) != 0 ? vectors[i] : -vectors[i];
    longest = std::max(longest, length(sum));
  }
  return longest;
}

Points random_supports(Rng& rng, std::size_t number) {
  Points supports = {{0.1, 0.1}, {0.9, 0.15}, {0.5, 0.9}};
  while (supports.size() < number)
    supports.push_back({0.01 + 0.98 * rng.uniform(), 0.01 + 0.98 * rng.uniform()});
  return supports;
}

}  // namespace

TEST_CASE("readings give the weight and C, and how well they are known", "[weighing]") {
  Document document = weighed_on(unit_square, {10, 20, 30, 40});
  Weighing found = weighing_of(document);
  CHECK(found.weight == 100);
  CHECK(found.centre == Vec2(0.5, 0.7));
  CHECK(found.radius == 0);
  document.settings.weighed.error = {1, 0};
  found = weighing_of(document);
  CHECK(found.weight_error == Approx(1));
  CHECK(found.radius == Approx(0.0051505).margin(5e-8));
  // The greatest shift of C need not be along an axis, and E bounds it.
  const Document thin =
      weighed_on({{0, 0}, {0, 0.1}, {10, 0}}, {1, 1, 98}, {{0, 0}, {10, 0}, {10, 1}, {0, 1}});
  Document thin_off = thin;
  thin_off.settings.weighed.error = {10, 0};
  const double radius = weighing_of(thin_off).radius;
  const Vec2 centre = weighing_of(thin).centre;
  double most = 0;
  for (int signs = 0; signs < 8; ++signs) {
    Document corner = thin;
    for (std::size_t i = 0; i < 3; ++i)
      corner.settings.weighed.readings[i] *= (signs >> i & 1) != 0 ? 1.1 : 0.9;
    most = std::max(most, length(weighing_of(corner).centre - centre));
  }
  CHECK(most == Approx(0.0434).margin(5e-5));
  CHECK(radius >= most);
}

TEST_CASE("any loads in balance give W and C back, and errors move C by at most E",
          "[weighing][property]") {
  Rng rng(58);
  for (int round = 0; round < 2000; ++round) {
    const std::size_t m = 3 + rng.below(6);
    const Points supports = random_supports(rng, m);
    std::vector<double> readings;
    double weight = 0;
    Vec2 moment;
    for (const Vec2& at : supports) {
      const bool carries = readings.size() < 3 || rng.below(3) > 0;
      readings.push_back(carries ? 1 + 99 * rng.uniform() : 0);
      weight += readings.back();
      moment += at * readings.back();
    }
    Document document = weighed_on(supports, readings);
    const bool is_part = rng.below(2) == 0;
    const double error = 0.3 * rng.uniform();
    document.settings.weighed.error =
        is_part ? ReadingError{100 * error, 0} : ReadingError{0, error};
    const Weighing found = weighing_of(document);
    CHECK(found.weight == Approx(weight).epsilon(1e-12));
    CHECK(length(found.centre - moment / weight) <= 1e-12);
    // E, by trying all signs, and C at every corner of the box of readings.
    Points arms;
    double errors = 0;
    for (std::size_t i = 0; i < m; ++i) {
      const double each = is_part ? error * readings[i] : error;
      arms.push_back((supports[i] - found.centre) * each);
      errors += each;
    }
    REQUIRE(found.radius == Approx(longest_by_trying(arms) / (weight - errors)).epsilon(1e-9));
    for (std::size_t signs = 0; signs < std::size_t{1} << m; ++signs) {
      Vec2 shifted;
      double sum = 0;
      for (std::size_t i = 0; i < m; ++i) {
        const double each = is_part ? error * readings[i] : error;
        const double reading = readings[i] + ((signs >> i & 1) != 0 ? each : -each);
        shifted += (supports[i] - found.centre) * reading;
        sum += reading;
      }
      REQUIRE(length(shifted / sum) <= found.radius * (1 + 1e-9));
    }
  }
}

TEST_CASE("supports that read nothing do not change how well C is known", "[weighing]") {
  const auto radius = [](const Points& supports, std::vector<double> readings) {
    Document document = weighed_on(supports, std::move(readings));
    document.settings.weighed.error = {1, 0};
    return weighing_of(document).radius;
  };
  const Points supports{{0, 0.9}, {0.6, 0.8}, {0.1, 0.3}, {0.3, 0.9}, {0.5, 0.8}};
  const double of_those_that_carry = radius({supports[0], supports[1], supports[4]}, {3, 2, 5});
  CHECK(radius(supports, {3, 2, 0, 0, 5}) == Approx(of_those_that_carry).epsilon(1e-12));
  CHECK(radius({supports[2], supports[4], supports[3], supports[0], supports[1]},
               {0, 5, 0, 3, 2}) == Approx(of_those_that_carry).epsilon(1e-12));
}

TEST_CASE("one object is weighed alike wherever it lies", "[weighing][property]") {
  Rng rng(5);
  for (int round = 0; round < 200; ++round) {
    const Points supports = random_supports(rng, 6);
    std::vector<double> readings;
    for (std::size_t i = 0; i < supports.size(); ++i) readings.push_back(10 * rng.uniform());
    Document document = weighed_on(supports, readings);
    document.settings.weighed.error = {2, 0};
    const Weighing before = weighing_of(document);
    const double angle = 6 * rng.uniform(), size = std::exp(10 * rng.uniform() - 5);
    const Vec2 shift(1e3 * size * rng.uniform(), -1e3 * size * rng.uniform());
    const auto moved = [&](const Vec2& p) {
      return shift + size * Vec2(cosine(angle) * p.x - sine(angle) * p.y,
                                 sine(angle) * p.x + cosine(angle) * p.y);
    };
    for (Vec2& vertex : document.vertices) vertex = moved(vertex);
    for (Vec2& support : document.settings.supports) support = moved(support);
    const Weighing after = weighing_of(document);
    CHECK(length(after.centre - moved(before.centre)) <= 1e-9 * size);
    CHECK(after.radius == Approx(size * before.radius).epsilon(1e-6));
    REQUIRE(after.residuals.size() == before.residuals.size());
    for (std::size_t i = 0; i < after.residuals.size(); ++i)
      CHECK(std::fabs(after.residuals[i] - before.residuals[i]) <= 1e-6 * before.weight);
  }
}

TEST_CASE("readings of equally stiff supports fit, and a wrong one is found", "[weighing]") {
  Document document = weighed_on(unit_square, {10, 20, 30, 40});
  Weighing found = weighing_of(document);
  const std::vector<double> expected{-5, 5, -5, 5};
  for (std::size_t i = 0; i < 4; ++i) CHECK(found.residuals[i] == Approx(expected[i]));
  ReadingsFit fit = fit_of(found, {});
  CHECK_FALSE(fit.fit);
  CHECK_FALSE(fit.suspect);  // each of the four may be wrong
  for (std::size_t i = 0; i < 4; ++i) CHECK(std::fabs(fit.too_little[i]) == Approx(20));
  CHECK(fit.too_little[0] > 0);
  // Uneven ground explains them, and so do large errors.
  CHECK(fit_of(found, {.give = 1, .uneven = 0.2}).fit);
  CHECK_FALSE(fit_of(found, {.give = 1, .uneven = 0.19}).fit);
  document.settings.weighed.error = {0, 5};
  CHECK(fit_of(weighing_of(document), {}).fit);
  document.settings.weighed.error = {0, 4.9};
  CHECK_FALSE(fit_of(weighing_of(document), {}).fit);

  // Loads by springs fit; then one of them reads too little.
  const Points six{{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0.5, 0}, {0.4, 1}};
  const auto springs = spring_loads(six, {0.45, 0.6}, std::sqrt(2), 600);
  REQUIRE(springs);
  document = weighed_on(six, springs->loads);
  found = weighing_of(document);
  CHECK(fit_of(found, {}).fit);
  CHECK(found.weight == Approx(600));
  CHECK(length(found.centre - Vec2(0.45, 0.6)) <= 1e-12);
  for (std::size_t wrong = 0; wrong < six.size(); ++wrong) {
    document.settings.weighed.readings = springs->loads;
    document.settings.weighed.readings[wrong] -= 20;
    fit = fit_of(weighing_of(document), {});
    CHECK_FALSE(fit.fit);
    REQUIRE(fit.suspect == wrong);
    CHECK(fit.too_little[wrong] == Approx(20));
  }
  // Three supports always fit.
  CHECK(weighing_of(weighed_on({{0, 0}, {1, 0}, {0.5, 1}}, {1, 2, 3})).residuals.empty());
}

TEST_CASE("a second weighing on a slope gives the height of C", "[weighing]") {
  Document document = weighed_on(unit_square, {10, 20, 30, 40});
  Weighed& weighed = document.settings.weighed;
  weighed.tilted = 0.1;
  weighed.heading = Vec2(0, 2);
  // C at a height of 0.5 moves downhill by 0.05.
  weighed.tilted_readings = {12.5, 22.5, 27.5, 37.5};
  auto height = weighing_of(document).height;
  REQUIRE(height);
  CHECK(height->height == Approx(0.5));
  CHECK(height->error == 0);
  CHECK(height->fits);
  weighed.error = {0, 0.1};
  height = weighing_of(document).height;
  CHECK(height->error == Approx(2 * weighing_of(document).radius / 0.1).epsilon(0.01));
  // Across the slope less of the weight presses.
  for (double& reading : weighed.tilted_readings) reading /= std::sqrt(1.01);
  CHECK(weighing_of(document).height->fits);
  CHECK(weighing_of(document).height->height == Approx(0.5));
  for (double& reading : weighed.tilted_readings) reading *= 0.9;
  CHECK_FALSE(weighing_of(document).height->fits);
  // Its upper end counts for tipping, unless a greater height is given.
  const Placement placement = placed(document);
  const double most = placement.weighing->height->height + placement.weighing->height->error;
  CHECK(ShownPlacement(placement, document.shown).shown.carrying.com_height == most);
  document.shown.carrying.com_height = 2;
  CHECK(ShownPlacement(placement, document.shown).shown.carrying.com_height == 2);
  // With an error of 5 in each of two weighings and 3°, the height is known within 191.
  Weighing vague;
  vague.height = Weighing::Height{100, (5 + 5) / slope_ratio(3), true};
  CHECK(vague.height->error == Approx(190.8).margin(0.05));
}

TEST_CASE("what readings tell takes the place of the weight, C and its uncertainty", "[weighing]") {
  Document document = weighed_on(unit_square, {10, 20, 30, 40});
  document.settings.weighed.error = {1, 0};
  document.settings.weighed.level_error = 0.02;
  document.settings.accuracy = 0.001;
  document.shown.carrying.com_height = 0.5;
  document.settings.cargo = {{{0, 0}, 20, "motor"}};
  const Placement placement = placed(document);
  CHECK(placement.weight() == 100);
  CHECK(placement.settings.weight == 80);
  CHECK(length(placement.centre_of_mass - Vec2(0.5, 0.7)) <= 1e-15);
  CHECK(length(placement.own_centre - Vec2(0.5, 0.7) / 0.8) <= 1e-15);  // it lies outside
  const double radius = 0.0051505 + 0.001 + 0.5 * 0.02;
  CHECK(ShownPlacement(placement, document.shown).shown.com_radius == Approx(radius).margin(5e-8));
  document.shown.com_radius = 0.1;
  CHECK(ShownPlacement(placement, document.shown).shown.com_radius == 0.1);

  // Taken over, the object is the same without readings, for any method.
  Document own = taken_over(document, *placement.weighing);
  CHECK(own.settings.weighed == Weighed{});
  const Placement again = placed(own);
  CHECK(again.weight() == Approx(100));
  CHECK(length(again.centre_of_mass - placement.centre_of_mass) <= 1e-15);
  own.settings.method = Method::area;
  CHECK(placed(own).centre_of_mass == again.centre_of_mass);

  // So it is after an edit with which the readings no longer apply.
  Document fewer = document;
  fewer.settings.supports.pop_back();
  const auto settled = settled_after_edit(fewer, document, *placement.weighing);
  REQUIRE(settled);
  CHECK(settled->settings.weighed == Weighed{});
  CHECK(settled->settings.weight == own.settings.weight);
  CHECK(settled->shown.carrying.weight_doubt > 0);
  CHECK(settled->shown.carrying == taken_over(document, *placement.weighing).shown.carrying);
  CHECK(settled->shown.com_radius == taken_over(document, *placement.weighing).shown.com_radius);

  // Evened-out supports have no readings yet.
  document.settings.cargo.clear();
  const auto even = with_even_supports(document);
  REQUIRE(even.ok());
  CHECK(even->settings.weighed.readings.empty());
  CHECK(*even->centre_of_mass == Vec2(0.5, 0.7));
}

TEST_CASE("readings that tell nothing are refused with the reason", "[weighing][refused]") {
  const std::string readings = "readings: ";
  CHECK(refused(weighed_on(unit_square, {1, 2, 3})) ==
        readings + "3 readings are given for 4 supports");
  CHECK(refused(weighed_on({{0, 0}, {1, 0}, {0.5, 0}}, {1, 2, 3})) ==
        readings +
            "the supports are on one line, so C is known along that line only: turn the object "
            "and weigh it again, or weigh with three supports");
  CHECK(refused(weighed_on({{0, 0}, {1, 1}}, {1, 2})).find("on one line") != std::string::npos);
  CHECK(refused(weighed_on({{0.5, 0.5}}, {1})) ==
        readings + "one support does not tell where C is: weigh with three or more");
  CHECK(refused(weighed_on(unit_square, {0, 0, 0, 0})) ==
        readings + "all readings are 0: nothing stands on the supports");
  CHECK(refused(weighed_on(unit_square, {5, 0, 0, 0})).find("at the edge") != std::string::npos);
  CHECK(refused(weighed_on(unit_square, {5, 7, 0, 0})).find("at the edge") != std::string::npos);
  CHECK(refused(weighed_on(unit_square, {-1, 7, 5, 5})).starts_with("readings: the readings must"));

  Document document = weighed_on(unit_square, {10, 20, 30, 40});
  document.centre_of_mass = Vec2(0.5, 0.5);
  CHECK(refused(document) ==
        "com: the readings give the centre of mass: leave it out, or the readings");
  document.centre_of_mass.reset();
  document.settings.weight = 90;
  CHECK(refused(document) ==
        "weight: the readings give the weight: leave out the weight, or the readings");
  document.settings.weight = Settings{}.weight;
  document.settings.cargo = {{{0.5, 0.5}, 100, ""}};
  CHECK(refused(document) ==
        readings + "the readings add up to 100, no more than the cargo alone, 100");
  document.settings.cargo.clear();
  document.settings.weighed.error = {100, 0};
  CHECK(refused(document) ==
        "reading_error: the readings may be off by 100 in all, as much as they read, 100: then "
        "nothing is known");
  document.settings.weighed.error = {};

  // A second weighing needs all of its three settings.
  document.settings.weighed.tilted = 0.1;
  CHECK(refused(document) == "placed");
  document.settings.weighed.tilted_readings = {1, 2, 3};
  CHECK(refused(document) ==
        "heading: the second weighing needs the direction uphill, such as 1,0");
  document.settings.weighed.heading = Vec2(1, 0);
  CHECK(refused(document) == "readings_tilted: 3 readings are given for 4 supports");
  document.settings.weighed.tilted_readings = {10, 20, 30, 40};
  document.settings.weighed.tilted = 0;
  CHECK(refused(document) == "tilted: the second weighing needs its slope, such as 8% or 5deg");

  // Readings count for given supports alone.
  document.settings.method = Method::area;
  CHECK(refused(document) == "placed");
}

TEST_CASE("readings are read from text, links and results", "[weighing][settings]") {
  Document document;
  const auto read = [&](Setting setting, std::string_view text) {
    return !read_setting(setting, text, document).has_value();
  };
  for (const char* text : {"169 171 140 0", "169,171,140,0", "169, 171, 140, 0"}) {
    CHECK(read(Setting::readings, text));
    CHECK(text_of(Setting::readings, document) == "169 171 140 0");
  }
  for (const char* text : {"", "1 -2", "1,,2", "a", "1e101", "nan"}) {
    INFO(text);
    CHECK_FALSE(read(Setting::readings, text));
  }
  CHECK(read(Setting::readings, "none"));
  CHECK(document.settings.weighed.readings.empty());
  for (const auto& [text, written] : {std::pair("1%", "1%"), {"0.7 %", "0.7%"}, {"2.5", "2.5"}}) {
    CHECK(read(Setting::reading_error, text));
    CHECK(text_of(Setting::reading_error, document) == written);
  }
  CHECK_FALSE(read(Setting::reading_error, "101%"));
  CHECK_FALSE(read(Setting::reading_error, "-1"));
  for (const auto& [text, written] :
       {std::pair("90deg", "0,1"), {"-90\u00B0", "0,-1"}, {"180 deg", "-1,0"}, {"3, 4", "3,4"}}) {
    INFO(text);
    CHECK(read(Setting::heading, text));
    CHECK(text_of(Setting::heading, document) == written);
  }
  for (const char* text : {"0,0", "1", "500deg", "x"}) CHECK_FALSE(read(Setting::heading, text));
  CHECK(read(Setting::weight_doubt, "5%"));
  CHECK(document.shown.carrying.weight_doubt == 0.05);
  CHECK(read(Setting::dynamic, "1.2"));
  CHECK_FALSE(read(Setting::dynamic, "0.9"));

  document = weighed_on(unit_square, {10, 20, 30, 40});
  document.settings.weighed = {{10, 20, 30, 40}, {1, 0}, 0.02, {9, 19, 31, 41}, 0.1, Vec2(0, 1)};
  document.shown.carrying.dynamic = 1.2;
  document.shown.carrying.weight_doubt = 0.05;
  const auto link = encode_link(document);
  REQUIRE(link.ok());
  const auto opened = decode_link(*link);
  REQUIRE(opened.ok());
  CHECK(opened->settings == document.settings);
  CHECK(opened->shown == document.shown);

  // A result has the weight and C as well, which follow from its readings.
  const Placement placement = placed(document);
  const std::string result = placement_json({placement, document.shown}, false);
  const auto again = read_shapes(result);
  REQUIRE(again.ok());
  CHECK(again->shapes[0].document.settings.weighed == document.settings.weighed);
  CHECK(placed(again->shapes[0].document).centre_of_mass == placement.centre_of_mass);
  const Json answered =
      Json::parse(evenlift::answer(R"({"document": )" + result + R"(, "command": "place"})"));
  CHECK(answered["weighing"]["weight"] == 100);
}

TEST_CASE("the factor and the doubt about the weight count in everything that compares loads",
          "[weighing][capacity]") {
  Document document;
  document.vertices = unit_square;
  document.settings.method = Method::given;
  document.settings.supports = unit_square;
  document.shown.capacity = 30;
  const Placement placement = placed(document);
  Report report = report_of({placement, document.shown}, {.plans = true});
  CHECK(report.use == std::vector<std::optional<double>>(4, 25.0 / 30));
  CHECK(report.overloaded_as_planned.empty());
  document.shown.carrying.dynamic = 1.1;
  document.shown.carrying.weight_doubt = 0.1;
  report = report_of({placement, document.shown});
  CHECK(report.use[0] == Approx(25 * 1.21 / 30));
  CHECK(report.overloaded_as_planned.size() == 4);
  CHECK(report.capacities[0] == 30.0);
  CHECK(report.limits[0] == Approx(30 / 1.21));
  // What can tip carries nothing that is known.
  Shown tips = document.shown;
  tips.com_radius = 0.6;
  CHECK(report_of({placement, tips}).use == std::vector<std::optional<double>>(4));
  CHECK(
      use_in_words(Reported({placement, document.shown}, report)) ==
      "Robot 1 is used to 101\u00A0%, with a dynamic factor of 1.1 and a weight that may be off by "
      "10\u00A0%.");
  CHECK(limit_in_words({placement, document.shown}) == "30\u00A0kg divided by 1.21");

  // The plan for a capacity, too: without the factor two teams would do.
  document.settings.method = Method::area;
  document.shown.carrying = {};
  const auto teams_needed = [&] {
    const Placement placed_now = placed(document);
    return report_of({placed_now, document.shown}, {.plans = true}).plan->teams;
  };
  const std::uint32_t without = teams_needed();
  document.shown.carrying.dynamic = 1.3;
  CHECK(teams_needed() > without);
}

TEST_CASE("the cases of loading are the given conditions, alone and at once, and each failure",
          "[weighing][cases]") {
  Document document;
  document.vertices = {{0, 0}, {4, 0}, {4, 4}, {0, 4}};
  document.settings.method = Method::given;
  document.settings.supports = {{0, 0}, {4, 0}, {4, 4}, {0, 4}, {2, 0}, {2, 4}};
  const Placement placement = placed(document);
  const std::vector<LoadCase> still = load_cases({placement, document.shown});
  REQUIRE(still.size() == 1 + 6);
  for (std::size_t failed = 0; failed < 6; ++failed) {
    auto left = *ranges_without(placement, failed, {});
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(failed));
    const auto [least, greatest] = std::minmax_element(
        left.begin(), left.end(), [](const auto& a, const auto& b) { return a.least < b.least; });
    if (!still[1 + failed].stays) continue;
    CHECK(*still[1 + failed].least == Approx(least->least).margin(1e-12));
    CHECK(*still[1 + failed].greatest == Approx(greatest->least));
  }
  document.shown.com_radius = 0.2;
  document.shown.capacity = 40;
  document.shown.carrying = {.com_height = 1, .slope = 0.1};
  const std::vector<LoadCase> cases = load_cases({placement, document.shown});
  REQUIRE(cases.size() == 4 + 6);
  using Kind = LoadCase::Kind;
  const Kind kinds[] = {Kind::level, Kind::com, Kind::slope, Kind::all};
  for (std::size_t i = 0; i < 4; ++i) CHECK(cases[i].kind == kinds[i]);
  // All at once is the report's, and at least as bad as each.
  const Report report = report_of({placement, document.shown});
  CHECK(*cases[3].use == *report.use[*report.most_used()]);
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(*cases[i].greatest <= *cases[3].greatest);
    CHECK(*cases[i].least >= *cases[3].least);
    CHECK(cases[i].stays);
  }
  for (std::size_t i = 4; i < cases.size(); ++i) {
    CHECK(cases[i].failed == i - 4);
    CHECK(cases[i].robot != cases[i].failed);
    CHECK(*cases[i].greatest >= *cases[0].greatest);
  }
  CHECK(worst_case(cases) >= 4u);
  // A slope on which it tips is the worst.
  document.shown.carrying.slope = 1;
  document.shown.carrying.com_height = 5;
  const std::vector<LoadCase> tipping = load_cases({placement, document.shown});
  CHECK_FALSE(tipping[2].stays);
  CHECK_FALSE(tipping[2].greatest);
  CHECK(worst_case(tipping) == 2u);
}

TEST_CASE("conditions can require a use and a safety", "[weighing][requirements]") {
  Document document;
  document.vertices = unit_square;
  document.settings.method = Method::given;
  document.settings.supports = unit_square;
  document.shown.capacity = 30;
  document.shown.com_radius = 0.1;
  const Placement placement = placed(document);
  const Reported of(placement, document.shown);
  const auto check = [&](std::string_view text) {
    const auto conditions = read_conditions(text);
    REQUIRE(conditions.ok());
    return check_conditions(of, *conditions)[0];
  };
  CHECK(check("safety>=5").kept);
  CHECK_FALSE(check("safety>=5.01").kept);
  CHECK(check("safety>=5").value == Approx(5));
  CHECK(check("use<=1").value == Approx(*of.report.use[0]));
  // Nothing moves the weight: there is no ratio.
  document.shown.com_radius = 0;
  CHECK_FALSE(
      check_conditions({placement, document.shown}, *read_conditions("safety>=1"))[0].value);
}

TEST_CASE("what was weighed is said", "[weighing][words]") {
  Document document = weighed_on(unit_square, {10, 20, 30, 40});
  const auto said = [&] {
    const Placement placement = placed(document);
    return plainly(weighing_in_words({placement, document.shown}));
  };
  CHECK(
      said() ==
      "Weighed: 100 kg, C at (0.500, 0.700). W and C are right if each reading is. Equally "
      "stiff supports on even ground would read otherwise: the ground is uneven, the object bends, "
      "or a reading is wrong by up to 20.0 kg. To be sure, lift, set down and read again.");
  // A support that reads nothing does not share the weight.
  document.settings.supports.push_back({0.5, 0.5});
  document.settings.weighed.readings.push_back(0);
  document.shown.carrying.give = 0.004;
  CHECK(said().ends_with("Heights that are off by up to 0.000800 explain them, too."));
  document = weighed_on(unit_square, {10, 20, 30, 40});
  document.settings.weighed.error = {0, 5};
  CHECK(said() ==
        "Weighed: 100 kg, C at (0.500, 0.700), known within 0.125. The weight may be off by up to "
        "20.0 kg.");
  document.settings.weighed.tilted = 0.05;
  document.settings.weighed.heading = Vec2(0, 1);
  document.settings.weighed.tilted_readings = {12.5, 22.5, 27.5, 37.5};
  CHECK(said().ends_with(
      "C is at most 6.00 above the lifting points. Tilt by 5\u00B0 or more to know it "
      "better."));
}
