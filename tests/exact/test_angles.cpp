// Our sine, cosine and arctangent against the library's in long double.
#include "evenlift/angles.h"

#include <cmath>
#include <random>

#include "kit/catch.h"

using namespace evenlift;

namespace {

// The header's promise: units in the last place of 1, or of an arctangent above 1.
constexpr double four_units = 4 * 0x1p-52;

double uniform(std::mt19937_64& engine, double low, double high) {
  return low + (high - low) * static_cast<double>(engine() >> 11) * 0x1p-53;
}

}  // namespace

TEST_CASE("sine and cosine are right to four units in the last place", "[angles]") {
  std::mt19937_64 engine(5);
  for (int i = 0; i < 60000; ++i) {
    const double range = i % 3 == 0 ? 4.0 : i % 3 == 1 ? 100.0 : 1e5;
    const double angle = uniform(engine, -range, range);
    const double s =
        std::fabs(static_cast<double>(std::sin(static_cast<long double>(angle)) - sine(angle)));
    const double c =
        std::fabs(static_cast<double>(std::cos(static_cast<long double>(angle)) - cosine(angle)));
    if (s <= four_units && c <= four_units) continue;
    INFO(std::hexfloat << angle);
    CHECK(s <= four_units);
    CHECK(c <= four_units);
  }
}

TEST_CASE("sine and cosine keep their precision next to multiples of a right angle", "[angles]") {
  for (int k = -2000; k <= 2000; ++k) {
    for (const double hair : {0.0, 1e-12, -1e-9, 1e-5}) {
      const double angle = k * (pi / 2) + hair;
      INFO(k << " right angles and " << hair);
      CHECK(std::fabs(static_cast<double>(std::sin(static_cast<long double>(angle)) -
                                          sine(angle))) <= four_units);
      CHECK(std::fabs(static_cast<double>(std::cos(static_cast<long double>(angle)) -
                                          cosine(angle))) <= four_units);
    }
  }
}

TEST_CASE("sine is odd, cosine even, and both lie on the circle", "[angles]") {
  std::mt19937_64 engine(6);
  for (int i = 0; i < 5000; ++i) {
    const double angle = uniform(engine, 0, 10);
    CHECK(sine(-angle) == -sine(angle));
    CHECK(cosine(-angle) == cosine(angle));
    CHECK(std::fabs(sine(angle) * sine(angle) + cosine(angle) * cosine(angle) - 1) <=
          2 * four_units);
  }
  CHECK(sine(0) == 0);
  CHECK(cosine(0) == 1);
}

TEST_CASE("the arctangent is right to four units in the last place in every quadrant", "[angles]") {
  std::mt19937_64 engine(7);
  for (int i = 0; i < 60000; ++i) {
    const double size = std::ldexp(1.0, static_cast<int>(engine() % 600) - 300);
    const double flat = std::ldexp(1.0, -static_cast<int>(engine() % 60));
    double x = size * uniform(engine, -1, 1), y = flat * size * uniform(engine, -1, 1);
    if (i % 2) std::swap(x, y);
    const long double expected =
        std::atan2(static_cast<long double>(y), static_cast<long double>(x));
    const double error = std::fabs(static_cast<double>(expected - arctangent2(y, x)));
    if (error <= 2 * four_units) {
      // Above 2, the last place is twice that of 1.
      if (std::fabs(static_cast<double>(expected)) < 2) CHECK(error <= four_units);
      continue;
    }
    INFO(std::hexfloat << y << " " << x);
    CHECK(error <= 2 * four_units);
  }
}

TEST_CASE("the arctangent of the axes is exact, pi on the left from both sides", "[angles]") {
  CHECK(arctangent2(0, 0) == 0);
  CHECK(arctangent2(0, 5) == 0);
  CHECK(arctangent2(5, 0) == pi / 2);
  CHECK(arctangent2(0, -5) == pi);
  CHECK(arctangent2(-0.0, -5) == pi);
  CHECK(arctangent2(-5, 0) == -pi / 2);
  CHECK(arctangent2(3, 3) == Approx(pi / 4).epsilon(1e-15));
}
