// Polygon::create: simplicity against the definition over thousands of careless chains, and the
// properties of valid polygons.
#include "polygon/corners.h"

#include <cmath>
#include <random>
#include <set>

#include "evenlift/document.h"
#include "evenlift/generate.h"
#include "evenlift/polygon.h"
#include "evenlift/predicates.h"
#include "kit/catch.h"

using namespace evenlift;

namespace {

auto crossing_of(const Points& chain) {
  return sweep({chain, {chain.size()}, {}}, lexicographic_order(chain)).crossing;
}

int side(const Vec2& a, const Vec2& b, const Vec2& c) {
  const double value = orient(a, b, c);
  return (value > 0) - (value < 0);
}

// Whether c, on the line of a and b, is between them or at one.
bool within(const Vec2& a, const Vec2& b, const Vec2& c) {
  return std::min(a.x, b.x) <= c.x && c.x <= std::max(a.x, b.x) && std::min(a.y, b.y) <= c.y &&
         c.y <= std::max(a.y, b.y);
}

// In a point other than the shared vertex of neighbours.
bool meet(const Points& v, std::size_t i, std::size_t j) {
  const std::size_t n = v.size();
  const Vec2 &a = v[i], &b = v[(i + 1) % n], &c = v[j], &d = v[(j + 1) % n];
  if ((i + 1) % n == j || (j + 1) % n == i) {
    // Neighbours fold back if one's far end is on the other.
    const bool first = (i + 1) % n == j;
    const Vec2 &shared = first ? b : a, &p = first ? a : b, &q = first ? d : c;
    if (side(p, shared, q) != 0) return false;
    return dot_of_differences(shared, p, shared, q) > 0;
  }
  const int abc = side(a, b, c), abd = side(a, b, d), cda = side(c, d, a), cdb = side(c, d, b);
  if (abc * abd < 0 && cda * cdb < 0) return true;
  return (abc == 0 && within(a, b, c)) || (abd == 0 && within(a, b, d)) ||
         (cda == 0 && within(c, d, a)) || (cdb == 0 && within(c, d, b));
}

bool is_simple(const Points& v) {
  for (std::size_t i = 0; i < v.size(); ++i)
    for (std::size_t j = i + 1; j < v.size(); ++j)
      if (meet(v, i, j)) return false;
  return true;
}

// Points of a grid in random order, some off it by a hair.
Points careless_chain(std::mt19937_64& engine) {
  const auto below = [&](std::size_t n) { return static_cast<std::size_t>(engine() % n); };
  const std::size_t side_length = 2 + below(6);
  const std::size_t n = std::min(3 + below(8), side_length * side_length - 1);
  const int form = static_cast<int>(below(4));
  std::set<std::pair<std::size_t, std::size_t>> seen;
  Points points;
  while (points.size() < n) {
    const std::size_t x = below(side_length), y = below(side_length);
    if (!seen.insert({x, y}).second) continue;
    Vec2 p(static_cast<double>(x), static_cast<double>(y));
    if (form == 1) p *= 0.1;                          // inexact tenths
    if (form == 2) p = {p.x * 1e-300, p.y * 1e-300};  // tiny
    if (form == 3 && below(3) == 0) p.y = std::nextafter(p.y, 9);
    points.push_back(p);
  }
  return points;
}

}  // namespace

TEST_CASE("a chain is called simple if and only if no two edges meet, over thousands of chains",
          "[simplicity]") {
  std::mt19937_64 engine(1);
  int simple = 0, not_simple = 0;
  for (int i = 0; i < 30000; ++i) {
    const Points chain = careless_chain(engine);
    const bool expected = is_simple(chain);
    const auto crossing = crossing_of(chain);
    ++(expected ? simple : not_simple);
    const bool agrees = crossing.has_value() != expected;
    const bool proved =
        !crossing || (crossing->first < crossing->second && crossing->second < chain.size() &&
                      meet(chain, crossing->first, crossing->second));
    if (agrees && proved) continue;
    INFO("chain " << i);
    for (const Vec2& p : chain) UNSCOPED_INFO(p.x << " " << p.y);
    CHECK(agrees);
    CHECK(proved);
  }
  CHECK(simple > 2000);
  CHECK(not_simple > 2000);
}

TEST_CASE("every generated polygon is simple, and with two vertices swapped as by definition",
          "[simplicity]") {
  std::mt19937_64 engine(2);
  int spoilt = 0;
  for (const Family family : all_families) {
    for (std::uint64_t seed = 0; seed < 15; ++seed) {
      const auto generated = generate(family, 8 + 7 * seed, seed);
      REQUIRE(generated.ok());
      Points points = *generated;
      CHECK_FALSE(crossing_of(points));
      const std::size_t i = engine() % points.size();
      std::swap(points[i], points[(i + 2 + engine() % 3) % points.size()]);
      const bool expected = is_simple(points);
      spoilt += !expected;
      CHECK(crossing_of(points).has_value() == !expected);
    }
  }
  CHECK(spoilt > 40);
}

TEST_CASE("a chain is judged the same from every vertex on and in both directions",
          "[simplicity]") {
  std::mt19937_64 engine(3);
  for (int i = 0; i < 2000; ++i) {
    Points chain = careless_chain(engine);
    const bool expected = crossing_of(chain).has_value();
    std::rotate(chain.begin(), chain.begin() + 1, chain.end());
    CHECK(crossing_of(chain).has_value() == expected);
    std::reverse(chain.begin(), chain.end());
    CHECK(crossing_of(chain).has_value() == expected);
  }
}

TEST_CASE("touching but for the least coordinate that is not 0 is no touching", "[simplicity]") {
  const auto notch = [](double depth) {
    return Points{{0, 0}, {4, 0}, {4, 4}, {2, depth}, {0, 4}};
  };
  CHECK(Polygon::create(notch(min_coordinate)).ok());
  CHECK(Polygon::create(notch(0)).error().code == ErrorCode::edges_cross);
  CHECK(Polygon::create(notch(-min_coordinate)).error().code == ErrorCode::edges_cross);
}

TEST_CASE("straight vertices are allowed and known as such", "[simplicity]") {
  const auto polygon = Polygon::create({{0, 0}, {1, 0}, {2, 0}, {2, 2}, {1, 1}, {0, 2}});
  REQUIRE(polygon.ok());
  CHECK(polygon->turn(0) == Turn::convex);
  CHECK(polygon->turn(1) == Turn::straight);
  CHECK(polygon->turn(4) == Turn::reflex);
  CHECK_FALSE(polygon->convex());
  CHECK(polygon->counter_clockwise());
  CHECK(polygon->area() == 3);
  CHECK(polygon->hull() == Points{{0, 0}, {2, 0}, {2, 2}, {0, 2}});
  CHECK(polygon->diagonal() == std::sqrt(8.0));

  Points reversed = polygon->vertices();
  std::reverse(reversed.begin(), reversed.end());
  const auto other = Polygon::create(reversed);
  REQUIRE(other.ok());
  CHECK_FALSE(other->counter_clockwise());
  CHECK(other->turn(4) == Turn::straight);
  CHECK(other->turn(1) == Turn::reflex);
  CHECK(other->area() == 3);
  CHECK(other->centroid() == polygon->centroid());
}

TEST_CASE("the centroid loses nothing far from the origin", "[simplicity]") {
  const auto near = Polygon::create({{0, 0}, {3, 0}, {0, 3}});
  const auto far = Polygon::create({{1e9 - 4, -1e9}, {1e9 - 1, -1e9}, {1e9 - 4, -1e9 + 3}});
  REQUIRE(near.ok());
  REQUIRE(far.ok());
  CHECK(near->centroid() == Vec2(1, 1));
  CHECK(far->centroid() == Vec2(1e9 - 3, -1e9 + 1));
  CHECK(far->area() == 4.5);
}

TEST_CASE("the first refusal in order of vertices is reported", "[simplicity][refusal]") {
  const auto error = [](Points points) {
    const auto polygon = Polygon::create(std::move(points));
    REQUIRE_FALSE(polygon.ok());
    return polygon.error();
  };
  // The error names the repeated pair that is complete first.
  const InputError repeated = error({{0, 0}, {1, 0}, {1, 1}, {1, 0}, {0, 0}});
  CHECK(repeated.code == ErrorCode::repeated_vertex);
  CHECK(repeated.place.index == 1);
  CHECK(repeated.place.other == 3);
  const InputError many = error(Points(max_vertices + 1, Vec2(0, 0)));
  CHECK(many.code == ErrorCode::too_many_vertices);
  CHECK(many.place.kind == Place::Kind::nowhere);
}
