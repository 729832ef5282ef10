#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>

#include "evenlift/chords.h"
#include "evenlift/document.h"
#include "evenlift/generate.h"
#include "evenlift/numbers.h"
#include "evenlift/polygon.h"
#include "kit/catch.h"

using namespace evenlift;

namespace {

std::size_t fewest(Family family) {
  return family == Family::comb || family == Family::spiral ? 8 : 3;
}

Polygon polygon_of(Family family, std::size_t n, std::uint64_t seed) {
  Result<Points> points = generate(family, n, seed);
  REQUIRE(points.ok());
  REQUIRE(points->size() == n);
  Result<Polygon> polygon = Polygon::create(std::move(*points));
  if (!polygon) FAIL(polygon.error().message + " at " + describe(polygon.error().place));
  return *std::move(polygon);
}

// A point sees all of a counter-clockwise polygon if it is on or left of every edge's line. If any
// does, so does an intersection of two lines. O(n^3).
bool is_star_shaped(const Points& p) {
  const std::size_t n = p.size();
  const auto direction = [&](std::size_t i) { return Vec2(p[(i + 1) % n] - p[i]); };
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 1; j < n; ++j) {
      const double parallel = cross(direction(i), direction(j));
      if (parallel == 0) continue;
      const Vec2 meet = p[i] + direction(i) * (cross(Vec2(p[j] - p[i]), direction(j)) / parallel);
      bool sees_all = true;
      for (std::size_t k = 0; k < n && sees_all; ++k)
        sees_all = cross(direction(k), Vec2(meet - p[k])) >= -1e-6 * length(direction(k));
      if (sees_all) return true;
    }
  return false;
}

// By the ray from the centroid in direction u.
std::size_t edges_met(const Polygon& polygon, const Vec2& u) {
  std::size_t met = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 a = polygon.edge_start(i) - polygon.centroid(),
               b = polygon.edge_end(i) - polygon.centroid();
    const double left = cross(u, a), right = cross(u, b);
    met += (left > 0) != (right > 0) && cross(a, b) * (right - left) > 0;
  }
  return met;
}

// FNV-1a of all coordinates' bits.
std::uint64_t fingerprint(const Points& points) {
  std::uint64_t hash = 14695981039346656037u;
  for (const Vec2& p : points)
    for (const double value : {p.x, p.y}) {
      std::uint64_t bits = 0;
      std::memcpy(&bits, &value, sizeof bits);
      for (int byte = 0; byte < 8; ++byte)
        hash = (hash ^ ((bits >> (8 * byte)) & 255u)) * 1099511628211u;
    }
  return hash;
}

}  // namespace

TEST_CASE("every family gives valid counter-clockwise polygons of exactly n vertices",
          "[generate][slow]") {
  for (const Family family : all_families) {
    DYNAMIC_SECTION(name(family)) {
      for (std::size_t n = fewest(family); n <= 40; ++n)
        for (std::uint64_t seed = 0; seed < 25; ++seed) {
          CAPTURE(n, seed);
          const Polygon polygon = polygon_of(family, n, seed);
          CHECK(polygon.counter_clockwise());
          for (const Vec2& p : polygon.vertices()) {
            CHECK((p.x >= 0 && p.x <= 1000));
            CHECK((p.y >= 0 && p.y <= 1000));
          }
        }
      for (const std::size_t n : {99u, 100u, 255u, 999u, 1000u, 1001u, 5000u, 65536u}) {
        CAPTURE(n);
        CHECK(polygon_of(family, n, 7).counter_clockwise());
      }
    }
  }
}

TEST_CASE("the largest polygons are valid too", "[generate][thorough]") {
  for (const Family family : {Family::convex, Family::random}) {  // the delicate ones
    CAPTURE(name(family));
    CHECK(polygon_of(family, max_vertices, 1).counter_clockwise());
  }
}

TEST_CASE("the families regular and convex turn left at every vertex", "[generate][slow]") {
  for (const Family family : {Family::regular, Family::convex})
    for (const std::size_t n : {3u, 4u, 7u, 50u, 1000u, 1001u, 20000u, 200000u}) {
      CAPTURE(name(family), n);
      const Polygon polygon = polygon_of(family, n, 3);
      std::size_t convex = 0;
      for (std::size_t i = 0; i < n; ++i) convex += polygon.turn(i) == Turn::convex;
      CHECK(convex == n);
    }
}

TEST_CASE("regular polygons stand on a level edge and mirror left to right", "[generate]") {
  for (const std::size_t n : {3u, 4u, 5u, 6u, 9u, 30u}) {
    CAPTURE(n);
    const Points p = *generate(Family::regular, n, 1);
    CHECK(p[0].y == p[1].y);
    for (std::size_t i = 0; i < n; ++i) {
      const Vec2& mirrored = p[(n + 1 - i) % n];
      CHECK(p[i].x + mirrored.x == Approx(1000).margin(1e-9));
      CHECK(p[i].y == mirrored.y);
    }
  }
}

TEST_CASE("a star's centre sees all of it", "[generate]") {
  for (const std::size_t n : {3u, 4u, 5u, 20u, 1000u, 100000u}) {
    const Points p = *generate(Family::star, n, 11);
    std::size_t seen = 0;
    for (std::size_t i = 0; i < n; ++i)
      seen += cross(Vec2(p[i] - Vec2(500, 500)), Vec2(p[(i + 1) % n] - Vec2(500, 500))) > 0;
    CHECK(seen == n);
  }
}

TEST_CASE("random polygons of six vertices or more are not star-shaped", "[generate]") {
  for (std::size_t n = 6; n <= 30; ++n)
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
      CAPTURE(n, seed);
      CHECK_FALSE(is_star_shaped(*generate(Family::random, n, seed)));
    }
}

TEST_CASE("in a comb about n^2 / 4 edge pairs face each other across the centroid", "[generate]") {
  for (const std::size_t n : {8u, 40u, 101u, 400u}) {
    CAPTURE(n);
    const Polygon polygon = polygon_of(Family::comb, n, 5);
    const double quarter = static_cast<double>(n) * static_cast<double>(n) / 4;
    const auto pairs = static_cast<double>(count_edge_pairs(polygon, polygon.centroid()));
    CHECK(pairs > quarter - 2 * static_cast<double>(n));
    CHECK(pairs < quarter + 2 * static_cast<double>(n));
  }
}

TEST_CASE("rays from the centroid of a random polygon meet many edges", "[generate]") {
  const Polygon polygon = polygon_of(Family::random, 10000, 1);
  std::size_t met = 0;
  for (int k = 0; k < 32; ++k) met += edges_met(polygon, Vec2(k - 15.7, k % 2 == 0 ? 11.3 : -11.3));
  CHECK(static_cast<double>(met) / 32 > 20);
}

TEST_CASE("coordinates of up to 1000 vertices have at most three decimals", "[generate]") {
  for (const Family family : all_families)
    for (const std::size_t n : {10u, 1000u}) {
      const Points points = *generate(family, n, 2);
      for (const Vec2& p : points)
        for (const double value : {p.x, p.y}) {
          const std::string text = shortest(value);
          const std::size_t point = text.find('.');
          CHECK((point == std::string::npos || text.size() - point - 1 <= 3));
        }
    }
}

TEST_CASE("the same seed gives the same polygon on every platform, another seed another",
          "[generate]") {
  const std::pair<Family, std::uint64_t> expected[] = {
      {Family::regular, 0xc95bcb31190202ad}, {Family::convex, 0x4f16f844d5df2ad6},
      {Family::star, 0x90d413df4ef036b7},    {Family::comb, 0x12e8d570f24736ed},
      {Family::spiral, 0xc59219c92031737c},  {Family::random, 0x6eeca5ca50f02ef1},
  };
  for (const auto& [family, hash] : expected) {
    CAPTURE(name(family));
    CHECK(fingerprint(*generate(family, 1000, 42)) == hash);
    CHECK(*generate(family, 50, 1) == *generate(family, 50, 1));
    if (family != Family::regular) CHECK(*generate(family, 50, 1) != *generate(family, 50, 2));
  }
}

TEST_CASE("a size out of range is refused by naming n", "[generate]") {
  const auto refuses = [](Family family, std::size_t n) {
    const Result<Points> points = generate(family, n, 1);
    return !points && points.error().code == ErrorCode::bad_setting &&
           points.error().place.kind == Place::Kind::option && points.error().place.option == "n";
  };
  for (const Family family : all_families) {
    CAPTURE(name(family));
    CHECK(refuses(family, 0));
    CHECK(refuses(family, fewest(family) - 1));
    CHECK(refuses(family, max_vertices + 1));
    CHECK(refuses(family, std::numeric_limits<std::size_t>::max()));
  }
}

TEST_CASE("families have names", "[generate]") {
  for (const Family family : all_families) CHECK(family_from_name(name(family)) == family);
  CHECK_FALSE(family_from_name("Random"));
  CHECK_FALSE(family_from_name(""));
}
