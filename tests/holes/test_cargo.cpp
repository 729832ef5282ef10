#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "evenlift/centre_of_mass.h"
#include "evenlift/loads.h"
#include "evenlift/placement.h"
#include "evenlift/random.h"
#include "kit/catch.h"
#include "kit/corpus.h"
#include "kit/placed.h"
#include "kit/polygons.h"
#include "shapes/holed_polygons.h"
#include "shapes/problem_document.h"

using namespace evenlift;
using evenlift::testing::document_of;
using evenlift::testing::placed;
using evenlift::testing::point_of;
using evenlift::testing::polygon;
using evenlift::testing::problem_of;

namespace {

const Points square{{0, 0}, {10, 0}, {10, 10}, {0, 10}};
const Points small_square{{2, 2}, {4, 2}, {4, 4}, {2, 4}};

PolygonWithHoles object(const Points& outline, const std::vector<Points>& holes) {
  auto made = PolygonWithHoles::create(polygon(outline), holes);
  REQUIRE(made.ok());
  return *std::move(made);
}

// 1220 x 610 with a round hole of 64 corners, as in docs and lessons.
PolygonWithHoles plate() {
  Points hole;
  for (int i = 0; i < 64; ++i) {
    const double angle = 2 * std::acos(-1.0) * i / 64;
    hole.emplace_back(600 + 250 * std::cos(angle), 300 + 250 * std::sin(angle));
  }
  return object({{0, 0}, {1220, 0}, {1220, 610}, {0, 610}}, {hole});
}

Settings with_cargo(double weight, std::vector<Cargo> cargo) {
  Settings settings;
  settings.weight = weight;
  settings.cargo = std::move(cargo);
  return settings;
}

Vec2 exact_centre(const Vec2& own, const Settings& settings) {
  std::vector<oracle::Cargo> cargo;
  for (const Cargo& item : settings.cargo) cargo.push_back({point_of(item.at), item.weight});
  const oracle::Point centre = oracle::centre_with_cargo(point_of(own), settings.weight, cargo);
  return {centre[0], centre[1]};
}

// A few units in the last place of each item's moments and of the sum.
double rounding_of(const Vec2& own, const Settings& settings) {
  double arms = 0;
  for (const Cargo& item : settings.cargo)
    arms += item.weight / total_weight(settings) * length(item.at - own);
  const double items = static_cast<double>(settings.cargo.size());
  return 0x1p-52 * ((3 + items) * arms + one_norm(own));
}

// Light enough for C to stay near the place.
std::vector<Cargo> any_cargo(Rng& rng, const Vec2& about, double reach, double weight) {
  std::vector<Cargo> cargo(1 + rng.below(rng.below(5) == 0 ? 1000 : 6));
  const double share = weight / static_cast<double>(cargo.size());
  for (Cargo& item : cargo) {
    const double right = rng.uniform() - 0.5, up = rng.uniform() - 0.5;
    item.at = about + 2 * reach * Vec2(right, up);
    item.weight = share * (0.01 + rng.uniform());
  }
  return cargo;
}

InputError refusal(const PolygonWithHoles& of, const Settings& settings) {
  const auto centre = centre_of_mass(of, std::nullopt, settings);
  REQUIRE_FALSE(centre.ok());
  return centre.error();
}

void check_same(const Placement& a, const Placement& b) {
  CHECK(a.centre_of_mass == b.centre_of_mass);
  CHECK(a.weight() == b.weight());
  CHECK(a.team_candidates == b.team_candidates);
  CHECK(a.lifting_base == b.lifting_base);
  CHECK(a.coverage == b.coverage);
  CHECK(a.closure.margin == b.closure.margin);
  CHECK(planned_loads(a.teams) == planned_loads(b.teams));
}

}  // namespace

TEST_CASE("a weight on a square with a hole pulls the centre of mass to it", "[cargo]") {
  const PolygonWithHoles holed = object(square, {small_square});
  const Settings settings = with_cargo(96, {{{8, 8}, 24, "motor"}});
  const auto centre = centre_of_mass(holed, std::nullopt, settings);
  REQUIRE(centre.ok());
  CHECK(centre->own == Vec2(488.0 / 96, 488.0 / 96));
  CHECK(length(centre->all - Vec2(17.0 / 3, 17.0 / 3)) <= 2e-15);  // 5.666667
  CHECK(centre->all.x == centre->all.y);
  CHECK(total_weight(settings) == 120);
}

TEST_CASE("a motor beyond the plate is carried while the centre of mass is inside the hull",
          "[cargo]") {
  const PolygonWithHoles of = plate();
  const oracle::Problem problem = problem_of(of);
  const Vec2 own = of.centroid();
  CHECK(of.area() == oracle::area(problem));
  CHECK(point_of(own) == oracle::centroid(problem));
  CHECK(of.area() == Approx(548165.719341).epsilon(1e-9));
  CHECK(own.x == Approx(613.576186).epsilon(1e-9));
  CHECK(own.y == Approx(306.788093).epsilon(1e-9));

  const Settings settings = with_cargo(68, {{{2100, 300}, 12, "motor"}});
  const auto centre = centre_of_mass(of, std::nullopt, settings);
  REQUIRE(centre.ok());
  CHECK(length(centre->all - exact_centre(own, settings)) <= rounding_of(own, settings));
  CHECK(centre->all.x == Approx(836.539758).epsilon(1e-9));
  CHECK(centre->all.y == Approx(305.769879).epsilon(1e-9));
  CHECK(total_weight(settings) == 80);

  // The lever: 68 (1220 - 613.576) = w (2100 - 1220), so w = 46.86.
  CHECK(centre_of_mass(of, std::nullopt, with_cargo(68, {{{2100, 300}, 46.8, ""}})).ok());
  const InputError error = refusal(of, with_cargo(68, {{{2100, 300}, 46.9, ""}}));
  CHECK(error.code == ErrorCode::centre_outside_hull);
  CHECK(describe(error.place) == "centre of mass");
  CHECK(error.message ==
        "with its cargo the centre of mass is not inside the convex hull of the polygon");
}

TEST_CASE("the loads of a plate with its motor add up to the weight of both", "[cargo]") {
  Document document;
  document.vertices = plate().outline().vertices();
  document.holes = plate().rings_of_holes();
  document.settings = with_cargo(68, {{{2100, 300}, 12, "motor"}});
  for (const Method method : all_methods) {
    document.settings.method = method;
    const Placement p = placed(document);
    double sum = 0;
    for (const double load : planned_loads(p.teams)) sum += load;
    CHECK(sum == Approx(80));
    CHECK(p.own_centre == p.object.centroid());
    CHECK(p.centre_of_mass.x == Approx(836.539758).epsilon(1e-9));
  }
}

TEST_CASE("the centre of mass with cargo is that of exact arithmetic", "[cargo][oracle][slow]") {
  Rng rng(7);
  int accepted = 0, refused = 0;
  for (std::uint64_t number = 0; number < 250; ++number) {
    const Document document = document_of(holed_polygons::make_case(number).problem);
    const auto of = object_of(document);
    REQUIRE(of.ok());
    const double size = of->outline().diameter(), weight = std::ldexp(1, int(rng.below(40)) - 20);
    const Vec2 own = document.centre_of_mass.value_or(of->centroid());
    const double heavy = rng.below(3) == 0 ? 100 : 1;
    const Settings settings =
        with_cargo(weight, any_cargo(rng, own + rng.uniform() * Vec2(size, size),
                                     size * (0.5 + rng.uniform()), heavy * weight));
    const Vec2 exact = exact_centre(own, settings);
    const auto mine = centre_of_mass(*of, document.centre_of_mass, settings);
    oracle::Problem problem = problem_of(*of);
    problem.centre_of_mass = point_of(exact);
    INFO("case " << number);
    CHECK(mine.ok() == (oracle::refusal(problem) == oracle::Refusal::none));
    ++(mine.ok() ? accepted : refused);
    if (!mine) continue;
    CHECK(mine->own == own);
    CHECK(length(mine->all - exact) <= rounding_of(own, settings));
  }
  CHECK(accepted > 80);
  CHECK(refused > 20);
}

TEST_CASE("an object with cargo is placed as one of the whole weight and centre of mass",
          "[cargo][slow]") {
  Rng rng(8);
  int compared = 0;
  for (std::uint64_t number = 0; number < 60; ++number) {
    Document document = document_of(holed_polygons::make_case(number).problem);
    document.settings.method = all_methods[number % std::size(all_methods)];
    const auto of = object_of(document);
    REQUIRE(of.ok());
    document.settings.cargo = any_cargo(rng, document.centre_of_mass.value_or(of->centroid()),
                                        of->outline().diameter(), 20);
    const auto loaded = place(document);
    if (!loaded) continue;
    Document whole = document;
    whole.settings.cargo.clear();
    whole.settings.weight = total_weight(document.settings);
    whole.centre_of_mass = loaded->centre_of_mass;
    INFO("case " << number);
    check_same(*loaded, placed(whole));
    ++compared;
  }
  CHECK(compared > 40);
}

TEST_CASE("cargo at C, and none, leave the centre of mass where it is, bit for bit", "[cargo]") {
  for (const std::string& name : corpus::polygon_names()) {
    const Document document = corpus::polygon(name);
    const PolygonWithHoles of(polygon(document.vertices));
    const auto none = centre_of_mass(of, document.centre_of_mass, document.settings);
    REQUIRE(none.ok());
    CHECK(none->own == *check_centre_of_mass(of, document.centre_of_mass));
    CHECK(none->all == none->own);
    Settings settings = document.settings;
    settings.cargo = {{none->own, 12.5, "at C"}};
    CHECK(centre_of_mass(of, document.centre_of_mass, settings)->all == none->own);
  }
}

TEST_CASE("cargo so far away that numbers overflow is refused as any other", "[cargo][refusal]") {
  const PolygonWithHoles of(polygon(square));
  const double far = std::numeric_limits<double>::max();
  for (const Vec2& at : {Vec2(far, 0), Vec2(-far, far), Vec2(far, far), Vec2(1e300, -1e200),
                         Vec2(1e160, 1e160), Vec2(0, -1e307)})
    for (const double weight : {1.0, max_weight})
      CHECK(refusal(of, with_cargo(1, {{at, weight, ""}})).code == ErrorCode::centre_outside_hull);
  const Settings apart = with_cargo(1, {{{far, 5}, max_weight, ""}, {{-far, 5}, max_weight, ""}});
  CHECK(refusal(of, apart).code == ErrorCode::centre_outside_hull);
  // Two that balance each other.
  const Settings balanced = with_cargo(1, {{{5 + 1e6, 5}, 3, ""}, {{5 - 1e6, 5}, 3, ""}});
  CHECK(length(centre_of_mass(of, std::nullopt, balanced)->all - Vec2(5, 5)) <= 1e-9);
}

TEST_CASE("C without cargo may be outside the hull if its cargo brings it inside", "[cargo]") {
  const PolygonWithHoles of(polygon(square));
  const Settings settings = with_cargo(10, {{{-5, 5}, 10, "counterweight"}});
  const auto centre = centre_of_mass(of, Vec2(15, 5), settings);
  REQUIRE(centre.ok());
  CHECK(centre->own == Vec2(15, 5));
  CHECK(centre->all == Vec2(5, 5));
  CHECK_FALSE(centre_of_mass(of, Vec2(15, 5), with_cargo(10, {})).ok());
}
