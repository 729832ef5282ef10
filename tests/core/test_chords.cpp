// How C sees the polygon, by hand and over thousands of small polygons.
#include "evenlift/chords.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include "chords/radial_view.h"
#include "evenlift/generate.h"
#include "evenlift/predicates.h"
#include "kit/catch.h"
#include "kit/polygons.h"
#include "shapes/problem_document.h"
#include "shapes/small_polygons.h"

using namespace evenlift;
using evenlift::testing::polygon;
using evenlift::testing::square;
using evenlift::testing::u_shape;

namespace {

template <class Visit>
void for_each_case(std::uint64_t number, Visit visit) {
  for (std::uint64_t i = 0; i < number; ++i) {
    const small_polygons::Case c = small_polygons::make_case(i);
    const Document document = testing::document_of(c.problem);
    const Polygon p = polygon(document.vertices);
    const auto centre = check_centre_of_mass(p, document.centre_of_mass);
    REQUIRE(centre.ok());
    INFO("case " << i << ", " << c.name);
    visit(p, *centre);
  }
}

// By definition: some direction is strictly inside C's view of a and, reversed, strictly inside
// that of b.
bool face_each_other(const Polygon& p, const Vec2& centre, std::size_t a, std::size_t b) {
  Vec2 a1 = p.edge_start(a), a2 = p.edge_end(a), b1 = p.edge_start(b), b2 = p.edge_end(b);
  if (orient(centre, a1, a2) < 0) std::swap(a1, a2);
  if (orient(centre, b1, b2) < 0) std::swap(b1, b2);
  // Both views are cones of less than 180 degrees. The cone of a and the mirrored cone of b overlap
  // unless a line through C, one of their rims, separates them.
  const auto turn = [&](const Vec2& u, const Vec2& v) {
    return cross_of_differences(centre, u, centre, v);
  };
  // -b is on the right of a1 or on the left of a2, or the other way round.
  const auto separated_by = [&](double u, double v) { return u >= 0 && v >= 0; };
  if (separated_by(turn(a1, b1), turn(a1, b2))) return false;    // -b right of a1
  if (separated_by(-turn(a2, b1), -turn(a2, b2))) return false;  // -b left of a2
  if (separated_by(turn(b1, a1), turn(b1, a2))) return false;
  if (separated_by(-turn(b2, a1), -turn(b2, a2))) return false;
  return true;
}

}  // namespace

TEST_CASE("opposite vertices are on opposite sides of the centre of mass", "[chords]") {
  CHECK(are_opposite({1, 2}, {-2, -4}, 1e-9));
  CHECK_FALSE(are_opposite({1, 2}, {2, 4}, 1e-9));
  CHECK_FALSE(are_opposite({1, 2}, {-2, 1}, 1e-9));
}

TEST_CASE("a chord that is vertical but for rounding begins at its lower end", "[chords]") {
  for (const double x : {0.0, 1e-12, -1e-12}) {
    CHECK(points_right({x, 1}));
    CHECK_FALSE(points_right({x, -1}));
  }
  CHECK(points_right({1e-6, -1}));
  CHECK_FALSE(points_right({-1e-6, 1}));
}

TEST_CASE("a square's centre sees opposite sides as its edge pairs", "[chords]") {
  const auto pairs = edge_pairs(polygon(square), {1, 1});
  REQUIRE(pairs.ok());
  CHECK(pairs->size() == 2);
  CHECK(count_edge_pairs(polygon(square), {1, 1}) == 2);
  for (const EdgePair& pair : *pairs) {
    CHECK((pair.a + 2) % 4 == pair.b);
    for (const auto vertex : {pair.begin_a, pair.begin_b, pair.end_a, pair.end_b})
      CHECK(vertex != inside_edge);
  }
}

TEST_CASE("a chord between two vertices is listed once", "[chords]") {
  const auto chords = vertex_chords(polygon(square), {1, 1});
  REQUIRE(chords.ok());
  REQUIRE(chords->size() == 2);
  for (const VertexChord& c : *chords) {
    CHECK(c.hit_vertex != inside_edge);
    CHECK(c.chord.ratio == 1);
    CHECK(c.chord.arm1 == Approx(std::sqrt(2.0)));
  }
}

TEST_CASE("a vertex's ray meets every edge behind C, and the chord may leave the polygon",
          "[chords]") {
  const Vec2 centre(3, 3);  // in the hollow of the U
  const auto chords = vertex_chords(polygon(u_shape), centre);
  REQUIRE(chords.ok());
  // To the inner wall at (4,4), never to the outer one at (6,6).
  int from_origin = 0;
  for (const VertexChord& c : *chords) {
    if (c.vertex != 0 && c.hit_vertex != 0) continue;
    ++from_origin;
    CHECK(c.chord.r1.position == Vec2(0, 0));
    CHECK(c.chord.r2.position == Vec2(4, 4));
    CHECK(c.chord.ratio == Approx(1.0 / 3).epsilon(1e-15));
  }
  CHECK(from_origin == 1);
}

TEST_CASE("a radial edge is met at its ends only and is in no edge pair", "[chords]") {
  // C is only on the line of edge 4, (4,2)-(2,2).
  const Polygon p = polygon(u_shape);
  const Vec2 centre(1, 2);
  const std::vector<bool> radial = radial_edges(p, centre);
  CHECK(std::count(radial.begin(), radial.end(), true) == 1);
  CHECK(radial[4]);
  const auto pairs = edge_pairs(p, centre);
  REQUIRE(pairs.ok());
  for (const EdgePair& pair : *pairs) CHECK((pair.a != 4 && pair.b != 4));
  const auto chords = vertex_chords(p, centre);
  REQUIRE(chords.ok());
  std::multiset<double> ends;  // of the chords along the radial edge
  for (const VertexChord& c : *chords) {
    if (c.chord.r1.position.y == 2 && c.chord.r2.position.y == 2) {
      CHECK(c.chord.r1.position == Vec2(0, 2));
      ends.insert(c.chord.r2.position.x);
    }
  }
  CHECK(ends == std::multiset<double>{2, 4});
}

TEST_CASE("an edge is radial up to a billionth of the polygon's size", "[chords]") {
  const Polygon p = polygon({{-4, 0}, {4, 0}, {4, 6}, {-4, 6}});  // L = 10
  CHECK(radial_edges(p, {0, 0.99e-8})[0]);
  CHECK_FALSE(radial_edges(p, {0, 1.01e-8})[0]);
}

TEST_CASE("edge pairs are those that face each other, each once", "[chords][thorough]") {
  std::size_t total = 0;
  for_each_case(1500, [&](const Polygon& p, const Vec2& centre) {
    const auto pairs = edge_pairs(p, centre);
    REQUIRE(pairs.ok());
    CHECK(count_edge_pairs(p, centre) == pairs->size());
    std::set<std::pair<std::size_t, std::size_t>> listed, expected;
    for (const EdgePair& pair : *pairs) listed.insert(std::minmax<std::size_t>(pair.a, pair.b));
    CHECK(listed.size() == pairs->size());
    const std::vector<bool> radial = radial_edges(p, centre);
    for (std::size_t a = 0; a < p.size(); ++a)
      for (std::size_t b = a + 1; b < p.size(); ++b)
        if (!radial[a] && !radial[b] && face_each_other(p, centre, a, b)) expected.insert({a, b});
    CHECK(listed == expected);
    total += listed.size();
  });
  CHECK(total > 10000);
}

TEST_CASE("the ends of a pair's range are vertices of its edges", "[chords][thorough]") {
  for_each_case(1500, [&](const Polygon& p, const Vec2& centre) {
    const auto pairs = edge_pairs(p, centre);
    REQUIRE(pairs.ok());
    bool good = true;
    for (const EdgePair& pair : *pairs) {
      const auto on = [&](std::uint32_t vertex, std::uint32_t edge) {
        return vertex == inside_edge || vertex == edge || vertex == p.next(edge);
      };
      good = good && on(pair.begin_a, pair.a) && on(pair.end_a, pair.a) &&
             on(pair.begin_b, pair.b) && on(pair.end_b, pair.b);
      good = good && (pair.begin_a != inside_edge || pair.begin_b != inside_edge);
      good = good && (pair.end_a != inside_edge || pair.end_b != inside_edge);
      good = good && (pair.begin_a == inside_edge || pair.begin_a != pair.end_a);
      // Where both sections begin, the two vertices and C are exactly in line.
      if (pair.begin_a != inside_edge && pair.begin_b != inside_edge)
        good = good && cross_of_differences(centre, p.vertex(pair.begin_a), centre,
                                            p.vertex(pair.begin_b)) == 0;
    }
    CHECK(good);
  });
}

TEST_CASE("a ray lists each boundary point once", "[chords]") {
  const auto met = [](const Points& vertices) {
    std::vector<double> xs;
    for (const RayCaster::Hit& hit : RayCaster(polygon(vertices), {0, 0}).hits({1, 0})) {
      CHECK(hit.point.position.y == 0);
      xs.push_back(hit.point.position.x);
    }
    return xs;
  };
  using Xs = std::vector<double>;
  // Two edges in line with C, after an edge that arrives from the right, and before one.
  CHECK(met({{-1, -1}, {1, 0}, {2, 0}, {3, 0}, {3, 2}, {-1, 2}}) == Xs{1, 2, 3});
  CHECK(met({{-1, -2}, {3, -2}, {3, 0}, {2, 0}, {1, 0}, {-1, 1}}) == Xs{1, 2, 3});
  // The collinear edges' neighbours are on the left, and another edge crosses the ray behind them.
  CHECK(met({{-1, -2}, {4, -2}, {4, 1}, {3, 0}, {2, 0}, {1, 0}, {0.5, 1}, {-1, 1}}) ==
        Xs{1, 2, 3, 4});
  // A corner touches the ray from either side.
  CHECK(met({{-1, -2}, {4, -2}, {4, 1}, {3, 1}, {2, 0}, {1, 1}, {-1, 1}}) == Xs{2, 4});
  CHECK(met({{-1, -1}, {1, -1}, {2, 0}, {3, -1}, {4, -1}, {4, 2}, {-1, 2}}) == Xs{2, 4});
  // The boundary crosses at a corner.
  CHECK(met({{-1, -1}, {4, -1}, {5, 0}, {4, 1}, {-1, 1}}) == Xs{5});
}

TEST_CASE("a ray does not meet an edge whose line passes C within tolerance", "[chords]") {
  // C misses the hollow's bottom by a hair.
  const Polygon u = polygon(u_shape);
  const auto down = RayCaster(u, {3, 2 + 1e-10}).hits({0, -1});
  REQUIRE(down.size() == 1);
  CHECK(length(down[0].point.position - Vec2(3, 0)) < 1e-12);
  CHECK(RayCaster(u, {3, 2 - 1e-10}).hits({0, 1}).empty());
}

TEST_CASE("a ray through a vertex lists this vertex once", "[chords][thorough]") {
  for_each_case(3000, [](const Polygon& p, const Vec2& centre) {
    const RayCaster rays(p, centre);
    for (std::size_t vertex = 0; vertex < p.size(); ++vertex) {
      const Vec2 u = p.vertex(vertex) - centre;
      if (!(length(u) > 0)) continue;
      const auto hits = rays.hits(u);
      // Up to rounding, another edge may touch the outline there; that is another point.
      CHECK(std::count_if(hits.begin(), hits.end(), [&](const RayCaster::Hit& hit) {
              return hit.point.position == Vec2(centre + u) &&
                     (hit.point.edge == vertex || p.next(hit.point.edge) == vertex);
            }) == 1);
    }
  });
}

TEST_CASE("a comb that would list too many pairs is refused by number", "[chords][refusal]") {
  const auto points = generate(Family::comb, 12000, 1);
  REQUIRE(points.ok());
  const Polygon p = polygon(*points);
  const auto centre = check_centre_of_mass(p, std::nullopt);
  REQUIRE(centre.ok());
  REQUIRE(count_edge_pairs(p, *centre) > max_edge_pairs);
  const auto pairs = edge_pairs(p, *centre);
  REQUIRE_FALSE(pairs.ok());
  CHECK(pairs.error().code == ErrorCode::too_many_edge_pairs);
}
