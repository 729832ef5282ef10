// Holes that touch or overlap, as files for cutters have them.
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "evenlift/generate.h"
#include "evenlift/hull.h"
#include "evenlift/import.h"
#include "evenlift/plane.h"
#include "evenlift/polygon_with_holes.h"
#include "evenlift/random.h"
#include "import/joining/joining.h"
#include "kit/catch.h"
#include "kit/imported.h"

using namespace evenlift;
using evenlift::testing::read;

namespace {

Points rectangle(double x, double y, double width, double height) {
  return {{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}};
}

// The cells of a grid from 0 to 12 that the rectangles cover or enclose.
int covered_or_enclosed(const std::vector<Points>& rectangles) {
  constexpr int n = 14;
  std::vector<char> covered(n * n), outside(n * n);
  for (const Points& each : rectangles)
    for (int x = static_cast<int>(each[0].x); x < static_cast<int>(each[2].x); ++x)
      for (int y = static_cast<int>(each[0].y); y < static_cast<int>(each[2].y); ++y)
        covered[static_cast<std::size_t>((y + 1) * n + x + 1)] = 1;
  std::vector<int> next = {0};
  outside[0] = 1;
  while (!next.empty()) {
    const int at = next.back(), x = at % n, y = at / n;
    next.pop_back();
    const auto visit = [&](int to, bool exists) {
      if (!exists || outside[static_cast<std::size_t>(to)] || covered[static_cast<std::size_t>(to)])
        return;
      outside[static_cast<std::size_t>(to)] = 1;
      next.push_back(to);
    };
    visit(at - 1, x > 0);
    visit(at + 1, x + 1 < n);
    visit(at - n, y > 0);
    visit(at + n, y + 1 < n);
  }
  return n * n - static_cast<int>(std::count(outside.begin(), outside.end(), 1));
}

double area_of(const std::vector<Points>& rings) {
  double area = 0;
  for (const Points& ring : rings) area += std::abs(signed_area(ring));
  return area;
}

}  // namespace

TEST_CASE("holes that touch or overlap are united, with what they enclose", "[import][holes]") {
  Rng random(54);
  for (int round = 0; round < 3000; ++round) {
    std::vector<Points> holes;
    const std::size_t count = 2 + random.below(9);
    for (std::size_t i = 0; i < count; ++i) {
      const double x = static_cast<double>(random.below(10)),
                   y = static_cast<double>(random.below(10));
      Points ring = rectangle(x, y, 1 + static_cast<double>(random.below(3)),
                              1 + static_cast<double>(random.below(3)));
      if (random.below(2) == 0) std::reverse(ring.begin(), ring.end());
      holes.push_back(std::move(ring));
    }
    // One within another is a part in a hole, which nesting separates before.
    const auto within = [&](const Points& a, const Points& b) {
      const Box inner = bounding_box(a), outer = bounding_box(b);
      return &a != &b && inner.low.x >= outer.low.x && inner.low.y >= outer.low.y &&
             inner.high.x <= outer.high.x && inner.high.y <= outer.high.y;
    };
    std::vector<Points> kept;
    for (const Points& hole : holes)
      if (std::none_of(holes.begin(), holes.end(),
                       [&](const Points& other) { return within(hole, other); }))
        kept.push_back(hole);
    if (kept.size() < 2) continue;
    const Uniting uniting = unite_touching(kept);
    CAPTURE(round, kept.size());
    const auto plate = Polygon::create(rectangle(-1, -1, 14, 14));
    REQUIRE(PolygonWithHoles::create(*plate, uniting.rings));
    std::vector<Points> upright = kept;
    for (Points& ring : upright)
      if (signed_area(ring) < 0) std::reverse(ring.begin(), ring.end());
    for (Points& ring : upright)
      ring = rectangle(bounding_box(ring).low.x, bounding_box(ring).low.y,
                       bounding_box(ring).size().x, bounding_box(ring).size().y);
    REQUIRE(std::abs(area_of(uniting.rings) - covered_or_enclosed(upright)) < 1e-3);
  }
}

TEST_CASE("a point in one of several holes that cross is in one of the united holes",
          "[import][holes]") {
  Rng random(55);
  for (int round = 0; round < 500; ++round) {
    std::vector<Points> holes;
    const std::size_t count = 2 + random.below(6);
    for (std::size_t i = 0; i < count; ++i) {
      const Vec2 middle((-5 + (5 - (-5)) * random.uniform()), (-5 + (5 - (-5)) * random.uniform()));
      Points ring = *generate(Family::regular, 3 + random.below(30), 1);
      const Box box = bounding_box(ring);
      for (Vec2& p : ring) p = middle + 6 / box.size().x * (p - box.middle());
      holes.push_back(std::move(ring));
    }
    const Uniting uniting = unite_touching(holes);
    const auto plate = Polygon::create(rectangle(-20, -20, 40, 40));
    CAPTURE(round);
    REQUIRE(PolygonWithHoles::create(*plate, uniting.rings));
    for (int sample = 0; sample < 100; ++sample) {
      const Vec2 at((-8 + (8 - (-8)) * random.uniform()), (-8 + (8 - (-8)) * random.uniform()));
      const auto in = [&](const std::vector<Points>& rings) {
        return std::any_of(rings.begin(), rings.end(),
                           [&](const Points& ring) { return inside(ring, at); });
      };
      if (in(holes)) REQUIRE(in(uniting.rings));
      if (count == 2) REQUIRE(in(holes) == in(uniting.rings));
    }
  }
}

TEST_CASE("a plate whose cut-outs touch or overlap is read with one hole, and says so",
          "[import][holes]") {
  const std::string overlapping = "M20 20H40V40H20Z M30 30H60V50H30Z",
                    side_by_side = "M20 20H40V40H20Z M40 20H60V40H40Z",
                    corner_to_corner = "M20 20H40V40H20Z M40 40H60V50H40Z";
  for (const auto& [holes, area] : {std::pair(overlapping, 900.0), std::pair(side_by_side, 800.0),
                                    std::pair(corner_to_corner, 600.0)}) {
    for (const std::string look : {"fill='none' stroke='red'", "fill-rule='evenodd'"}) {
      CAPTURE(holes, look);
      const Import import = read("<svg xmlns='http://www.w3.org/2000/svg'><path " + look +
                                 " d='M0 0H100V60H0Z " + holes + "'/></svg>");
      REQUIRE(import.shapes.size() == 1);
      REQUIRE(import.shapes[0].document.holes.size() == 1);
      CHECK(std::abs(area_of(import.shapes[0].document.holes) - area) < 1e-3);
      CHECK(std::count(import.notes.begin(), import.notes.end(),
                       "2 holes that touch or overlap were united") == 1);
    }
  }
  const Import geojson = read(
      "{\"type\":\"Polygon\",\"coordinates\":[[[0,0],[100,0],[100,60],[0,60],[0,0]],"
      "[[20,20],[20,40],[40,40],[40,20],[20,20]],[[30,30],[30,50],[60,50],[60,30],[30,30]]]}");
  REQUIRE(geojson.shapes[0].document.holes.size() == 1);
}

TEST_CASE("rings with too many meetings stay as they are", "[import][holes]") {
  // Two combs across each other.
  Points comb = {{0, 0}}, across;
  for (int i = 0; i < 400; ++i) {
    comb.emplace_back(i, 0.5);
    comb.emplace_back(i, 400);
    comb.emplace_back(i + 0.5, 400);
    comb.emplace_back(i + 0.5, 0.5);
  }
  comb.emplace_back(400, 0);
  for (const Vec2& p : comb) across.emplace_back(p.y - 1, p.x + 2);
  const Uniting uniting = unite_touching({comb, across});
  CHECK(uniting.united == 0);
  CHECK(uniting.rings == std::vector<Points>{comb, across});
}
