#include "evenlift/stands.h"

#include <cmath>
#include <string>

#include "evenlift/candidates.h"
#include "evenlift/generate.h"
#include "evenlift/random.h"
#include "evenlift/settings.h"
#include "evenlift/tolerance.h"
#include "kit/catch.h"
#include "kit/corpus.h"
#include "kit/solid.h"
#include "stands/stand_oracle.h"

using namespace evenlift;
using evenlift::testing::StandOracle;

namespace {

Polygon made(Points vertices) {
  auto polygon = Polygon::create(std::move(vertices));
  REQUIRE(polygon.ok());
  return *std::move(polygon);
}

Polygon square() { return made({{0, 0}, {1, 0}, {1, 1}, {0, 1}}); }

// Its reflex corner is at (1, 1).
Polygon corner() { return made({{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}}); }

// About the origin, with a corner at (radius, 0).
Polygon regular(int corners, double radius) {
  Points vertices;
  for (int k = 0; k < corners; ++k) {
    const double turn = 2 * std::acos(-1.0) * k / corners;
    vertices.emplace_back(radius * std::cos(turn), radius * std::sin(turn));
  }
  return made(vertices);
}

// Convex curves and one hollow curve, in sides of equal turns.
Polygon bean(int sides) {
  Points vertices;
  const auto add_arc = [&](const Vec2& middle, double radius, double from, double to) {
    for (int k = 0; k < sides; ++k) {
      const double turn = std::acos(-1.0) * (from + (to - from) * (k + 0.5) / sides);
      vertices.emplace_back(middle + radius * Vec2(std::cos(turn), std::sin(turn)));
    }
  };
  add_arc({0, 0}, 3, 1, 2);
  add_arc({2, 0}, 1, 0, 1);
  add_arc({0, 0}, 1, 2, 1);
  add_arc({-2, 0}, 1, 0, 1);
  return made(vertices);
}

RobotSize sized(double radius, double reach = 0, double depth = 0, double width = 0,
                double gap = 0) {
  return {radius, reach, depth, width, gap};
}

std::vector<Stretch> stretches(const Stands& stands, std::uint32_t edge) {
  return {stands.room(edge).begin(), stands.room(edge).end()};
}

// The order and bounds of the usable ranges.
void check_order(const Polygon& polygon, const Stands& stands) {
  const double near = near_distance(polygon.diameter());
  for (std::uint32_t edge = 0; edge < polygon.size(); ++edge) {
    double before = -1;
    const double size = length(polygon.edge_end(edge) - polygon.edge_start(edge));
    for (const Stretch& stretch : stands.room(edge)) {
      CHECK(stretch.from > before);
      CHECK(stretch.to - stretch.from >= near * (1 - 1e-6));
      CHECK(stretch.from >= 0);
      CHECK(stretch.to <= size);
      before = stretch.to;
    }
  }
}

// At places along each edge. Returns the number of certain answers.
int compare(const Polygon& polygon, const RobotSize& robot, const std::vector<EdgePart>& no_go,
            int places) {
  const Stands stands(solid(polygon), robot, no_go);
  check_order(polygon, stands);
  const StandOracle oracle(polygon, robot, no_go);
  int sure = 0, wrong = 0;
  for (std::uint32_t edge = 0; edge < polygon.size(); ++edge) {
    const double size = length(polygon.edge_end(edge) - polygon.edge_start(edge));
    for (int k = 0; k < places; ++k) {
      const double part = (k + 0.5) / places;
      const auto expected = oracle.at(edge, part);
      if (expected == StandOracle::Verdict::unsure) continue;
      const bool stands_there = !stands.why_not(edge, part * size);
      ++sure;
      if (stands_there == (expected == StandOracle::Verdict::stands)) continue;
      if (wrong++ == 0) {
        INFO("edge " << edge << " at " << part << ", stands: " << stands_there);
        CHECK(false);
      }
    }
  }
  return sure;
}

Family family_of(std::uint64_t number) {
  constexpr Family families[] = {Family::convex, Family::star, Family::comb, Family::spiral,
                                 Family::random};
  return families[number % std::size(families)];
}

}  // namespace

TEST_CASE("a point without marked edges can stand anywhere, and nothing is computed", "[stands]") {
  const auto stands = make_stands(solid(square()), {}, Settings{});
  REQUIRE(stands.ok());
  CHECK_FALSE(*stands);
}

TEST_CASE("a robot keeps its radius from a reflex corner", "[stands]") {
  const Stands stands(solid(corner()), sized(0.25), {});
  // From (3, 1) to the reflex corner (1, 1).
  REQUIRE(stretches(stands, 2).size() == 1);
  CHECK(stretches(stands, 2)[0].to == Approx(1.75));
  REQUIRE(stretches(stands, 3).size() == 1);
  CHECK(stretches(stands, 3)[0].from == Approx(0.25));
  CHECK(stands.why_not(3, 0.1) == WhyUnusable::body);
  CHECK_FALSE(stands.why_not(3, 0.3));
}

TEST_CASE("with an arm, the other side of a notch is in the way of the body alone", "[stands]") {
  // A notch of width 1 and depth 2, open upwards.
  const Polygon polygon = made({{0, 0}, {5, 0}, {5, 3}, {3, 3}, {3, 1}, {2, 1}, {2, 3}, {0, 3}});
  CHECK(stretches(Stands(solid(polygon), sized(0.6), {}), 4).empty());
  CHECK(stretches(Stands(solid(polygon), sized(0.4), {}), 4).size() == 1);
  // From the notch's bottom, an arm of 2 and more reaches a body above it.
  const Stands armed(solid(polygon), sized(0.6, 2.7), {});
  REQUIRE(stretches(armed, 4).size() == 1);
  CHECK(stretches(armed, 4)[0].from == Approx(2e-9 * polygon.diagonal()));
  // No arm may be longer than its sides' distance.
  CHECK(stretches(Stands(solid(polygon), sized(0.01, 1.5), {}), 3).empty());
  CHECK(Stands(solid(polygon), sized(0.01, 1.5), {}).why_not(3, 1.5) == WhyUnusable::arm);
}

TEST_CASE("a slot that is exactly as wide as the body takes it", "[stands]") {
  // 2 wide; edge 4 is its bottom.
  const Polygon polygon = made({{0, 0}, {6, 0}, {6, 6}, {4, 6}, {4, 1}, {2, 1}, {2, 6}, {0, 6}});
  const Stands stands(solid(polygon), sized(1), {});
  REQUIRE(stretches(stands, 4).size() == 1);
  CHECK(stretches(stands, 4)[0].from == Approx(1));
  CHECK(stretches(stands, 4)[0].to == Approx(1));
  CHECK_FALSE(stands.why_not(4, 1));
  CHECK(stretches(Stands(solid(polygon), sized(1 + 1e-7), {}), 4).empty());
}

TEST_CASE("a hand needs depth beneath it and half its width from corners", "[stands]") {
  const Stands stands(solid(corner()), sized(0, 0, 0.5, 0.4), {});
  REQUIRE(stretches(stands, 0).size() == 1);
  CHECK(stretches(stands, 0)[0].from == Approx(0.2));
  CHECK(stretches(stands, 0)[0].to == Approx(2.8));
  CHECK(stands.why_not(0, 0.1) == WhyUnusable::corner);
  // The object continues beside the reflex corner.
  CHECK(stretches(stands, 2)[0].to == Approx(2));
  // The arms of the L are 1 wide.
  const Stands deep(solid(corner()), sized(0, 0, 1.5, 0.4), {});
  CHECK(deep.why_not(0, 2) == WhyUnusable::hand);
  CHECK_FALSE(deep.why_not(0, 0.5));
}

TEST_CASE("a hand may be wider than the sides of a flattened curve, which has no corners",
          "[stands]") {
  const Polygon circle = regular(64, 1);
  const double side = length(circle.edge_end(0) - circle.edge_start(0));
  for (const double depth : {0.0, 0.01, 0.1, 0.8}) {
    INFO(depth);
    const Stands stands(solid(circle), sized(0.05, 0.05, depth, 0.3), {});
    for (std::uint32_t edge = 0; edge < circle.size(); ++edge) {
      REQUIRE(stretches(stands, edge).size() == 1);
      CHECK(stretches(stands, edge)[0].from < 1e-8);
      CHECK(stretches(stands, edge)[0].to > side - 1e-8);
    }
  }
  // The sagitta of a chord as long as the hand, 0.134 here, is at most a tenth of it.
  CHECK(Stands(solid(circle), sized(0, 0, 0.2, 1), {}).why_not(0, side / 2) == WhyUnusable::hand);
  CHECK(Stands(solid(circle), sized(0, 0, 1.97, 0.6), {}).why_not(0, side / 2) ==
        WhyUnusable::hand);
  // A hexagon turns by 60 degrees.
  const Stands stands(solid(regular(6, 1)), sized(0, 0, 0.1, 0.3), {});
  for (std::uint32_t edge = 0; edge < 6; ++edge) {
    REQUIRE(stretches(stands, edge).size() == 1);
    CHECK(stretches(stands, edge)[0].from == Approx(0.15));
    CHECK(stretches(stands, edge)[0].to == Approx(0.85));
  }
}

TEST_CASE("next to the edge a hand may stick out by a tenth of its width", "[stands]") {
  // Edge 0 ends with a turn of 14 degrees; edge 1 is 0.2 inside its line at x = 2.8.
  const Polygon polygon = made({{0, 0}, {2, 0}, {3, 0.25}, {3, 3}, {0, 3}});
  const Stands stands(solid(polygon), sized(0, 0, 1, 2), {});
  REQUIRE(stretches(stands, 0).size() == 1);
  CHECK(stretches(stands, 0)[0].from == Approx(1));
  CHECK(stretches(stands, 0)[0].to == Approx(1.8));
  CHECK(stands.why_not(0, 0.9) == WhyUnusable::corner);
  CHECK(stands.why_not(0, 1.9) == WhyUnusable::hand);
  // A shallower hand only avoids corners.
  const Stands flat(solid(polygon), sized(0, 0, 0.15, 2), {});
  REQUIRE(stretches(flat, 0).size() == 1);
  CHECK(stretches(flat, 0)[0].from == Approx(1));
  CHECK(stretches(flat, 0)[0].to == Approx(2));
  CHECK(stretches(flat, 1)[0].from < 1e-7);
}

TEST_CASE("a hand that meets no edge is still not beneath an object that is too thin for it",
          "[stands]") {
  // A tenth of the hand's width is 0.2.
  const RobotSize robot = sized(0, 0, 1, 2);
  const Polygon plate = made({{0, 0}, {10, 0}, {10, 0.1}, {0, 0.1}});
  CHECK(Stands(solid(plate), robot, {}).why_not(0, 5) == WhyUnusable::hand);
  CHECK(Stands(solid(plate), robot, {}).why_not(2, 5) == WhyUnusable::hand);
  const Polygon wedge = made({{0, 0}, {10, -0.25}, {10, 0.25}});
  CHECK(Stands(solid(wedge), robot, {}).why_not(0, 1.5) == WhyUnusable::hand);
  // The object continues beyond a slit.
  const Polygon slit =
      made({{0, 0}, {10, 0}, {10, 0.05}, {2, 0.05}, {2, 0.1}, {10, 0.1}, {10, 5}, {0, 5}});
  CHECK_FALSE(Stands(solid(slit), robot, {}).why_not(0, 5));
  CHECK(Stands(solid(slit), sized(0, 0, 1, 0.6), {}).why_not(0, 5) == WhyUnusable::hand);
}

TEST_CASE("a vertex more on a straight side leaves a hand as far from the corner", "[stands]") {
  const Polygon polygon = made({{0, 0}, {0.05, 0}, {0.95, 0}, {1, 0}, {1, 1}, {0, 1}});
  for (const double depth : {0.0, 0.01, 0.5}) {
    INFO(depth);
    const Stands stands(solid(polygon), sized(0, 0, depth, 0.2), {});
    CHECK(stretches(stands, 0).empty());
    REQUIRE(stretches(stands, 1).size() == 1);
    CHECK(stretches(stands, 1)[0].from == Approx(0.05));
    CHECK(stretches(stands, 1)[0].to == Approx(0.85));
    CHECK(stands.why_not(1, 0.02) == WhyUnusable::corner);
    CHECK(stretches(stands, 2).empty());
  }
}

TEST_CASE("marked parts of edges are left out, and so is a vertex that one of them touches",
          "[stands]") {
  const Stands stands(solid(square()), RobotSize{}, {{0, 0.25, 0.5}, {2, 0, 1}});
  REQUIRE(stretches(stands, 0).size() == 2);
  CHECK(stretches(stands, 0)[0].from == 0);
  CHECK(stretches(stands, 0)[0].to == 0.25);
  CHECK(stretches(stands, 0)[1].from == 0.5);
  CHECK(stretches(stands, 2).empty());
  CHECK(stands.why_not(2, 0.5) == WhyUnusable::no_go);
  // Edge 1 ends where edge 2 begins.
  CHECK(stretches(stands, 1)[0].from == 0);
  CHECK(stretches(stands, 1)[0].to < 1);
  CHECK_FALSE(stands.can_lift({{1, 1}, 1}));
  CHECK(stands.can_lift({{1, 0}, 1}));
  // A part at one end of its edge leaves out that vertex alone.
  const Stands half(solid(square()), RobotSize{}, {{0, 0.5, 1}});
  CHECK(half.can_lift({{0, 0}, 0}));
  CHECK_FALSE(half.can_lift({{1, 0}, 1}));
}

TEST_CASE("the whole width of a hand keeps off what is marked", "[stands]") {
  const Stands stands(solid(square()), sized(0, 0, 0.1, 0.2), {{0, 0.4, 0.6}, {2, 0, 0.25}});
  REQUIRE(stretches(stands, 0).size() == 2);
  CHECK(stretches(stands, 0)[0].to == Approx(0.3));
  CHECK(stretches(stands, 0)[1].from == Approx(0.7));
  CHECK(stands.why_not(0, 0.5) == WhyUnusable::no_go);
  CHECK(stands.why_not(0, 0.35) == WhyUnusable::near_no_go);
  CHECK(stands.why_not(0, 0.65) == WhyUnusable::near_no_go);
  CHECK_FALSE(stands.why_not(0, 0.29));
  // The no-go part is exactly the given one.
  for (const UnusablePart& part : stands.unusable())
    if (part.edge == 0 && part.why == WhyUnusable::no_go) {
      CHECK(part.part.from == Approx(0.4));
      CHECK(part.part.to == Approx(0.6));
    }
  REQUIRE(stretches(stands, 2).size() == 1);
  CHECK(stretches(stands, 2)[0].from == Approx(0.35));
  // No-go parts do not reach around corners.
  CHECK(stretches(stands, 1)[0].to == Approx(0.9));
  // All of it needs room between two no-go parts.
  CHECK(stretches(Stands(solid(square()), sized(0, 0, 0, 0.2), {{0, 0, 0.4}, {0, 0.55, 1}}), 0)
            .empty());
  CHECK(stretches(Stands(solid(square()), sized(0.01, 0, 0, 0), {{0, 0, 0.4}, {0, 0.55, 1}}), 0)
            .size() == 1);
}

TEST_CASE("a hand on a curve keeps off what is marked beside its own edge", "[stands]") {
  const Polygon curve = regular(64, 1);
  const double side = length(curve.edge_end(0) - curve.edge_start(0));
  const RobotSize robot = sized(0, 0, 0.3, 2 * side);
  const Stands stands(solid(curve), robot, {{10, 0, 1}});
  CHECK(stands.why_not(9, side / 2) == WhyUnusable::near_no_go);
  CHECK(stands.why_not(11, side / 2) == WhyUnusable::near_no_go);
  CHECK_FALSE(stands.why_not(7, side / 2));
  CHECK_FALSE(stands.why_not(13, side / 2));
}

TEST_CASE("every place is as the four conditions say", "[stands][thorough]") {
  Rng rng(5);
  int sure = 0;
  for (std::uint64_t number = 0; number < 80; ++number) {
    const std::size_t n = 4 + rng.below(40);
    const auto vertices = generate(family_of(number), n, number);
    if (!vertices) continue;
    const Polygon polygon = made(*vertices);
    const double size = polygon.diagonal();
    RobotSize robot;
    // Each is present or not, at random.
    for (double* value : {&robot.radius, &robot.reach, &robot.depth, &robot.width}) {
      const bool there = rng.below(3) > 0;
      const double part = rng.uniform();
      if (there) *value = 0.06 * size * part;
    }
    std::vector<EdgePart> no_go;
    for (std::uint64_t k = rng.below(3); k > 0; --k) {
      const auto edge = static_cast<std::uint32_t>(rng.below(n));
      const double from = rng.uniform() / 2;
      const double to = from + rng.uniform() / 2 + 1e-3;
      if (edge < polygon.size()) no_go.push_back({edge, from, to});
    }
    INFO("polygon " << number << " with " << n << ", r " << robot.radius / size << " g "
                    << robot.reach / size << " d " << robot.depth / size << " w "
                    << robot.width / size);
    sure += compare(polygon, robot, no_go, n < 12 ? 1000 : 60);
  }
  CHECK(sure > 100000);
}

TEST_CASE("every place of the samples is as the four conditions say", "[stands][thorough]") {
  int sure = 0;
  for (const std::string& name : corpus::polygon_names()) {
    const Document document = corpus::polygon(name);
    // C does not matter for places, so a sample with another C shows nothing new.
    if (document.vertices.size() > 60 || name.ends_with("-moved")) continue;
    const Polygon polygon = made(document.vertices);
    const double size = polygon.diagonal();
    INFO(name);
    sure += compare(polygon, sized(0.03 * size), {}, 100);
    sure += compare(polygon, sized(0.02 * size, 0.03 * size, 0.02 * size, 0.01 * size), {}, 100);
  }
  CHECK(sure > 100000);
}

TEST_CASE("every place of flattened curves is as the four conditions say", "[stands][thorough]") {
  Rng rng(23);
  int sure = 0;
  for (int number = 0; number < 30; ++number) {
    const int sides = 3 + static_cast<int>(rng.below(30));
    const Polygon polygon = number % 2 ? bean(sides) : regular(2 * sides + 1, 3);
    // From hands narrower than the sides to those that no curve has room for.
    RobotSize robot;
    robot.width = std::pow(0.9, static_cast<double>(rng.below(60))) * 4;
    robot.depth = robot.width * std::pow(0.8, static_cast<double>(rng.below(20))) * 2;
    if (number % 3 == 0) robot.radius = 0.2 * rng.uniform();
    INFO("shape " << number << " of " << polygon.size() << ", " << robot_text(robot));
    sure += compare(polygon, robot, {}, 1000 / sides);
  }
  CHECK(sure > 25000);
}

TEST_CASE("the same stretches whichever way round the vertices are listed", "[stands]") {
  std::size_t compared = 0;
  for (std::uint64_t number = 0; number < 40; ++number) {
    const auto vertices = generate(family_of(number), 5 + number, number);
    if (!vertices) continue;
    const Polygon polygon = made(*vertices);
    const Polygon reversed = made(Points(vertices->rbegin(), vertices->rend()));
    const RobotSize robot = sized(0.03 * polygon.diagonal(), 0.01 * polygon.diagonal(),
                                  0.01 * polygon.diagonal(), 0.01 * polygon.diagonal());
    const Stands there(solid(polygon), robot, {}), back(solid(reversed), robot, {});
    const auto n = static_cast<std::uint32_t>(polygon.size());
    for (std::uint32_t edge = 0; edge < n; ++edge) {
      const auto a = stretches(there, edge), b = stretches(back, (2 * n - 2 - edge) % n);
      REQUIRE(a.size() == b.size());
      compared += a.size();
      const double size = length(polygon.edge_end(edge) - polygon.edge_start(edge));
      for (std::size_t i = 0; i < a.size(); ++i) {
        CHECK(a[i].from == Approx(size - b[b.size() - 1 - i].to).margin(1e-9 * size));
        CHECK(a[i].to == Approx(size - b[b.size() - 1 - i].from).margin(1e-9 * size));
      }
    }
  }
  CHECK(compared > 300);
}

TEST_CASE("two robots collide by their bodies or by their hands", "[stands]") {
  const Stands stands(solid(square()), sized(0.1, 0, 0.3, 0.1, 0.05), {});
  const auto lifting = [&](double x) { return stands.lifting_point({{x, 0}, 0}); };
  CHECK(lifting(0.5).position == Vec2(0.5, 0.3));
  CHECK(stands.contact(lifting(0.5)) == Vec2(0.5, 0));
  CHECK(length(stands.stand(lifting(0.5)) - Vec2(0.5, -0.1)) < 1e-15);
  CHECK(stands.collide(lifting(0.2), lifting(0.44)));
  CHECK_FALSE(stands.collide(lifting(0.2), lifting(0.46)));
  // Hands cross beneath the object, of bodies far apart.
  const LiftingPoint from_left = stands.lifting_point({{0, 0.2}, 3});
  CHECK(stands.collide(lifting(0.2), from_left));
  CHECK_FALSE(stands.collide(lifting(0.6), from_left));
}

TEST_CASE("robots that are the gap apart but for rounding do not collide", "[stands]") {
  const Stands stands(solid(corner()), sized(0, 0, 0, 0, 2), {});
  REQUIRE(2.3 - 0.3 < 2);
  CHECK_FALSE(stands.collide({{0.3, 0}, 0}, {{2.3, 0}, 0}));
  CHECK(stands.collide({{0.3, 0}, 0}, {{2.3 - 1e-7, 0}, 0}));
}

TEST_CASE("the arm of a robot keeps off another robot's body and arm", "[stands]") {
  // One robot is above the L's lower bar, one to the right of its other bar, with bodies at (2,
  // 2.6) and (2.6, y).
  const auto from_below = [](const Stands& stands) { return stands.lifting_point({{2, 1}, 2}); };
  const auto from_left = [](const Stands& stands, double y) {
    return stands.lifting_point({{1, y}, 3});
  };
  const Stands stands(solid(corner()), sized(0.1, 1.5, 0.2, 0.1), {});
  CHECK(length(stands.stand(from_below(stands)) - Vec2(2, 2.6)) < 1e-12);
  for (const double y : {1.5, 2.0, 2.5, 2.6, 2.65, 2.69, 2.71, 2.9}) {
    INFO(y);
    const LiftingPoint a = from_below(stands), b = from_left(stands, y);
    REQUIRE(stands.can_lift(a));
    REQUIRE(stands.can_lift(b));
    CHECK(length(stands.stand(a) - stands.stand(b)) > 0.2);
    // Up to 2.6 arms cross; up to 2.7 the arm passes through the body at its end.
    CHECK(stands.collide(a, b) == (y < 2.7));
    CHECK(stands.collide(b, a) == (y < 2.7));
    CHECK(stands.any_collide({a, b}) == (y < 2.7));
  }
  // The gap also counts between arm and body.
  const Stands wider(solid(corner()), sized(0.1, 1.5, 0.2, 0.1, 0.05), {});
  CHECK(wider.collide(from_below(wider), from_left(wider, 2.74)));
  CHECK_FALSE(wider.collide(from_below(wider), from_left(wider, 2.76)));
  // Arms of point bodies cross too; touching is no crossing.
  const Stands thin(solid(corner()), sized(0, 1.5), {});
  CHECK(thin.collide(from_below(thin), from_left(thin, 2.4)));
  CHECK_FALSE(thin.collide(from_below(thin), from_left(thin, 2.5)));
  CHECK_FALSE(thin.collide(from_below(thin), from_left(thin, 2.6)));
  // Without a reach, no arm is outside the body.
  const Stands round(solid(corner()), sized(0.5, 0), {});
  CHECK_FALSE(round.collide(round.lifting_point({{2.5, 1}, 2}), round.lifting_point({{1, 2}, 3})));
}

TEST_CASE("two robots collide as bodies, arms and hands say", "[stands][slow]") {
  Rng rng(11);
  int collide = 0, beside = 0;
  StandOracle::Clashes clashes;
  for (std::uint64_t number = 0; number < 150; ++number) {
    const auto vertices = generate(family_of(number), 4 + rng.below(30), number);
    if (!vertices) continue;
    const Polygon polygon = made(*vertices);
    const double size = polygon.diagonal();
    RobotSize robot;
    for (double* value : {&robot.radius, &robot.reach, &robot.depth, &robot.width, &robot.gap}) {
      const bool there = rng.below(4) > 0;
      const double part = rng.uniform();
      if (there) *value = (value == &robot.reach ? 0.4 : 0.06) * size * part;
    }
    if (!robot.has_body()) continue;
    INFO("polygon " << number << ", " << robot_text(robot));
    // Whether they could stand alone does not matter.
    const Stands stands(solid(polygon), robot, {});
    const StandOracle oracle(polygon, robot, {});
    const auto contact = [&] {
      const auto edge = static_cast<std::uint32_t>(rng.below(polygon.size()));
      const double part = rng.uniform();
      return LiftingPoint{
          polygon.edge_start(edge) + part * (polygon.edge_end(edge) - polygon.edge_start(edge)),
          edge};
    };
    for (int pair = 0; pair < 2000; ++pair) {
      const LiftingPoint a = contact();
      const LiftingPoint b = contact();
      const StandOracle::Verdict verdict = oracle.beside(a, b, clashes);
      if (verdict == StandOracle::Verdict::unsure) continue;
      const bool expected = verdict == StandOracle::Verdict::cannot;
      (expected ? collide : beside) += 1;
      const LiftingPoint p = stands.lifting_point(a), q = stands.lifting_point(b);
      if (stands.collide(p, q) != expected || stands.collide(q, p) != expected)
        FAIL("contacts (" << a.position.x << ", " << a.position.y << ") and (" << b.position.x
                          << ", " << b.position.y << ")");
    }
  }
  CHECK(collide > 10000);
  CHECK(beside > 100000);
  CHECK(clashes.bodies > 1000);
  CHECK(clashes.arms > 1000);
  CHECK(clashes.hands > 1000);
}

TEST_CASE("errors of stands name the setting and say why", "[stands][errors]") {
  Settings settings;
  settings.no_go = {{7, 0, 1}};
  auto refusedThere = make_stands(solid(square()), {}, settings);
  REQUIRE_FALSE(refusedThere.ok());
  CHECK(refusedThere.error().message == "there is no edge 8; the polygon has 4");
  CHECK(refusedThere.error().place.option == "no_go");
  settings.no_go = {{0, 0, 1}, {1, 0, 1}, {2, 0, 1}, {3, 0, 1}};
  CHECK(make_stands(solid(square()), {}, settings).error().message ==
        "the no-go edges leave no edge for the robots");
  settings.no_go.clear();
  settings.robot = sized(0, 0, 2, 0.1);
  CHECK(make_stands(solid(square()), {}, settings).error().message ==
        "no edge has room for a hand of depth 2 and width 0.1");
  settings.robot = sized(0.1, 0, 2, 0.1);
  CHECK(make_stands(solid(square()), {}, settings).error().message ==
        "no edge has room for a robot of radius 0.1, with a hand of depth 2 and width 0.1");
  settings.robot = sized(0.1, 0, 0, 3);
  CHECK(make_stands(solid(square()), {}, settings).error().message ==
        "no edge has room for a robot of radius 0.1, with a hand of depth 0 and width 3");
  settings.robot = sized(0.1, 5, 2, 0);
  CHECK(
      make_stands(solid(square()), {}, settings).error().message ==
      "no edge has room for a robot of radius 0.1 and reach 5, with a hand of depth 2 and width 0");
}

TEST_CASE("the size of a robot and marked edges are read from text and written as text",
          "[settings]") {
  Document document;
  const auto read = [&](Setting setting, const char* text) {
    return !read_setting(setting, text, document).has_value();
  };
  CHECK(read(Setting::robot, "depth=3,r=0.5,gap=1e-3"));
  CHECK(document.settings.robot == sized(0.5, 0, 3, 0, 1e-3));
  CHECK(robot_text(document.settings.robot) == "r=0.5,depth=3,gap=0.001");
  for (const char* bad : {"", "5", "r", "r=", "r=-1", "r=inf", "r=nan", "r=1,r=2", "r=1,", ",r=1",
                          "size=1", "r= 1", "R=1", "none,r=1"})
    CHECK_FALSE(read(Setting::robot, bad));
  CHECK(document.settings.robot == sized(0.5, 0, 3, 0, 1e-3));
  CHECK(read(Setting::robot, "none"));
  CHECK(document.settings.robot == RobotSize{});

  CHECK(read(Setting::no_go, "3,5:0.25-0.75,1:1e-9-1e-8"));
  CHECK(document.settings.no_go ==
        std::vector<EdgePart>{{2, 0, 1}, {4, 0.25, 0.75}, {0, 1e-9, 1e-8}});
  CHECK(no_go_text(document.settings.no_go) == "3,5:0.25-0.75,1:1e-9-1e-8");
  CHECK(read(Setting::no_go, "1:-0-0.5"));
  CHECK_FALSE(std::signbit(document.settings.no_go.front().from));
  for (const char* bad : {"", "0", "-1", "1.5", "3:", "3:0.5", "3:0.5-", "3:0.7-0.2", "3:0.5-0.5",
                          "3:-0.1-1", "3:0-1.5", "3,", "a", "2000000", "3:0 - 1"})
    CHECK_FALSE(read(Setting::no_go, bad));
  CHECK(read(Setting::no_go, "none"));
  CHECK(document.settings.no_go.empty());
}
