#include "evenlift/stability.h"

#include <cmath>
#include <limits>
#include <random>

#include "evenlift/generate.h"
#include "evenlift/hull.h"
#include "kit/catch.h"
#include "kit/check_placement.h"
#include "kit/polygons.h"
#include "kit/solid.h"
#include "polygon/corners.h"

using namespace evenlift;
using evenlift::testing::polygon;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace

TEST_CASE("coverage is the part of the polygon within the hull, not of the hull", "[stability]") {
  const Polygon u = polygon({{0, 0}, {6, 0}, {6, 4}, {4, 4}, {4, 2}, {2, 2}, {2, 4}, {0, 4}});
  CHECK(u.area() == 20);
  CHECK(coverage(solid(u), {{0, 0}, {6, 0}, {6, 4}, {0, 4}}) == 1);
  CHECK(coverage(solid(u), {{1, 2}, {5, 2}, {5, 4}, {1, 4}}) ==
        Approx(4.0 / 20));  // the hollow is not part of it
  CHECK(coverage(solid(u), {{0, 0}, {6, 0}, {3, 2}}) == Approx(6.0 / 20));
  CHECK(coverage(solid(u), {{2.5, 2.5}, {3.5, 2.5}, {3, 3.5}}) == 0);
}

TEST_CASE("a hull without area covers nothing", "[stability]") {
  const Polygon square = polygon({{0, 0}, {2, 0}, {2, 2}, {0, 2}});
  CHECK(coverage(solid(square), {}) == 0);
  CHECK(coverage(solid(square), {{0, 1}, {2, 1}}) == 0);
}

TEST_CASE("an edge of the hull that is hardly longer than rounding cuts nothing off",
          "[stability]") {
  const Polygon square = polygon({{-10, -10}, {10, -10}, {10, 10}, {-10, 10}});
  // Relative to another corner, this edge's direction would differ.
  const Vec2 p(1, 1 + 0x3p-52), q(1 - 0x4p-52, 1 + 0x5p-52);
  CHECK(coverage(solid(square), {{-8, -8}, {8, -8}, p, q}) == Approx(72.0 / 400));
  CHECK(coverage(solid(square), {{8, -8}, p, q, {-8, -8}}) == Approx(72.0 / 400));
  CHECK(coverage(solid(square), {p, q, {-8, -8}, {8, -8}}) == Approx(72.0 / 400));
}

TEST_CASE("coverage agrees with a sum over horizontal slabs", "[stability]") {
  std::mt19937_64 engine(9);
  int partial = 0;
  for (const Family family : all_families) {
    for (std::uint64_t seed = 0; seed < 25; ++seed) {
      const auto generated = generate(family, 8 + 3 * seed, seed);
      REQUIRE(generated.ok());
      const Polygon p = polygon(*generated);
      Points chosen;
      for (std::size_t i = 0; i < 3 + seed % 6; ++i) {
        const std::size_t edge = engine() % p.size();
        const double s = static_cast<double>(engine() % 1025) / 1024;
        chosen.push_back((1 - s) * p.edge_start(edge) + s * p.edge_end(edge));
      }
      Placement placement(solid(p));
      placement.lifting_base = convex_hull(chosen, 1e-9 * p.diagonal());
      const double given = coverage(solid(p), placement.lifting_base);
      const double slabs = check::Checker(placement).coverage_by_slabs();
      partial += given > 0.01 && given < 0.99;
      CHECK(given == Approx(slabs).margin(1e-11));
    }
  }
  CHECK(partial > 100);
}

TEST_CASE("a force beyond one edge of the hull tips by the lever about that edge", "[stability]") {
  const Points square{{0, 0}, {4, 0}, {4, 4}, {0, 4}};
  const Vec2 centre(1, 2);
  // C is 3 from the right edge, the force 2.
  CHECK(tipping_force(square, centre, 100, {6, 2}) == Approx(150));
  CHECK(tipping_force(square, centre, 100, {-4, 2}) == Approx(25));
  // Beyond two edges, the weaker decides.
  CHECK(tipping_force(square, centre, 100, {5, -1}) == Approx(200));
  CHECK(tipping_force(square, centre, 100, {-1, 6}) == Approx(100));
}

TEST_CASE("no force tips the object within the hull or on its rim", "[stability]") {
  const Points square{{0, 0}, {4, 0}, {4, 4}, {0, 4}};
  for (const Vec2& q : {Vec2(2, 2), Vec2(0, 0), Vec2(4, 1), Vec2(3, 4)})
    CHECK(tipping_force(square, {1, 2}, 100, q) == infinity);
}

TEST_CASE("a single team resists along its line only", "[stability]") {
  const Points line{{0, 0}, {4, 0}};
  const Vec2 centre(1, 0);
  CHECK(tipping_force(line, centre, 100, {2, 1}) == 0);
  CHECK(tipping_force(line, centre, 100, {2, -1e-3}) == 0);
  CHECK(tipping_force(line, centre, 100, {5, 0}) == Approx(300));
  CHECK(tipping_force(line, centre, 100, {-2, 0}) == Approx(50));
  CHECK(tipping_force(line, centre, 100, {3, 0}) == infinity);
  CHECK(tipping_force(line, centre, 100, {4, 0}) == infinity);
}

TEST_CASE("the force that tips falls with the distance and grows with the weight", "[stability]") {
  const Points triangle{{0, 0}, {5, 1}, {2, 6}};
  const Vec2 centre(2, 2);
  std::mt19937_64 engine(10);
  int beyond = 0;
  for (int i = 0; i < 500; ++i) {
    const double angle = 6.28 * static_cast<double>(engine() % 1000) / 1000;
    const Vec2 u(std::cos(angle), std::sin(angle));
    const double near = tipping_force(triangle, centre, 100, centre + 7 * u);
    REQUIRE(near < infinity);
    CHECK(tipping_force(triangle, centre, 100, centre + 9 * u) < near);
    CHECK(tipping_force(triangle, centre, 250, centre + 7 * u) == Approx(2.5 * near));
    ++beyond;
  }
  CHECK(beyond == 500);
}

TEST_CASE("the area in a hull of many sides is that of clipping", "[stability]") {
  std::mt19937_64 rng(5);
  std::uniform_real_distribution<double> part;
  for (const Family family : {Family::convex, Family::star, Family::comb, Family::random}) {
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
      const Points ring = *generate(family, 40 + 4 * static_cast<std::uint32_t>(seed), seed);
      const Box box = bounding_box(ring);
      Points points;
      for (int i = 0; i < 60; ++i)
        points.push_back(box.low + Vec2(part(rng) * box.size().x, part(rng) * box.size().y));
      if (seed % 3 == 0) points.insert(points.end(), ring.begin(), ring.end());
      const Points hull = convex_hull(points);
      const PolygonWithHoles object = solid(Polygon::create(ring).value());
      const double clipped = coverage(object, hull) * object.area();
      INFO(static_cast<int>(family) << ", " << seed);
      CHECK(std::fabs(doubled_area_in_hull(object.boundary(), hull)) / 2 ==
            Approx(clipped).epsilon(1e-12).margin(1e-12 * object.area()));
    }
  }
}

TEST_CASE("thousands of robots are covered as by few steps", "[stability]") {
  // Every second corner of a regular polygon: known exactly.
  const Points ring = *generate(Family::regular, 4000, 1);
  Points hull;
  for (std::size_t i = 0; i < ring.size(); i += 2) hull.push_back(ring[i]);
  const double half = std::acos(-1.0) / 2000;
  CHECK(coverage(solid(Polygon::create(ring).value()), convex_hull(hull)) ==
        Approx(std::sin(2 * half) / (2 * std::sin(half))).epsilon(1e-9));
}
