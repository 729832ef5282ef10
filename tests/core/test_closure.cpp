// Grasps solved by hand.
#include "evenlift/closure.h"

#include <cmath>
#include <random>
#include <tuple>

#include "evenlift/tolerance.h"
#include "grasp/grasp.h"
#include "kit/catch.h"
#include "kit/corpus.h"
#include "kit/polygons.h"
#include "polygon/half_planes.h"

using namespace evenlift;
using evenlift::testing::polygon;
using evenlift::testing::square;
using evenlift::testing::u_shape;

TEST_CASE("few and many points have the same contacts", "[closure]") {
  for (const char* name : {"puzzle-piece", "saw", "island", "square", "letter-e"}) {
    const Polygon polygon = testing::polygon(corpus::polygon(name).vertices);
    const double near = near_distance(polygon.diameter());
    std::vector<LiftingPoint> many;
    for (std::uint32_t edge = 0; edge < polygon.size(); ++edge) {
      const Vec2 &from = polygon.edge_start(edge), &to = polygon.edge_end(edge);
      const Vec2 along = (to - from) / length(to - from);
      for (const double way : {0.0, 0.9 * near, 1.1 * near, length(to - from) / 3})
        many.push_back({from + way * along, edge});
    }
    while (many.size() <= 40) many.push_back(many.front());
    std::vector<Contact> one_by_one;
    for (std::uint32_t i = 0; i < many.size(); ++i)
      for (Contact contact : contacts(polygon, {many[i]})) {
        contact.point = i;
        one_by_one.push_back(contact);
      }
    const std::vector<Contact> together = contacts(polygon, many);
    INFO(name);
    REQUIRE(one_by_one.size() == together.size());
    const auto all_of = [](const Contact& c) {
      return std::tuple(c.position.x, c.position.y, c.edge, c.point, c.to_corner, c.in_notch);
    };
    for (std::size_t i = 0; i < together.size(); ++i)
      CHECK(all_of(one_by_one[i]) == all_of(together[i]));
  }
}

TEST_CASE("a robot touches one edge inside it, two at a reflex vertex, none at a convex one",
          "[closure]") {
  const Polygon u = polygon(u_shape);
  const auto number = [&](const Vec2& p, std::uint32_t edge) {
    return contacts(u, {{p, edge}}).size();
  };
  CHECK(number({3, 0}, 0) == 1);
  CHECK(number({0, 0}, 0) == 0);
  CHECK(number({4, 2}, 3) == 2);
  CHECK(number({4, 2.1}, 3) == 1);
  // A point within tau L of a vertex is at it; L = sqrt(52).
  CHECK(number({4, 2 + 7e-9}, 3) == 2);
  CHECK(number({4, 2 + 7.5e-9}, 3) == 1);
  CHECK(number({7e-9, 0}, 0) == 0);
  const Polygon straight = polygon({{0, 0}, {1, 0}, {2, 0}, {2, 2}, {0, 2}});
  CHECK(contacts(straight, {{Vec2(1, 0), 0}}).size() == 1);
  const auto two = contacts(u, {{Vec2(3, 0), 0}, {Vec2(2, 2), 4}});
  REQUIRE(two.size() == 3);
  CHECK(two[0].point == 0);
  CHECK(two[1].point == 1);
  CHECK(two[2].point == 1);
}

TEST_CASE("without a contact everything is free and there is no margin", "[closure]") {
  const Closure c = analyse_closure(polygon(square), {1, 1}, {{Vec2(0, 0), 0}, {Vec2(2, 2), 2}});
  CHECK_FALSE(c.form_closure);
  CHECK_FALSE(c.second_order);
  CHECK_FALSE(c.margin);
  CHECK(c.translation_free);
  CHECK(c.clockwise.has_area);
  CHECK(c.counterclockwise.has_area);
}

TEST_CASE(
    "an object that slides out between two parallel sides is not closed, though both regions are "
    "empty",
    "[closure]") {
  // Four contacts on long sides prevent all rotation but not sliding. The thesis would call this
  // form closure.
  const Polygon rectangle = polygon({{0, 0}, {10, 0}, {10, 2}, {0, 2}});
  const Closure c = analyse_closure(
      rectangle, {5, 1}, {{Vec2(2, 0), 0}, {Vec2(8, 0), 0}, {Vec2(2, 2), 2}, {Vec2(8, 2), 2}});
  CHECK_FALSE(c.clockwise.exists);
  CHECK_FALSE(c.counterclockwise.exists);
  CHECK(c.translation_free);
  REQUIRE(c.translation);
  CHECK(std::fabs(c.translation->x) == 1);
  CHECK(c.translation->y == 0);
  CHECK_FALSE(c.form_closure);
  CHECK_FALSE(c.second_order);
  CHECK(*c.margin == Approx(0).margin(1e-12));
}

TEST_CASE("a rectangle held off the middle of its four sides is closed in one sense each",
          "[closure]") {
  const Polygon p = polygon(square);
  // A pinwheel turns one way only.
  const Closure one = analyse_closure(
      p, {1, 1}, {{Vec2(0.5, 0), 0}, {Vec2(2, 0.5), 1}, {Vec2(1.5, 2), 2}, {Vec2(0, 1.5), 3}});
  CHECK(one.clockwise.exists != one.counterclockwise.exists);
  CHECK_FALSE(one.translation_free);
  CHECK_FALSE(one.form_closure);
  CHECK_FALSE(one.second_order);
  // Two contacts on each of two sides prevent both senses.
  const Closure both = analyse_closure(p, {1, 1},
                                       {{Vec2(0.5, 0), 0},
                                        {Vec2(1.5, 0), 0},
                                        {Vec2(2, 1), 1},
                                        {Vec2(0.5, 2), 2},
                                        {Vec2(1.5, 2), 2},
                                        {Vec2(0, 1), 3}});
  CHECK(both.form_closure);
  CHECK_FALSE(both.second_order);
  CHECK_FALSE(both.translation);
  // The wrenches (0,1,z), (0,-1,z) with z = +-0.5 / sqrt(2), (-1,0,0) and (1,0,0) span a kind of
  // octahedron, with facets |x| + |z| / s <= 1 and so on. Those of x and z are nearest.
  const double s = 0.5 / std::sqrt(2.0);
  CHECK(*both.margin == Approx(1 / std::sqrt(1 + 1 / (s * s))).epsilon(1e-9));
}

TEST_CASE("the midpoints of a square's sides hold it to second order", "[closure]") {
  const Closure c =
      analyse_closure(polygon(square), {1, 1},
                      {{Vec2(1, 0), 0}, {Vec2(2, 1), 1}, {Vec2(1, 2), 2}, {Vec2(0, 1), 3}});
  CHECK_FALSE(c.form_closure);
  CHECK(c.second_order);
  CHECK_FALSE(c.translation_free);
  CHECK(c.clockwise.exists);
  CHECK_FALSE(c.clockwise.has_area);
  REQUIRE(c.clockwise.clipped.size() == 1);
  CHECK(length(c.clockwise.clipped[0] - Vec2(1, 1)) <= 1e-8);
  CHECK(*c.margin == Approx(0).margin(1e-12));
}

TEST_CASE("of two robots on one normal line, each counts to second order", "[closure]") {
  // The robot at (2, 6) has the same wrench as that at (2, 0), which drives the object into the notch
  // at (2, 2).
  Document document;
  document.vertices = {{0, 0}, {0, 4}, {2, 2}, {2, 6}, {0, 6}, {8, 8}, {6, 0}};
  document.centre_of_mass = Vec2(1, 3);
  document.settings.method = Method::distance;
  document.settings.min_ratio = 1;
  document.settings.teams = 4;
  const auto placement = place(document);
  REQUIRE(placement);
  CHECK(placement->closure.second_order);
}

TEST_CASE("the midpoints of an equilateral triangle's sides are the classic case of second order",
          "[closure]") {
  const double h = std::sqrt(3.0);
  const Polygon triangle = polygon({{-1, 0}, {1, 0}, {0, h}});
  const auto held = [&](const Vec2& a) {
    return analyse_closure(triangle, {0, h / 3},
                           {{a, 0}, {Vec2(0.5, h / 2), 1}, {Vec2(-0.5, h / 2), 2}});
  };
  const Closure c = held({0, 0});
  CHECK_FALSE(c.form_closure);
  CHECK(c.second_order);
  CHECK_FALSE(c.translation_free);
  REQUIRE(c.counterclockwise.clipped.size() == 1);
  CHECK(length(c.counterclockwise.clipped[0] - Vec2(0, h / 3)) <= 1e-8);
  // Beside the midpoint the normals do not meet: one sense has a region with an area.
  const Closure off = held({0.1, 0});
  CHECK_FALSE(off.second_order);
  CHECK((off.clockwise.has_area != off.counterclockwise.has_area));
}

TEST_CASE("three contacts of a hexagon hold it to second order, six in closure by their offsets",
          "[closure]") {
  const double h = std::sqrt(3.0) / 2;
  const Polygon hexagon = polygon({{1, 0}, {0.5, h}, {-0.5, h}, {-1, 0}, {-0.5, -h}, {0.5, -h}});
  std::vector<LiftingPoint> middles, offsets;
  for (std::uint32_t i = 0; i < 6; ++i) {
    const Vec2 &a = hexagon.edge_start(i), &b = hexagon.edge_end(i);
    if (i % 2 == 0) middles.push_back({0.5 * (a + b), i});
    // Alternately before and behind the middle.
    const double s = i % 2 ? 0.3 : 0.7;
    offsets.push_back({(1 - s) * a + s * b, i});
  }
  const Closure three = analyse_closure(hexagon, {0, 0}, middles);
  CHECK_FALSE(three.form_closure);
  CHECK(three.second_order);
  const Closure six = analyse_closure(hexagon, {0, 0}, offsets);
  CHECK(six.form_closure);
  CHECK(*six.margin > 0.01);
}

TEST_CASE("a robot in the notch of a reflex vertex pushes on both of its edges", "[closure]") {
  // Two reflex vertices and the two outer walls.
  const Polygon u = polygon(u_shape);
  const Closure hollow = analyse_closure(u, {3, 1.5}, {{Vec2(2, 2), 4}, {Vec2(4, 2), 3}});
  CHECK_FALSE(hollow.form_closure);
  CHECK(hollow.translation_free);  // it can leave upward
  REQUIRE(hollow.translation);
  CHECK(hollow.translation->y < 0);  // the object moves down
  const Closure held =
      analyse_closure(u, {3, 1.5}, {{Vec2(2, 2), 4}, {Vec2(4, 2), 3}, {Vec2(3, 0), 0}});
  CHECK(held.form_closure);
  CHECK(*held.margin > 0.05);
}

TEST_CASE("orientation and the order of robots change nothing in closure", "[closure]") {
  Points reversed = u_shape;
  std::reverse(reversed.begin(), reversed.end());
  const Polygon u = polygon(u_shape), r = polygon(reversed);
  const std::vector<LiftingPoint> points{{Vec2(2, 2), 4}, {Vec2(4, 2), 3}, {Vec2(1, 0), 0}};
  const std::vector<LiftingPoint> others{{Vec2(1, 0), 6}, {Vec2(4, 2), 4}, {Vec2(2, 2), 3}};
  const Closure a = analyse_closure(u, {3, 1.5}, points), b = analyse_closure(r, {3, 1.5}, others);
  CHECK(a.form_closure == b.form_closure);
  CHECK(*a.margin == Approx(*b.margin).epsilon(1e-12));
  CHECK(a.clockwise.exists == b.clockwise.exists);
  CHECK(a.counterclockwise.exists == b.counterclockwise.exists);
}

TEST_CASE("the margin of known wrenches is the distance to the nearest facet", "[closure]") {
  const std::vector<Wrench> octahedron{{1, 0, 0},  {-1, 0, 0}, {0, 1, 0},
                                       {0, -1, 0}, {0, 0, 1},  {0, 0, -1}};
  CHECK(wrench_margin(octahedron) == Approx(1 / std::sqrt(3.0)).epsilon(1e-14));
  const std::vector<Wrench> cube{{1, 1, 1},  {1, 1, -1},  {1, -1, 1},  {1, -1, -1},
                                 {-1, 1, 1}, {-1, 1, -1}, {-1, -1, 1}, {-1, -1, -1}};
  CHECK(wrench_margin(cube) == Approx(1).epsilon(1e-14));
}

TEST_CASE("outside the hull of the wrenches the margin is minus the distance", "[closure]") {
  CHECK(wrench_margin({{3, 4, 0}}) == Approx(-5));
  CHECK(wrench_margin({{1, -1, 0}, {1, 1, 0}}) == Approx(-1));
  CHECK(wrench_margin({{2, -1, -1}, {2, 1, -1}, {2, 0, 3}}) == Approx(-2));
  CHECK(wrench_margin({{1, 0, 0}, {-1, 0, 0}}) == Approx(0).margin(1e-12));
  CHECK(wrench_margin({{1, 0, 0}, {-1, 1, 0}, {-1, -1, 0}}) == Approx(0).margin(1e-12));
}

TEST_CASE("beside a flat hull of wrenches the margin is negative, however rounding tips its facets",
          "[closure]") {
  const Polygon comb = polygon({{0, 0},
                                {5, 0},
                                {3.5, 4},
                                {3, 1},
                                {1.5, 4},
                                {1, 1},
                                {1, 9},
                                {1.5, 6},
                                {3, 9},
                                {3.5, 6},
                                {5, 10},
                                {0, 10}});
  const Closure closure =
      analyse_closure(comb, {1.5, 5.5}, {{{0, 10}, 11}, {{3, 1}, 2}, {{0, 1}, 11}, {{3, 10}, 10}});
  REQUIRE(closure.margin.has_value());
  CHECK(*closure.margin == Approx(-0.23007429954685438).epsilon(1e-9));
  // The wrenches' plane contains the origin, which is outside their hull.
  for (const double tilt : {0.0, 0.1, 0.3, 0.7, 1.1}) {
    const Wrench axis = unit(Wrench(1, 2, 3));
    std::vector<Wrench> flat{{1, -1, 0}, {2, -1, 0}, {2, 1, 0}, {1, 1, 0}};
    for (Wrench& w : flat)
      w = std::cos(tilt) * w + std::sin(tilt) * cross(axis, w) +
          (1 - std::cos(tilt)) * dot(axis, w) * axis;
    INFO("tilted by " << tilt);
    CHECK(wrench_margin(flat) == Approx(-1).epsilon(1e-9));
  }
}

TEST_CASE("a hair beside a flat hull of wrenches the margin is minus that hair", "[closure]") {
  const double hair = 5e-8;
  CHECK(wrench_margin({{hair, 1, 0}, {hair, -1, 0}, {hair, 0, 1}, {hair, 0, -1}}) ==
        Approx(-hair).epsilon(1e-6));
}

TEST_CASE("wrenches that agree except for rounding leave the margin as it is", "[closure][slow]") {
  const std::vector<Wrench> exact{{1, 0, 0},     {-1, 0, 0},     {0, 1, 0},
                                  {0, -1, 0},    {0, 0, 1},      {0, 0, -1},
                                  {0.5, 0.5, 0}, {-0.5, 0, 0.5}, {0.25, 0.75, 0}};
  std::mt19937_64 engine(13);
  for (int i = 0; i < 2000; ++i) {
    std::vector<Wrench> shaken;
    for (int copies = 0; copies < 3; ++copies) {
      for (const Wrench& w : exact) {
        Wrench v = w;
        for (std::size_t k = 0; k < 3; ++k)
          v[k] += static_cast<double>(static_cast<int>(engine() % 7) - 3) * 0x1p-53;
        shaken.push_back(v);
      }
    }
    std::shuffle(shaken.begin(), shaken.end(), engine);
    CHECK(wrench_margin(shaken) == Approx(1 / std::sqrt(3.0)).epsilon(1e-9));
  }
}

TEST_CASE("the margin never changes with the order of the wrenches", "[closure]") {
  std::mt19937_64 engine(14);
  int inside = 0;
  for (int i = 0; i < 500; ++i) {
    std::vector<Wrench> wrenches;
    for (std::size_t k = 0; k < 3 + engine() % 8; ++k) {
      Wrench w;
      for (std::size_t c = 0; c < 3; ++c)
        w[c] = static_cast<double>(static_cast<int>(engine() % 9) - 4) / 4;
      wrenches.push_back(w);
    }
    const double margin = wrench_margin(wrenches);
    inside += margin > 0;
    std::shuffle(wrenches.begin(), wrenches.end(), engine);
    CHECK(wrench_margin(wrenches) == Approx(margin).margin(1e-7));
  }
  CHECK(inside > 30);
}

TEST_CASE("half-planes have a common point if and only if some corner or strip lies in all",
          "[closure]") {
  const auto plane = [](double x, double y, double bound) {
    return HalfPlane{Vec2(0, 0), Vec2(x, y), bound};
  };
  CHECK(have_common_point({}));
  CHECK(have_common_point({plane(1, 0, -5)}));
  CHECK(have_common_point({plane(1, 0, 1), plane(-1, 0, -1)}));  // a line
  CHECK_FALSE(have_common_point({plane(1, 0, 1), plane(-1, 0, std::nextafter(-1.0, -2.0))}));
  CHECK(have_common_point({plane(1, 0, 0), plane(-1, 1, 0), plane(-1, -1, 0)}));  // a point
  CHECK_FALSE(have_common_point({plane(1, 0, 0), plane(-1, 1, 0), plane(-1, -1, -0x1p-1074)}));
  const Points corners =
      bounded_intersection({plane(1, 0, 2), plane(0, 1, 3), plane(-1, 0, 0), plane(0, -1, 0)});
  CHECK(corners.size() == 4);
  CHECK(bounded_intersection({plane(1, 0, 0), plane(0, 1, 3), plane(-1, 0, -1), plane(0, -1, 0)})
            .empty());
}

TEST_CASE("half-planes on a small grid agree with trying all corners", "[closure]") {
  std::mt19937_64 engine(15);
  int with = 0, without = 0;
  for (int i = 0; i < 4000; ++i) {
    const auto pick = [&] { return static_cast<double>(static_cast<int>(engine() % 7) - 3); };
    std::vector<HalfPlane> planes;
    // A box bounds the intersection, which then has corners unless it is empty.
    for (const Vec2& axis : {Vec2(1, 0), Vec2(-1, 0), Vec2(0, 1), Vec2(0, -1)})
      planes.push_back({Vec2(0, 0), axis, 9});
    while (planes.size() < 5 + static_cast<std::size_t>(i % 5)) {
      const double x = pick(), y = pick();
      if (x != 0 || y != 0) planes.push_back({Vec2(0, 0), Vec2(x, y), pick()});
    }
    // Doubles decide small integers exactly: q = (px, py) / d.
    bool expected = false;
    for (std::size_t j = 0; j < planes.size() && !expected; ++j) {
      for (std::size_t k = 0; k < planes.size() && !expected; ++k) {
        const Vec2 a = planes[j].to, b = planes[k].to;
        const double d = cross(a, b);
        if (d <= 0) continue;
        const double px = planes[j].bound * b.y - planes[k].bound * a.y;
        const double py = planes[k].bound * a.x - planes[j].bound * b.x;
        expected = std::all_of(planes.begin(), planes.end(), [&](const HalfPlane& plane) {
          return plane.to.x * px + plane.to.y * py <= plane.bound * d;
        });
      }
    }
    ++(expected ? with : without);
    CHECK(have_common_point(planes) == expected);
  }
  CHECK(with > 500);
  CHECK(without > 500);
}
