// Holes by hand, the effect of how rings are listed, and holes too small to matter.
#include "evenlift/polygon_with_holes.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "evenlift/numbers.h"
#include "evenlift/optimum.h"
#include "evenlift/placement.h"
#include "evenlift/selection.h"
#include "evenlift/stability.h"
#include "kit/catch.h"
#include "kit/placed.h"
#include "kit/polygons.h"
#include "shapes/holed_polygons.h"
#include "shapes/problem_document.h"

using namespace evenlift;
using evenlift::testing::document_of;
using evenlift::testing::placed;
using evenlift::testing::polygon;

namespace {

const Points square{{0, 0}, {10, 0}, {10, 10}, {0, 10}};
const Points small_square{{2, 2}, {4, 2}, {4, 4}, {2, 4}};

Points moved(Points points, const Vec2& by) {
  for (Vec2& p : points) p += by;
  return points;
}

Points reversed(Points points) {
  std::reverse(points.begin(), points.end());
  return points;
}

PolygonWithHoles object(const Points& outline, const std::vector<Points>& holes) {
  auto made = PolygonWithHoles::create(polygon(outline), holes);
  REQUIRE(made.ok());
  return *std::move(made);
}

InputError refusal(const std::vector<Points>& holes, const Points& outline = square) {
  const auto made = PolygonWithHoles::create(polygon(outline), holes);
  REQUIRE_FALSE(made.ok());
  return made.error();
}

// The place in words, and the sentence.
std::string refusal_in_words(const std::vector<Points>& holes) {
  const InputError error = refusal(holes);
  return describe(error.place) + ": " + error.message;
}

// C is given, so that it does not change.
Document numbered_document(std::uint64_t number) {
  Document document = document_of(holed_polygons::make_case(number).problem);
  document.settings.method = Method::area;
  document.centre_of_mass = placed(document).centre_of_mass;
  return document;
}

void check_same_teams(const Placement& a, const Placement& b) {
  CHECK(a.team_candidates == b.team_candidates);
  REQUIRE(a.teams.size() == b.teams.size());
  for (std::size_t i = 0; i < a.teams.size(); ++i)
    for (const std::size_t end : {0u, 1u}) {
      CHECK(a.teams[i].robots[end].point.position == b.teams[i].robots[end].point.position);
      CHECK(a.teams[i].robots[end].load == b.teams[i].robots[end].load);
    }
}

double thinness(const PolygonWithHoles& of) {
  return of.outline().diameter() * of.outline().diameter() / of.area();
}

}  // namespace

TEST_CASE("a square hole takes its area, and the centroid moves away from it", "[holes]") {
  for (const Points& hole : {small_square, reversed(small_square)}) {
    const PolygonWithHoles holed = object(square, {hole});
    CHECK(holed.area() == 96);
    CHECK(holed.centroid() == Vec2(488.0 / 96, 488.0 / 96));  // 5.083333
    CHECK_FALSE(holed.convex());
    CHECK(holed.outline().convex());
    CHECK(holed.rings_of_holes() == std::vector<Points>{hole});
    CHECK(coverage(holed, {{0, 0}, {5, 0}, {5, 10}, {0, 10}}) == Approx(46.0 / 96));
    CHECK(coverage(holed, {{2, 2}, {4, 2}, {4, 4}, {2, 4}}) == Approx(0).margin(1e-15));
    CHECK(coverage(holed, {{3, 0}, {10, 0}, {10, 10}, {3, 10}}) == Approx(68.0 / 96));
    CHECK(coverage(holed, square) == 1);
  }
}

TEST_CASE("without holes an object is its outline, bit for bit", "[holes]") {
  for (std::uint64_t number = 0; number < 60; ++number) {
    oracle::Problem problem = small_polygons::make_plain_case(number).problem;
    const Document document = document_of(problem);
    const Polygon outline = polygon(document.vertices);
    const PolygonWithHoles made = object(document.vertices, {});
    CHECK(made.boundary() == outline.vertices());
    CHECK(made.area() == outline.area());
    CHECK(made.centroid() == outline.centroid());
    CHECK(made.convex() == outline.convex());
    CHECK(made.holes().empty());
    const Placement by_document = placed(document);
    const auto by_outline =
        place(PolygonWithHoles(outline), document.centre_of_mass, document.settings);
    REQUIRE(by_outline.ok());
    check_same_teams(by_document, *by_outline);
    CHECK(by_document.coverage == by_outline->coverage);
    CHECK(by_document.own_centre == by_document.centre_of_mass);
    CHECK(by_document.weight() == document.settings.weight);
  }
}

TEST_CASE("an error names the holes and edges at fault", "[holes][refusal]") {
  const Points beside = moved(small_square, {4, 0}), corner{{4, 4}, {6, 4}, {6, 6}};
  CHECK(refusal_in_words({small_square, moved(small_square, {-3, 1})}) ==
        "hole 2, edge 1 and the outline's edge 4: the edges cross, touch or overlap");
  CHECK(refusal_in_words({small_square, moved(small_square, {1, 1})}) ==
        "hole 2, edge 4 and hole 1, edge 3: the edges cross, touch or overlap");
  CHECK(refusal_in_words({beside, small_square, corner}) ==
        "hole 3, vertex 1 and hole 2, vertex 3: a hole touches the outline or another hole");
  CHECK(refusal_in_words({small_square, {{0, 0}, {1, 2}, {1, 1}}}) ==
        "hole 2, vertex 1 and the outline's vertex 1: a hole touches the outline or another hole");
  CHECK(refusal_in_words({small_square, square}).find("vertex") != std::string::npos);
  CHECK(refusal_in_words({beside, moved(small_square, {20, 0})}) ==
        "hole 2: the hole lies outside the polygon");
  CHECK(refusal_in_words({{{-1, -1}, {11, -1}, {11, 11}, {-1, 11}}}) ==
        "hole 1: the hole lies outside the polygon");
  CHECK(refusal_in_words({{{2.5, 2.5}, {3, 2.5}, {3, 3}}, small_square}) ==
        "hole 1: the hole lies in hole 2");
  CHECK(refusal_in_words({small_square, {{6, 6}, {8, 8}, {8, 6}, {6, 8}}}) ==
        "hole 2, edges 1 and 3: the edges cross, touch or overlap");
  CHECK(refusal_in_words({{{2, 2}, {4, 4}, {6, 6}}}).find("hole 1: ") == 0);
  CHECK(refusal_in_words({{{2, 2}, {4, 4}}}).find("hole 1: ") == 0);
  CHECK(refusal_in_words({small_square, {{6, 6}, {8, 8}, {6, 6}, {6, 8}}})
            .find("hole 2, vertices 1 and 3: ") == 0);
}

TEST_CASE("a hole may come as near to another ring as doubles can tell", "[holes]") {
  const double below_10 = std::nextafter(10, 0), above_4 = std::nextafter(4, 5);
  const Points touching{{4, 2}, {10, 6}, {4, 6}};
  CHECK_FALSE(PolygonWithHoles::create(polygon(square), {small_square, touching}).ok());
  CHECK(PolygonWithHoles::create(polygon(square),
                                 {small_square, {{above_4, 2}, {below_10, 6}, {above_4, 6}}})
            .ok());
}

TEST_CASE("at most 1,000 holes and 1,048,576 vertices with them", "[holes][refusal][slow]") {
  std::vector<Points> holes;
  for (int i = 0; i < 1001; ++i)
    holes.push_back({{10.0 * i + 1, 1}, {10.0 * i + 2, 1}, {10.0 * i + 1, 2}});
  const Points strip{{0, 0}, {10010, 0}, {10010, 10}, {0, 10}};
  CHECK(refusal(holes, strip).message == "more than 1000 holes");
  holes.pop_back();
  CHECK(object(strip, holes).area() == 100100 - 500);

  const auto wave = [](std::size_t n) {  // a strip of n vertices beneath y = 0.3
    Points points{{10, 0.05}, {0, 0.05}};
    for (std::size_t i = 2; i < n; ++i)
      points.emplace_back(10.0 * static_cast<double>(i) / static_cast<double>(n),
                          i % 2 == 0 ? 0.1 : 0.2);
    return points;
  };
  const Points frame{{-1, -1}, {11, -1}, {11, 1}, {-1, 1}};
  CHECK(PolygonWithHoles::create(polygon(frame), {wave(max_vertices - 4)}).ok());
  const InputError error = refusal({wave(max_vertices - 3)}, frame);
  CHECK(error.code == ErrorCode::too_many_vertices);
  CHECK(error.message == "more than 1048576 vertices together with the holes");
}

TEST_CASE("a point is around a hole only strictly inside it", "[holes]") {
  for (const bool turned : {false, true}) {
    const Points hole = turned ? reversed(small_square) : small_square;
    const PolygonWithHoles holed = object(square, {{{6, 6}, {8, 6}, {6, 8}}, hole});
    CHECK(holed.hole_around({3, 3}) == std::size_t{1});
    CHECK(holed.hole_around({6.5, 7}) == std::size_t{0});
    CHECK(holed.hole_around({std::nextafter(2, 3), 3}) == std::size_t{1});
    for (const Vec2& on_its_rim :
         {Vec2(2, 3), Vec2(4, 3), Vec2(3, 2), Vec2(3, 4), Vec2(2, 2), Vec2(4, 2), Vec2(4, 4),
          Vec2(2, 4), Vec2(6, 6), Vec2(7, 7), Vec2(6, 7), Vec2(6, 8), Vec2(8, 6)}) {
      INFO(on_its_rim.x << ", " << on_its_rim.y);
      CHECK_FALSE(holed.hole_around(on_its_rim));
    }
    CHECK_FALSE(holed.hole_around({std::nextafter(2, 1), 3}));
    CHECK_FALSE(holed.hole_around({1, 2}));
    CHECK_FALSE(holed.hole_around({5, 4}));
  }
}

TEST_CASE("the boundary takes short ways from hole to hole, in whatever order they are listed",
          "[holes]") {
  const auto length_of = [](const Points& ring) {
    double sum = 0;
    for (std::size_t i = 0; i < ring.size(); ++i)
      sum += length(ring[(i + 1) % ring.size()] - ring[i]);
    return sum;
  };
  std::vector<Points> holes;
  for (int i = 0; i < 400; ++i)  // in an order that leaps across the plate
    holes.push_back(moved(small_square, {5.0 * (37 * i % 20), 5.0 * (37 * i % 400 / 20)}));
  const PolygonWithHoles plate = object({{0, 0}, {110, 0}, {110, 110}, {0, 110}}, holes);
  const double rims = 440 + 400 * 8;
  CHECK(length_of(plate.boundary()) - rims < 400 * 2 * 1.5 * 5);
  CHECK(plate.area() == 110 * 110 - 400 * 4);
}

TEST_CASE("neither the direction of a ring, nor where it begins, nor the order of holes matters",
          "[holes][slow]") {
  for (std::uint64_t number = 0; number < 150; ++number) {
    const Document document = numbered_document(number);
    Document other = document;
    std::reverse(other.holes.begin(), other.holes.end());
    for (std::size_t i = 0; i < other.holes.size(); ++i) {
      Points& hole = other.holes[i];
      if (i % 2 == 0) std::reverse(hole.begin(), hole.end());
      std::rotate(hole.begin(), hole.begin() + 1, hole.end());
    }
    const Placement a = placed(document), b = placed(other);
    INFO("case " << number);
    CHECK(a.object.area() == b.object.area());
    CHECK(a.object.centroid() == b.object.centroid());
    check_same_teams(a, b);
    // Only the last bits of a coverage depend on them.
    CHECK(a.coverage == Approx(b.coverage).margin(1e-13 * thinness(a.object)));
  }
}

TEST_CASE("a mirror image has the same area and coverage, and its centroid is mirrored",
          "[holes][slow]") {
  const auto mirrored = [](Points points) {
    for (Vec2& v : points) v.x = -v.x;
    return points;
  };
  for (std::uint64_t number = 0; number < 150; ++number) {
    const Placement p = placed(numbered_document(number));
    std::vector<Points> holes;
    for (const Points& hole : p.object.rings_of_holes()) holes.push_back(mirrored(hole));
    const PolygonWithHoles image = object(mirrored(p.vertices()), holes);
    INFO("case " << number);
    CHECK(image.area() == p.object.area());
    CHECK(Points{image.centroid()} == mirrored({p.object.centroid()}));
    CHECK(coverage(image, reversed(mirrored(p.lifting_base))) ==
          Approx(p.coverage).margin(1e-13 * thinness(image)));
  }
}

TEST_CASE("in units twice as large all numbers of an object are the same bits", "[holes][slow]") {
  for (std::uint64_t number = 0; number < 100; ++number) {
    const Document document = numbered_document(number);
    Document scaled = document;
    for (Vec2& v : scaled.vertices) v *= 0.5;
    for (Points& hole : scaled.holes)
      for (Vec2& v : hole) v *= 0.5;
    *scaled.centre_of_mass *= 0.5;
    const Placement a = placed(document), b = placed(scaled);
    CHECK(b.object.area() == 0.25 * a.object.area());
    CHECK(b.object.centroid() == 0.5 * a.object.centroid());
    CHECK(b.team_candidates == a.team_candidates);
    CHECK(b.coverage == a.coverage);
  }
}

TEST_CASE("an object elsewhere has the same area and coverage", "[holes][slow]") {
  // Coordinates are multiples of 2^-20, even 2^25 away.
  const auto on_grid = [](Points points) {
    for (Vec2& v : points)
      v = {std::ldexp(std::round(std::ldexp(v.x, 20)), -20),
           std::ldexp(std::round(std::ldexp(v.y, 20)), -20)};
    return points;
  };
  int compared = 0;
  for (std::uint64_t number = 0; number < 150; ++number) {
    Document document = numbered_document(number);
    if (bounding_box(document.vertices).diagonal() > 1e3) continue;
    document.vertices = on_grid(document.vertices);
    for (Points& hole : document.holes) hole = on_grid(hole);
    document.centre_of_mass = on_grid({*document.centre_of_mass})[0];
    const auto a = place(document);
    if (!a) continue;  // rounded to a grid
    for (const Vec2& by : {Vec2(0x1p25, 0), Vec2(-0x1p25, 0x1p24)}) {
      Document away = document;
      away.vertices = moved(document.vertices, by);
      for (Points& hole : away.holes) hole = moved(hole, by);
      *away.centre_of_mass += by;
      const Placement b = placed(away);
      INFO("case " << number);
      CHECK(b.object.area() == a->object.area());
      CHECK(length(b.object.centroid() - by - a->object.centroid()) <= 0x1p-27);
      CHECK(b.coverage == Approx(a->coverage).margin(1e-7));
      ++compared;
    }
  }
  CHECK(compared > 100);
}

TEST_CASE("holes a millionth of their size change nothing beyond 10^-12", "[holes][slow]") {
  int compared = 0;
  for (std::uint64_t number = 0; number < 200; ++number) {
    const Document document = numbered_document(number);
    Document shrunk = document, solid = document;
    for (Points& hole : shrunk.holes)
      for (Vec2& v : hole) v = hole.front() + 1e-6 * (v - hole.front());
    solid.holes.clear();
    const auto a = place(shrunk);
    if (!a) {  // two vertices became one, or the hole is below min_diagonal
      CHECK(a.error().place.ring > 0);
      continue;
    }
    const Placement b = placed(solid);
    const double size = b.polygon().diameter();
    INFO("case " << number);
    CHECK(std::fabs(a->object.area() - b.object.area()) <= 1e-12 * b.object.area());
    CHECK(length(a->object.centroid() - b.object.centroid()) <= 1e-12 * size);
    check_same_teams(*a, b);
    CHECK(a->coverage == Approx(b.coverage).margin(1e-12 * thinness(b.object)));
    if (b.teams.empty()) continue;
    const std::vector<std::uint32_t> first{b.team_candidates.front()};
    const auto with = scores(a->object, a->centre_of_mass, a->candidates, first, Metric::area);
    const auto without = scores(b.object, b.centre_of_mass, b.candidates, first, Metric::area);
    for (std::size_t i = 0; i < with.size(); ++i)
      CHECK(std::fabs(with[i] - without[i]) <= 1e-12 * size * size);
    if (b.candidates.size() > 40) continue;
    const auto widest = [](const Placement& p) {
      return widest_choice(p.object, p.centre_of_mass, p.candidates, p.requested_teams,
                           p.team_candidates)
          .coverage;
    };
    CHECK(widest(*a) == Approx(widest(b)).margin(1e-12 * thinness(b.object)));
    ++compared;
  }
  CHECK(compared > 80);
}
