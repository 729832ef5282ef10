// What vec.h promises beyond the textbook: NaN, -0, and the order of sums.
#include "evenlift/vec.h"

#include <limits>

#include "kit/catch.h"

using namespace evenlift;

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinite = std::numeric_limits<double>::infinity();

}  // namespace

TEST_CASE("points begin at the origin and are equal if their numbers are", "[vec]") {
  CHECK(Vec2() == Vec2(0, 0));
  CHECK(Vec2(-0.0, 1) == Vec2(0.0, 1));
  CHECK(Vec2(not_a_number, 1) != Vec2(not_a_number, 1));
  CHECK(Vec3() == Vec3(0, 0, 0));
  CHECK(Vec3(1, 2, 3) != Vec3(1, 2, 4));
  Vec2 point(3, 4);
  point[1] = 5;
  CHECK(point == Vec2(3, 5));
  CHECK(point[0] == 3);
}

TEST_CASE("with NaN the first of two points decides", "[vec]") {
  const Vec2 lesser = componentwise_min({not_a_number, 1}, {2, not_a_number});
  CHECK(std::isnan(lesser.x));
  CHECK(lesser.y == 1);
  const Vec2 greater = componentwise_max({2, not_a_number}, {not_a_number, 1});
  CHECK(greater.x == 2);
  CHECK(std::isnan(greater.y));
  CHECK(max_norm({-3, not_a_number}) == 3);
  CHECK(std::isnan(max_norm({not_a_number, 3})));
  CHECK(max_norm({-3, 2}) == 3);
}

TEST_CASE("a point is finite if both of its numbers are", "[vec]") {
  CHECK(is_finite({1e308, -1e308}));
  for (const double value : {not_a_number, infinite, -infinite}) {
    CHECK_FALSE(is_finite({value, 0}));
    CHECK_FALSE(is_finite({0, value}));
  }
}

TEST_CASE("a vector without a length has no other unit vector than itself", "[vec]") {
  CHECK(unit(Vec2(3, 4)) == Vec2(0.6, 0.8));
  CHECK(unit(Vec2(0, 0)) == Vec2(0, 0));
  CHECK(unit(Vec2(1e-200, 0)) == Vec2(1e-200, 0));  // its squared length is 0
  CHECK(unit(Vec3(0, -2, 0)) == Vec3(0, -1, 0));
}

TEST_CASE("sums of three are x + (y + z)", "[vec]") {
  // (1 + 2^-53) + 2^-53 rounds to 1 twice.
  constexpr double half_unit = 0x1p-53;
  CHECK(dot(Vec3(1, half_unit, half_unit), Vec3(1, 1, 1)) == 1 + 0x1p-52);
  CHECK(dot(Vec3(half_unit, half_unit, 1), Vec3(1, 1, 1)) == 1);
  CHECK(one_norm(Vec3(1, -half_unit, half_unit)) == 1 + 0x1p-52);
}

TEST_CASE("a box has its size, its middle, its area and its diagonal", "[vec]") {
  const Box box = bounding_box({{1, 2}, {4, 0}, {2, 4}});
  CHECK(box.low == Vec2(1, 0));
  CHECK(box.high == Vec2(4, 4));
  CHECK(box.size() == Vec2(3, 4));
  CHECK(box.middle() == Vec2(2.5, 2));
  CHECK(box.area() == 12);
  CHECK(box.diagonal() == 5);
  CHECK(bounding_box({}).low == Vec2());
}
