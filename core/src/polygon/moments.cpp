#include "polygon/moments.h"

#include <cmath>
#include <limits>

#include "exact/bits.h"
#include "exact/double_double.h"
#include "exact/dyadic.h"

namespace evenlift {
namespace {

// Twice the signed area and six times its first moments, relative to a point. Sums of absolute
// terms bound the rounding errors even if most terms cancel.
struct Sums {
  DoubleDouble doubled_area, x, y;
  double size_area = 0, size_moments = 0;
};

Sums double_double_sums(const Points& vertices, const Vec2& corner) {
  // Products below 2^-969 lose bits. Counting each term as at least this large covers that.
  constexpr double least_size = 0x1p-960;
  Sums sums;
  const auto relative = [&](const Vec2& v) {
    return std::pair(two_difference(v.x, corner.x), two_difference(v.y, corner.y));
  };
  auto [px, py] = relative(vertices.back());
  for (const Vec2& vertex : vertices) {
    const auto [qx, qy] = relative(vertex);
    const DoubleDouble first = px * qy, second = qx * py;
    const DoubleDouble part = first - second;
    sums.doubled_area = sums.doubled_area + part;
    sums.x = sums.x + (px + qx) * part;
    sums.y = sums.y + (py + qy) * part;
    const double size = std::fabs(first.hi) + std::fabs(second.hi) + least_size;
    sums.size_area += size;
    sums.size_moments +=
        size * (std::fabs(px.hi) + std::fabs(qx.hi) + std::fabs(py.hi) + std::fabs(qy.hi)) +
        least_size;
    px = qx;
    py = qy;
  }
  return sums;
}

// About the origin.
struct ExactSums {
  Dyadic doubled_area, x, y;
};

ExactSums exact_sums(const Points& vertices) {
  ExactSums sums;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const Vec2 &p = vertices[i], &q = vertices[i + 1 == vertices.size() ? 0 : i + 1];
    const Dyadic px(p.x), py(p.y), qx(q.x), qy(q.y);
    const Dyadic part = px * qy - qx * py;
    sums.doubled_area = sums.doubled_area + part;
    sums.x = sums.x + (px + qx) * part;
    sums.y = sums.y + (py + qy) * part;
  }
  return sums;
}

// In a tie, the even double. The divisor must not be 0.
double rounded_quotient(const Dyadic& numerator, const Dyadic& divisor) {
  // Each round adds about fifty correct bits. Then the exact quotient is between this one and a
  // neighbour.
  double quotient = 0;
  for (int i = 0; i < 3; ++i)
    quotient += approximate_quotient(numerator - Dyadic(quotient) * divisor, divisor);
  const int side = (numerator - Dyadic(quotient) * divisor).sign() * divisor.sign();
  if (side == 0) return quotient;
  const double neighbour = std::nextafter(quotient, side * std::numeric_limits<double>::infinity());
  const Dyadic twice_middle = Dyadic(quotient) + Dyadic(neighbour);
  const int beyond =
      side * (numerator + numerator - twice_middle * divisor).sign() * divisor.sign();
  if (beyond == 0) return (to_bits(quotient) & 1) == 0 ? quotient : neighbour;
  return beyond > 0 ? neighbour : quotient;
}

Moments exact_moments(const Points& vertices) {
  const ExactSums sums = exact_sums(vertices);
  const Dyadic divisor = Dyadic(3.0) * sums.doubled_area;
  return {std::fabs(rounded_quotient(sums.doubled_area, Dyadic(2.0))),
          {rounded_quotient(sums.x, divisor), rounded_quotient(sums.y, divisor)}};
}

}  // namespace

// The sums are in double-double, relative to a corner of the bounding box: polygons far from the
// origin lose no digits. If the error bound allows several doubles, as for thin polygons and
// centroids near 0, exact sums decide.
Moments moments(const Points& vertices, const Vec2& corner) {
  const Sums sums = double_double_sums(vertices, corner);
  const DoubleDouble divisor = DoubleDouble(3.0) * sums.doubled_area;
  const DoubleDouble x = sums.x / divisor + DoubleDouble(corner.x);
  const DoubleDouble y = sums.y / divisor + DoubleDouble(corner.y);

  // Each operation errs by at most 2^-100 of its operands, and a sum has fewer than 2^22
  // operations.
  constexpr double unit = 0x1p-78;
  const double size = std::fabs(divisor.hi);
  const double reach = std::fabs(sums.x.hi / size) + std::fabs(sums.y.hi / size);
  const double error_bound = unit * (sums.size_moments / size + reach * (sums.size_area / size) +
                                     reach + std::fabs(corner.x) + std::fabs(corner.y));
  const auto is_certain = [](const DoubleDouble& value, double bound) {
    return value.hi + (value.lo - bound) == value.hi && value.hi + (value.lo + bound) == value.hi;
  };
  if (is_certain(x, error_bound) && is_certain(y, error_bound) &&
      is_certain(sums.doubled_area, unit * sums.size_area))
    return {0.5 * std::fabs(sums.doubled_area.to_double()), {x.to_double(), y.to_double()}};
  return exact_moments(vertices);
}

}  // namespace evenlift
