// Every Polygon, however small or thin.
#include "evenlift/polygon.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "evenlift/experiment/measure.h"
#include "evenlift/hull.h"
#include "evenlift/output/words.h"
#include "evenlift/placement.h"
#include "evenlift/random.h"
#include "kit/catch.h"
#include "oracle/oracle.h"
#include "oracle/rational.h"
#include "oracle/vec.h"
#include "polygon/corners.h"

using namespace evenlift;

namespace {

Points square_of(double side) { return {{0, 0}, {side, 0}, {side, side}, {0, side}}; }

std::vector<oracle::Point> for_oracle(const Points& vertices) {
  std::vector<oracle::Point> points;
  points.reserve(vertices.size());
  for (const Vec2& v : vertices) points.push_back({v.x, v.y});
  return points;
}

double exact_area(const Points& vertices) {
  const auto exact = [&](std::size_t i) {
    const Vec2& v = vertices[i % vertices.size()];
    return oracle::Vec<oracle::Rational>{v.x, v.y};
  };
  oracle::Rational twice = 0;
  for (std::size_t i = 0; i < vertices.size(); ++i) twice += oracle::cross(exact(i), exact(i + 1));
  return oracle::nearest_double(oracle::abs(twice) / 2);
}

// The promises of polygon.h, in exact arithmetic.
void check_promises(const Points& vertices) {
  const Result<Polygon> polygon = Polygon::create(vertices);
  REQUIRE(polygon.ok());
  const Points& v = polygon->vertices();
  INFO("first vertices (" << v[0].x << "," << v[0].y << ") (" << v[1].x << "," << v[1].y << ") ("
                          << v[2].x << "," << v[2].y << ")");
  CHECK(polygon->diagonal() >= min_diagonal);
  CHECK(polygon->area() == exact_area(vertices));
  const oracle::Point centroid = oracle::centroid(for_oracle(vertices));
  CHECK(polygon->centroid().x == centroid[0]);
  CHECK(polygon->centroid().y == centroid[1]);
}

}  // namespace

TEST_CASE("an object whose bounding box has a diagonal below 1e-9 is refused as too small",
          "[polygon][refusal]") {
  const double below = std::nextafter(1e-9, 0);
  for (const Points& vertices :
       {square_of(7e-10), square_of(1e-30), square_of(1e-150), square_of(1e-200),
        Points{{0, 0}, {0x1p-1074, 0}, {0, 0x1p-1074}}, Points{{0, 0}, {below, 0}, {5e-10, 1e-20}},
        Points{{1, 0}, {1 + 0x1p-31, 0}, {1, 0x1p-31}}}) {
    const Result<Polygon> polygon = Polygon::create(vertices);
    REQUIRE_FALSE(polygon.ok());
    CHECK(polygon.error().code == ErrorCode::object_too_small);
    CHECK(polygon.error().place.kind == Place::Kind::nowhere);
    CHECK(polygon.error().message ==
          "the object is too small: its bounding box's diagonal is below 1e-9");
  }
  CHECK(Polygon::create({{0, 0}, {1e-9, 0}, {5e-10, 1e-20}}).ok());
  CHECK(Polygon::create(square_of(7.1e-10)).ok());
}

TEST_CASE("too small an object with a fault of its own is told that fault", "[polygon][refusal]") {
  const auto code = [](Points points) { return Polygon::create(std::move(points)).error().code; };
  CHECK(code({{0, 0}, {1e-12, 0}, {0, 0}}) == ErrorCode::repeated_vertex);
  CHECK(code({{0, 0}, {1e-12, 0}, {2e-12, 0}}) == ErrorCode::no_area);
  CHECK(code({{0, 0}, {1e-12, 1e-12}, {1e-12, 0}, {0, 1e-12}}) == ErrorCode::edges_cross);
}

TEST_CASE("placing, planning and measuring refuse too small an object with the same sentence",
          "[polygon][refusal]") {
  Document document;
  document.vertices = square_of(1e-200);
  const std::string message = Polygon::create(document.vertices).error().message;
  CHECK(place(document).error().message == message);
  CHECK(experiment::prepare(document, {}).error().message == message);
}

TEST_CASE("the thinnest polygons have a diagonal, an area above 0 and a centroid of doubles",
          "[polygon]") {
  const double least = min_coordinate;
  const Points slivers[] = {
      {{0, 0}, {1, 0}, {0, least}},
      {{0, 0}, {1e-9, 0}, {0, least}},
      {{0, 0}, {1e-9, 0}, {3e-10, least}, {-1e-9, 1e-90}},
      {{0, 0}, {1, 0}, {1, 1e-95}, {0, 1e-95}},
      {{0, 0}, {0.3, least}, {0.1, std::nextafter(least, 1)}},
      {{-1e9, 0}, {1e9, 0}, {0, least}},
      {{-1e9, -1e9}, {1e9, 1e9}, {5e8, std::nextafter(5e8, 0)}},
      {{1e9, 1}, {1e9, -1}, {std::nextafter(1e9, 0), 0}},
      // Its area is only what remains after large parts cancel.
      {{0, 0}, {1, 0x1p-330}, {2, 0}, {1, 0x1p-331}},
  };
  for (const Points& vertices : slivers) check_promises(vertices);
}

TEST_CASE("random polygons of every thinness keep the promises of polygon.h", "[polygon][slow]") {
  Rng rng(8);
  int kept = 0;
  for (int i = 0; i < 3000; ++i) {
    const double width = std::ldexp(1 + rng.uniform(), -static_cast<int>(rng.below(320)));
    const double size = std::ldexp(1.0, 28 - static_cast<int>(rng.below(56)));
    Points vertices;
    for (int k = 0; k < 3 + i % 2; ++k) {
      const double x = (rng.uniform() - 0.5) * size;
      vertices.emplace_back(x, (rng.uniform() - 0.5) * width);
    }
    if (i % 3 == 0)
      for (Vec2& v : vertices) v = {v.y, v.x + 1};
    if (!Polygon::create(vertices).ok()) continue;  // crossed, or beyond the limits
    ++kept;
    check_promises(vertices);
  }
  CHECK(kept > 1500);
}

// A rectangle with a moved corner, an L or a U, very thin in one direction.
Points any_sliver(double width, Rng& rng) {
  const Points shapes[] = {{{-1, -1}, {1, -rng.uniform()}, {1, 1}, {-1, 1}},
                           {{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}},
                           {{0, 0}, {4, 0}, {4, 4}, {3, 4}, {3, 1}, {1, 1}, {1, 4}, {0, 4}}};
  Points vertices = shapes[rng.below(std::size(shapes))];
  const bool flat = rng.below(2) == 0;
  for (Vec2& v : vertices) (flat ? v.y : v.x) *= width;
  return vertices;
}

TEST_CASE("a coordinate below 1e-100 that is not 0 is refused at its vertex",
          "[polygon][refusal]") {
  const double below = std::nextafter(min_coordinate, 0);
  for (const double tiny : {below, -below, 1e-200, -5e-324}) {
    for (const Vec2& vertex : {Vec2(1, tiny), Vec2(tiny, 1)}) {
      const Result<Polygon> polygon = Polygon::create({{0, 0}, vertex, {-1, 1}});
      REQUIRE_FALSE(polygon.ok());
      CHECK(polygon.error().code == ErrorCode::bad_coordinate);
      CHECK(polygon.error().place.index == 1);
      CHECK(polygon.error().message == "a coordinate is below 1e-100 in size but not 0");
    }
    const Result<Polygon> square = Polygon::create({{-1, -1}, {1, -1}, {1, 1}, {-1, 1}});
    const Result<Vec2> centre = check_centre_of_mass(*square, Vec2(0, tiny));
    REQUIRE_FALSE(centre.ok());
    CHECK(centre.error().place.kind == Place::Kind::centre_of_mass);
  }
  CHECK(Polygon::create({{0, 0}, {1, min_coordinate}, {-1, 1}}).ok());
}

TEST_CASE("whatever of the thinnest polygons can be placed has finite results", "[polygon][slow]") {
  Rng rng(9);
  int placed = 0;
  for (int i = 0; i < 600; ++i) {
    const double width = std::ldexp(1.0, -static_cast<int>(rng.below(333)));
    Document document;
    document.vertices = any_sliver(width, rng);
    document.settings.method = all_methods[static_cast<std::size_t>(i) % std::size(all_methods)];
    document.settings.min_ratio = 0;
    const Result<Placement> placement = place(document);
    if (!placement) continue;
    ++placed;
    INFO("half width " << width << ", " << name(document.settings.method));
    CHECK((placement->coverage >= 0 && placement->coverage <= 1));
    for (const Team& team : placement->teams)
      for (const Robot& robot : team.robots) CHECK((robot.load >= 0 && robot.load <= 100));
    if (placement->closure.margin) CHECK(std::isfinite(*placement->closure.margin));
  }
  CHECK(placed > 500);
}

TEST_CASE("points that all lie within a distance of one line have a hull without area",
          "[polygon][hull]") {
  // All are within 1 of the line y = 0, but one is 2 from the line through the others.
  const Points points{{0, 1}, {5, -1}, {10, 1}};
  CHECK(convex_hull(points, 1) == Points{{0, 1}, {10, 1}});
  CHECK(convex_hull(points, 0.99).size() == 3);
}

TEST_CASE("the diameter is that of the farthest corners, of sides that are nearly parallel, too",
          "[polygon][hull]") {
  // Up to rounding a parallelogram: either end of a side may seem farther from the opposite.
  for (const double side : {1.0, -1.0}) {
    const Points hull = convex_hull({{0, 0}, {side * 0.1, 0.4}, {side * 0.1, 0.5}, {0, 0.1}});
    REQUIRE(hull.size() == 4);
    CHECK(diameter(hull) == Approx(std::sqrt(0.26)).epsilon(1e-14));
  }
}

TEST_CASE("an outline's direction does not depend on where it begins", "[polygon]") {
  // With straight vertices on each side.
  const Points around = {{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}};
  for (std::size_t first = 0; first < around.size(); ++first) {
    Points ring = around;
    std::rotate(ring.begin(), ring.begin() + static_cast<std::ptrdiff_t>(first), ring.end());
    INFO("from vertex " << first);
    CHECK(Polygon::create(ring)->counter_clockwise());
    std::reverse(ring.begin(), ring.end());
    CHECK_FALSE(Polygon::create(ring)->counter_clockwise());
  }
}

TEST_CASE("the distance to a corner goes along the outline, in either direction",
          "[polygon][corners]") {
  // A square whose lower side is an arc of many short edges, which are no corners.
  Points ring = {{10, 0}, {10, 10}, {0, 10}, {0, 0}};
  constexpr int edges = 40;
  for (int i = 1; i < edges; ++i) {
    const double x = 10.0 * i / edges;
    ring.emplace_back(x, -0.04 * x * (10 - x));
  }
  const Polygon polygon = *Polygon::create(ring);
  const Corners corners(polygon);
  std::vector<double> way = {0};  // along the arc from (0, 0)
  for (std::size_t i = 3; i < ring.size(); ++i)
    way.push_back(way.back() + length(ring[(i + 1) % ring.size()] - ring[i]));
  for (std::size_t i = 3; i < ring.size(); ++i) {
    const Vec2 middle = (ring[i] + ring[(i + 1) % ring.size()]) / 2;
    const double from = (way[i - 3] + way[i - 2]) / 2;
    CHECK(corners.distance_to(middle, static_cast<std::uint32_t>(i)) ==
          Approx(std::min(from, way.back() - from)).epsilon(1e-12));
  }
}
