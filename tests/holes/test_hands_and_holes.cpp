// A hand must lie on the material, and a support must not be in a hole.
#include <cmath>
#include <string>
#include <vector>

#include "evenlift/generate.h"
#include "evenlift/placement.h"
#include "evenlift/random.h"
#include "evenlift/stands.h"
#include "evenlift/supports.h"
#include "kit/catch.h"
#include "kit/placed.h"
#include "shapes/holed_polygons.h"
#include "shapes/problem_document.h"
#include "stands/stand_oracle.h"

using namespace evenlift;
using evenlift::testing::placed;
using evenlift::testing::points_of;
using evenlift::testing::ring_of;
using evenlift::testing::StandOracle;
using Verdict = StandOracle::Verdict;

namespace {

const Points square{{0, 0}, {10, 0}, {10, 10}, {0, 10}};

Points box(double left, double bottom, double right, double top) {
  return {{left, bottom}, {right, bottom}, {right, top}, {left, top}};
}

PolygonWithHoles object(const Points& outline, const std::vector<Points>& holes) {
  const auto polygon = Polygon::create(outline);
  REQUIRE(polygon.ok());
  auto made = PolygonWithHoles::create(*polygon, holes);
  REQUIRE(made.ok());
  return *std::move(made);
}

// On the square with one hole, for a hand of this depth and width.
Stands stands_of(double depth, double width, const Points& hole) {
  RobotSize robot;
  robot.depth = depth;
  robot.width = width;
  return Stands(object(square, {hole}), robot, {});
}

Document standing_on(const Points& supports, const std::vector<Points>& holes) {
  Document document;
  document.vertices = square;
  document.holes = holes;
  document.settings.method = Method::given;
  document.settings.supports = supports;
  return document;
}

RobotSize any_hand(Rng& rng, double size) {
  RobotSize robot;
  if (rng.below(2) == 0) robot.radius = 0.02 * rng.uniform() * size;
  if (rng.below(3) == 0) robot.reach = 0.02 * rng.uniform() * size;
  robot.depth = (rng.below(2) == 0 ? 0.05 : 0.3) * rng.uniform() * size;
  if (rng.below(4) != 0) robot.width = 0.1 * rng.uniform() * size;
  return robot;
}

struct Compared {
  int stand = 0, hole = 0, other = 0;
};

// Compares with the definition along each edge. The reason is `hole` exactly where a robot could
// stand without holes.
void compare(const PolygonWithHoles& of, const RobotSize& robot, Compared& compared) {
  const Stands stands(of, robot, {});
  const StandOracle oracle(of.outline(), robot, {}, of.holes()), filled(of.outline(), robot, {});
  constexpr int places = 20;
  for (std::uint32_t edge = 0; edge < of.outline().size(); ++edge) {
    const double size = length(of.outline().edge_end(edge) - of.outline().edge_start(edge));
    for (int k = 0; k < places; ++k) {
      const double part = (k + 0.5) / places;
      const Verdict expected = oracle.at(edge, part), without = filled.at(edge, part);
      if (expected == Verdict::unsure || without == Verdict::unsure) continue;
      const auto why = stands.why_not(edge, part * size);
      INFO("edge " << edge << " at " << part);
      CHECK(why.has_value() == (expected == Verdict::cannot));
      if (why && *why != WhyUnusable::narrow)
        CHECK((why == WhyUnusable::hole) == (without == Verdict::stands));
      ++(!why ? compared.stand : why == WhyUnusable::hole ? compared.hole : compared.other);
    }
  }
}

}  // namespace

TEST_CASE("a hand stays off a hole by half its width and by its depth", "[stands][holes]") {
  const Stands deep = stands_of(3, 1, box(2, 2, 4, 4));
  CHECK(deep.why_not(0, 3) == WhyUnusable::hole);
  CHECK(deep.why_not(0, 1.6) == WhyUnusable::hole);
  CHECK(deep.why_not(0, 4.4) == WhyUnusable::hole);
  CHECK_FALSE(deep.why_not(0, 1.4));
  CHECK_FALSE(deep.why_not(0, 4.6));
  CHECK(deep.why_not(0, 0.3) == WhyUnusable::corner);
  REQUIRE(deep.room(0).last - deep.room(0).first == 2);
  CHECK(deep.room(0).first[0].to == Approx(1.5));
  CHECK(deep.room(0).first[1].from == Approx(4.5));
  CHECK(deep.room(1).last - deep.room(1).first == 1);
  REQUIRE(deep.room(3).last - deep.room(3).first == 2);  // from (0, 10) to (0, 0)
  CHECK(deep.room(3).first[0].to == Approx(5.5));
  const Stands shallow = stands_of(1.9, 1, box(2, 2, 4, 4));
  CHECK_FALSE(shallow.why_not(0, 3));
  CHECK(shallow.room(0).last - shallow.room(0).first == 1);
}

TEST_CASE("a hole within the hand and a hand within a hole are refused alike", "[stands][holes]") {
  const Stands around = stands_of(2, 2, box(4.9, 1, 5.1, 1.2));
  CHECK(around.why_not(0, 5) == WhyUnusable::hole);
  CHECK(around.why_not(0, 4) == WhyUnusable::hole);
  CHECK_FALSE(around.why_not(0, 3.8));
  const Stands within = stands_of(3, 1, box(1, 0.05, 9, 8.5));
  CHECK(within.why_not(0, 5) == WhyUnusable::hole);
  CHECK_FALSE(within.why_not(1, 9.2));
  const Stands line = stands_of(3, 0, box(1, 1, 9, 9));
  CHECK(line.why_not(0, 5) == WhyUnusable::hole);
  CHECK_FALSE(line.why_not(0, 0.9));
  // The tenth of the width next to the edge does not count.
  const Stands beyond = stands_of(3, 1, box(1, 0.02, 9, 0.08));
  CHECK_FALSE(beyond.why_not(0, 5));
  // Two such slits, and a hole beyond them in which the hand is.
  RobotSize robot;
  robot.depth = 3;
  robot.width = 1;
  const Stands slits(
      object(square, {box(1, 0.02, 9, 0.04), box(1, 0.05, 9, 0.08), box(2, 0.09, 8, 9)}), robot,
      {});
  CHECK(slits.why_not(0, 5) == WhyUnusable::hole);
}

TEST_CASE("neither body nor arm nor a point cares about holes", "[stands][holes]") {
  RobotSize robot;
  robot.radius = 1;
  robot.reach = 0.5;
  const Stands with(object(square, {box(0.1, 0.1, 9.9, 9.9)}), robot, {});
  const Stands without(object(square, {}), robot, {});
  for (std::uint32_t edge = 0; edge < 4; ++edge) {
    REQUIRE(with.room(edge).last - with.room(edge).first == 1);
    CHECK(with.room(edge).first->from == without.room(edge).first->from);
    CHECK(with.room(edge).first->to == without.room(edge).first->to);
  }
}

TEST_CASE("hands near holes stand where the definition says so", "[stands][holes][slow]") {
  Rng rng(6);
  Compared compared;
  for (const Family family : all_families)
    for (std::uint64_t seed = 0; seed < 8; ++seed) {
      const auto outline = generate(family, 8 + 2 * seed, seed);
      REQUIRE(outline.ok());
      const PolygonWithHoles of =
          object(*outline, points_of(holed_polygons::holes_in(ring_of(*outline), seed, 1 + seed)));
      INFO(name(family) << " " << seed);
      compare(of, any_hand(rng, of.outline().diameter()), compared);
    }
  CHECK(compared.stand > 2000);
  CHECK(compared.hole > 300);
  CHECK(compared.other > 1000);
}

TEST_CASE("robots of a size are placed with their hands on the material", "[stands][holes][slow]") {
  int robots = 0;
  for (const Family family : all_families)
    for (std::uint64_t seed = 0; seed < 4; ++seed)
      for (const Method method : {Method::area, Method::balanced}) {
        if (method == Method::balanced && seed > 0) continue;
        Document document;
        document.vertices = *generate(family, 12 + 4 * seed, seed);
        document.holes = points_of(holed_polygons::holes_in(ring_of(document.vertices), seed, 8));
        document.settings.method = method;
        document.settings.robot = {8, 0, 40, 12, 4};
        const auto placement = place(document);
        if (!placement) continue;  // no edge has room
        const Placement& p = *placement;
        const StandOracle oracle(p.polygon(), p.settings.robot, {}, p.object.holes());
        for (const LiftingPoint& contact : contact_points(p)) {
          const Vec2 &a = p.polygon().edge_start(contact.edge),
                     &b = p.polygon().edge_end(contact.edge);
          INFO(name(family) << " " << seed << " by " << name(method));
          CHECK(oracle.at(contact.edge, dot(contact.position - a, b - a) / dot(b - a, b - a)) !=
                Verdict::cannot);
          ++robots;
        }
      }
  CHECK(robots > 60);
}

TEST_CASE("a given robot whose hand would reach into a hole does not fit", "[supports][holes]") {
  Document document = standing_on({{3, 0}, {8, 0}, {5, 10}}, {box(2, 2, 4, 4)});
  document.settings.robot.depth = 3;
  document.settings.robot.width = 1;
  const Placement p = placed(document);
  const auto found = misfits(p.polygon(), p.stands.get(), lifting_points(p.teams));
  REQUIRE(found.size() == 1);
  CHECK(found[0] == Misfit{0, Misfit::Why::hole, 0});
}

TEST_CASE("a support in a hole is refused by the number of the hole", "[supports][holes]") {
  const std::vector<Points> holes{box(6, 6, 8, 8), box(2, 2, 4, 4)};
  const auto refused = place(standing_on({{0, 0}, {3, 3}, {10, 5}}, holes));
  REQUIRE_FALSE(refused.ok());
  CHECK(refused.error().code == ErrorCode::bad_setting);
  CHECK(path_of(refused.error().place) == "supports[1]");
  CHECK(refused.error().message == "(3, 3) is in hole 2");
  const auto other = place(standing_on({{7.5, 6.5}}, holes));
  REQUIRE_FALSE(other.ok());
  CHECK(other.error().message == "(7.5, 6.5) is in hole 1");
}

TEST_CASE("supports on the material and on the rim of a hole are accepted", "[supports][holes]") {
  const std::vector<Points> holes{box(2, 2, 4, 4)};
  const Points rim{{2, 3}, {4, 3}, {3, 2}, {3, 4}, {2, 2}, {4, 2}, {4, 4}, {2, 4}};
  const Placement p = placed(standing_on(rim, holes));
  for (const LiftingPoint& robot : lifting_points(p.teams)) CHECK(robot.edge == beneath);
  CHECK(place(standing_on({{1, 3}, {5, 3}, {8, 8}, {0, 0}, {1.9999999, 3}}, holes)).ok());
}

TEST_CASE("a support near the outline stands at the edge though it is in a hole",
          "[supports][holes]") {
  Document document = standing_on({{5, 0.3}, {2, 8}, {8, 8}}, {box(4, 0.2, 6, 3)});
  CHECK_FALSE(place(document).ok());
  document.settings.snap = 0.5;
  const Placement p = placed(document);
  CHECK(lifting_points(p.teams)[0].position == Vec2(5, 0));
  CHECK(lifting_points(p.teams)[0].edge == 0);
}

TEST_CASE("supports among holes are refused exactly where a point is in a hole",
          "[supports][holes][slow]") {
  Rng rng(9);
  int in = 0, on = 0;
  for (std::uint64_t number = 0; number < 150; ++number) {
    const oracle::Problem problem = holed_polygons::make_case(number).problem;
    Document document = testing::document_of(problem);
    document.settings.method = Method::given;
    const PolygonWithHoles of = object(document.vertices, document.holes);
    const SupportPlacer placer(of, document.settings);
    const Box bounds = bounding_box(document.vertices);
    for (int i = 0; i < 30; ++i) {
      const double right = rng.uniform(), up = rng.uniform();
      const Vec2 at = bounds.low + componentwise_product(bounds.size(), Vec2(right, up));
      if (placer.distance(at) <= 1e-4 * of.outline().diameter()) continue;
      bool expected = oracle::contains(problem.vertices, testing::point_of(at));
      for (const oracle::Ring& hole : problem.holes) {
        const bool in_hole = oracle::contains(hole, testing::point_of(at));
        in += in_hole;
        expected = expected && !in_hole;
      }
      CHECK(placer.place(at).has_value() == expected);
      on += expected;
    }
  }
  CHECK(in > 150);
  CHECK(on > 1000);
}
