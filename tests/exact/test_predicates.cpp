// Against rationals: signs are exact and values accurate to 2^-45, for ordinary, nearly degenerate,
// huge and subnormal coordinates.
#include "evenlift/predicates.h"

#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "exact/dyadic.h"
#include "exact/pseudo_angle.h"
#include "kit/catch.h"
#include "kit/property.h"
#include "oracle/rational.h"

using namespace evenlift;

namespace {

using oracle::abs;
using oracle::Rational;

Rational exact(double x) { return x; }

// Whether the sign is exact and the value accurate to 2^-45, or to the smallest doubles.
bool right(double value, const Rational& expected) {
  if (expected == 0) return value == 0;
  if ((value > 0) != (expected > 0) || value == 0) return false;
  if (std::fabs(value) < 0x1p-1000) return abs(expected) < exact(0x1p-999);
  return abs(exact(value) - expected) * 0x1p45 <= abs(expected);
}

struct Exact {
  explicit Exact(const Vec2& p) : x(exact(p.x)), y(exact(p.y)) {}
  Rational x, y;
};

Rational exact_cross(const Vec2& a0, const Vec2& a1, const Vec2& b0, const Vec2& b1) {
  const Exact p(a0), q(a1), r(b0), s(b1);
  return (q.x - p.x) * (s.y - r.y) - (q.y - p.y) * (s.x - r.x);
}
Rational exact_dot(const Vec2& a0, const Vec2& a1, const Vec2& b0, const Vec2& b1) {
  const Exact p(a0), q(a1), r(b0), s(b1);
  return (q.x - p.x) * (s.x - r.x) + (q.y - p.y) * (s.y - r.y);
}
Rational exact_mirrored(const Vec2& centre, const Vec2& w, const Vec2& b, const Vec2& c) {
  const Exact m(centre), e(w), p(b), q(c);
  const Rational x = 2 * m.x - e.x, y = 2 * m.y - e.y;
  return (p.x - x) * (q.y - p.y) - (p.y - y) * (q.x - p.x);
}

struct Four {
  Vec2 a, b, c, d;
};

struct Tally {
  int positive = 0, negative = 0, zero = 0;
  void add(double value) { ++(value > 0 ? positive : value < 0 ? negative : zero); }
};

// All four predicates, on quadruples.
template <class Make>
Tally check_all(Make make, int number) {
  std::mt19937_64 engine(12345);
  Tally tally;
  for (int i = 0; i < number; ++i) {
    const auto [a, b, c, d] = make(engine);
    const bool all_right = right(orient(a, b, c), exact_cross(a, b, a, c)) &&
                           right(cross_of_differences(a, b, c, d), exact_cross(a, b, c, d)) &&
                           right(dot_of_differences(a, b, c, d), exact_dot(a, b, c, d)) &&
                           right(orient_mirrored(a, b, c, d), exact_mirrored(a, b, c, d));
    tally.add(orient(a, b, c));
    if (all_right) continue;
    INFO(std::hexfloat << "a " << a.x << " " << a.y << ", b " << b.x << " " << b.y << ", c " << c.x
                       << " " << c.y << ", d " << d.x << " " << d.y);
    CHECK(right(orient(a, b, c), exact_cross(a, b, a, c)));
    CHECK(right(cross_of_differences(a, b, c, d), exact_cross(a, b, c, d)));
    CHECK(right(dot_of_differences(a, b, c, d), exact_dot(a, b, c, d)));
    CHECK(right(orient_mirrored(a, b, c, d), exact_mirrored(a, b, c, d)));
  }
  return tally;
}

double unit(std::mt19937_64& engine) { return static_cast<double>(engine() >> 11) * 0x1p-52 - 1; }
Vec2 point(std::mt19937_64& engine, double size) {
  const double x = size * unit(engine);
  return {x, size * unit(engine)};
}
int below(std::mt19937_64& engine, int n) {
  return static_cast<int>(engine() % static_cast<unsigned>(n));
}

// x or a neighbouring double.
double nudged(double x, std::mt19937_64& engine) {
  switch (below(engine, 3)) {
    case 0:
      return std::nextafter(x, -1e300);
    case 1:
      return std::nextafter(x, 1e300);
    default:
      return x;
  }
}
Vec2 nudged(const Vec2& p, std::mt19937_64& engine) {
  const double x = nudged(p.x, engine);
  return {x, nudged(p.y, engine)};
}

}  // namespace

TEST_CASE("predicates are right on points anywhere, of any size", "[predicates][slow]") {
  for (const double size :
       {1.0, 1e9, 1e-9, 1e-100, 1e-150, 1e-160, 1e-250, 1e-300, 1e-310, 0x1p-1070}) {
    INFO(size);
    const Tally tally = check_all(
        [&](std::mt19937_64& e) {
          const Vec2 a = point(e, size), b = point(e, size), c = point(e, size);
          return Four{a, b, c, point(e, size)};
        },
        400);
    CHECK(tally.positive > 50);
    CHECK(tally.negative > 50);
  }
}

TEST_CASE("predicates are right where sizes differ wildly", "[predicates][slow]") {
  const auto any = [](std::mt19937_64& e) {
    const double x = std::ldexp(unit(e), -below(e, 1070) + 29);
    return Vec2(x, std::ldexp(unit(e), -below(e, 1070) + 29));
  };
  const Tally tally = check_all(
      [&](std::mt19937_64& e) {
        const Vec2 a = any(e), b = any(e), c = any(e);
        return Four{a, b, c, any(e)};
      },
      3000);
  CHECK(tally.positive > 500);
  CHECK(tally.negative > 500);
}

TEST_CASE("predicates are right on points that are nearly in line", "[predicates][slow]") {
  for (const double size : {1.0, 1e9, 1e-9, 1e-140, 1e-200, 1e-300}) {
    INFO(size);
    const Tally tally = check_all(
        [&](std::mt19937_64& e) {
          // Multiples of one step, nudged by a unit in the last place.
          const Vec2 origin = point(e, size), step = point(e, size / 16);
          const auto along = [&] {
            const double k = below(e, 15) - 7;
            return nudged(origin + k * step, e);
          };
          const Vec2 a = along(), b = along(), c = along();
          return Four{a, b, c, along()};
        },
        1500);
    CHECK(tally.positive > 100);
    CHECK(tally.negative > 100);
    CHECK(tally.zero > 20);
  }
}

TEST_CASE("predicates are right on points that mirror each other almost exactly",
          "[predicates][slow]") {
  int zeros = 0;
  check_all(
      [&](std::mt19937_64& e) {
        // The mirror image of b at a is on the line of c and d, or next to it.
        const double scale = std::ldexp(1.0, -40 * below(e, 8));
        const Vec2 a = point(e, scale), b = point(e, scale), mirrored = 2 * a - b;
        const Vec2 step = point(e, scale);
        const Vec2 c = nudged(mirrored + step, e), d = nudged(mirrored - 2.0 * step, e);
        zeros += orient_mirrored(a, b, c, d) == 0;
        return Four{a, b, c, d};
      },
      4000);
  check_all(
      [&](std::mt19937_64& e) {
        const Vec2 a(below(e, 9), below(e, 9)), b(below(e, 9), below(e, 9)),
            c(below(e, 9), below(e, 9));
        const Vec2 d(below(e, 9), below(e, 9));
        zeros += orient_mirrored(a, b, c, d) == 0;
        return Four{a, b, c, d};
      },
      3000);
  CHECK(zeros > 100);
}

TEST_CASE("a sum that rounds to 0 still counts where a point is mirrored", "[predicates]") {
  // Relative to C, one coordinate is 1 - 1e-17 in b and -1 - 1e-17 in w.
  CHECK(orient_mirrored(Vec2(0, 1e-17), Vec2(5, -1), Vec2(0, 1), Vec2(1, 1)) == 2e-17);
  CHECK(orient_mirrored(Vec2(1e-17, 0), Vec2(-1, 5), Vec2(1, 0), Vec2(1, 1)) == -2e-17);
}

TEST_CASE("predicates see on which side a unit in the last place lies", "[predicates]") {
  const Vec2 a(0.1, 0.1), b(0.3, 0.3), on(0.7, 0.7);
  CHECK(orient(a, b, on) == 0);
  CHECK(orient(a, b, Vec2(0.7, std::nextafter(0.7, 1))) > 0);
  CHECK(orient(a, b, Vec2(0.7, std::nextafter(0.7, 0))) < 0);
  CHECK(orient(Vec2(1e9, 1e9), Vec2(-1e9, -1e9), Vec2(0x1p-1074, 0)) > 0);
  CHECK(orient(Vec2(0, 0), Vec2(0x1p-1074, 0), Vec2(0, 0x1p-1074)) > 0);
  CHECK(orient(Vec2(0, 0), Vec2(1, 0), Vec2(0, 1)) == 1);
  CHECK(dot_of_differences(Vec2(0, 0), Vec2(1, 1), Vec2(0, 0), Vec2(1, -1)) == 0);
}

TEST_CASE("dyadic numbers add, subtract and multiply exactly", "[predicates]") {
  property::holds([](std::int64_t m, std::int64_t n, std::int64_t o) {
    const int i = *rc::gen::inRange(-1000, 900), j = *rc::gen::inRange(-1000, 900);
    const double x = std::ldexp(static_cast<double>(m), i),
                 y = std::ldexp(static_cast<double>(n), j);
    const double z = static_cast<double>(o);
    const Dyadic dx(x), dy(y), dz(z);
    const Rational ex = exact(x), ey = exact(y), ez = exact(z);
    const auto sign = [](const Rational& r) { return (r > 0) - (r < 0); };
    RC_ASSERT((dx * dy - dz).sign() == sign(ex * ey - ez));
    RC_ASSERT((dx + dy * dz - dx).sign() == sign(ey * ez));
    RC_ASSERT(((dx + dy) * (dx - dy) - (dx * dx - dy * dy)).sign() == 0);
    RC_ASSERT((-dx + dx).sign() == 0);
    if (std::isnormal(x)) RC_ASSERT(dx.to_double() == x);
    const Rational sum = ex + ey;
    const double rounded = (dx + dy).to_double();
    RC_ASSERT(abs(exact(rounded) - sum) * 0x1p52 <= abs(sum) + exact(0x1p-1020));
  });
}

TEST_CASE("a dyadic number beyond the doubles keeps its sign as the last of them", "[predicates]") {
  const Dyadic tiny(0x1p-1074), huge(0x1p1000);
  CHECK((tiny * tiny).to_double() == 0x1p-1074);
  CHECK((-(tiny * tiny)).to_double() == -0x1p-1074);
  CHECK((huge * huge).to_double() == std::numeric_limits<double>::max());
  CHECK((huge * -huge).to_double() == -std::numeric_limits<double>::max());
  CHECK(Dyadic(0.0).sign() == 0);
  CHECK(Dyadic(-0.0).to_double() == 0);
}

TEST_CASE("double-double sums and products of two doubles are exact", "[predicates][slow]") {
  std::mt19937_64 engine(7);
  for (int i = 0; i < 5000; ++i) {
    const double a = std::ldexp(unit(engine), below(engine, 80) - 40);
    const double b = std::ldexp(unit(engine), below(engine, 80) - 40);
    const DoubleDouble sum = two_sum(a, b), difference = two_difference(a, b),
                       product = two_product(a, b);
    const bool all = exact(sum.hi) + exact(sum.lo) == exact(a) + exact(b) &&
                     exact(difference.hi) + exact(difference.lo) == exact(a) - exact(b) &&
                     exact(product.hi) + exact(product.lo) == exact(a) * exact(b);
    if (all && std::fabs(sum.lo) <= 0x1p-53 * std::fabs(sum.hi)) continue;
    INFO(std::hexfloat << a << " " << b);
    CHECK(all);
    CHECK(std::fabs(sum.lo) <= 0x1p-53 * std::fabs(sum.hi));
  }
}

TEST_CASE("double-double arithmetic keeps a hundred bits", "[predicates]") {
  std::mt19937_64 engine(8);
  const auto value = [](const DoubleDouble& d) { return Rational(exact(d.hi) + exact(d.lo)); };
  const auto close = [&](const DoubleDouble& given, const Rational& expected,
                         const Rational& size) {
    return abs(value(given) - expected) * 0x1p98 <= size;
  };
  for (int i = 0; i < 2000; ++i) {
    const DoubleDouble a = two_product(unit(engine), unit(engine)),
                       b = two_product(unit(engine), unit(engine));
    const Rational ea = value(a), eb = value(b);
    CHECK(close(a + b, ea + eb, abs(ea) + abs(eb)));
    CHECK(close(a - b, ea - eb, abs(ea) + abs(eb)));
    CHECK(close(a * b, ea * eb, abs(ea * eb)));
    if (eb != 0) CHECK(close(a / b, ea / eb, abs(ea / eb)));
  }
}
