#include "polygon/half_planes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "evenlift/centre_of_mass.h"
#include "evenlift/predicates.h"
#include "exact/dyadic.h"
#include "exact/pseudo_angle.h"
#include "exact/sorted_indices.h"
#include "polygon/corners.h"

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

namespace {

InputError at_centre(ErrorCode code, std::string message) {
  return {code, std::move(message), {Place::Kind::centre_of_mass, 0, 0, {}}};
}

std::optional<InputError> check_coordinates(const Vec2& centre) {
  if (!is_finite(centre))
    return at_centre(ErrorCode::bad_coordinate,
                     "a coordinate of the centre of mass is not a finite number");
  if (max_norm(centre) > max_coordinate)
    return at_centre(ErrorCode::bad_coordinate,
                     "a coordinate of the centre of mass exceeds 1e9 in size");
  if (is_too_near_to_0(centre))
    return at_centre(ErrorCode::bad_coordinate,
                     "a coordinate of the centre of mass is below 1e-100 in size but not 0");
  return std::nullopt;
}

// Far cargo may make numbers overflow; then the point is outside.
bool is_strictly_in_hull(const Polygon& polygon, const Vec2& point) {
  if (!is_finite(point)) return false;
  const Points& hull = polygon.hull();
  for (std::size_t i = 0; i < hull.size(); ++i)
    if (!(orient(hull[i], hull[(i + 1) % hull.size()], point) > 0)) return false;
  return true;
}

}  // namespace

Vec2 with_cargo(const Vec2& own, const Settings& settings) {
  return with_cargo(own, settings, settings.cargo.size()).centre;
}

Result<Vec2> check_centre_of_mass(const Polygon& polygon, const std::optional<Vec2>& given) {
  if (given)
    if (auto error = check_coordinates(*given)) return *std::move(error);
  const Vec2 centre = given.value_or(polygon.centroid());
  if (!is_strictly_in_hull(polygon, centre))
    return at_centre(ErrorCode::centre_outside_hull,
                     "the centre of mass is not inside the convex hull of the polygon");
  return centre;
}

Result<CentreOfMass> centre_of_mass(const PolygonWithHoles& object,
                                    const std::optional<Vec2>& given, const Settings& settings) {
  if (given)
    if (auto error = check_coordinates(*given)) return *std::move(error);
  const Vec2 own = given.value_or(object.centroid());
  const Vec2 all = with_cargo(own, settings);
  if (!is_strictly_in_hull(object, all))
    return at_centre(ErrorCode::centre_outside_hull,
                     settings.cargo.empty()
                         ? "the centre of mass is not inside the convex hull of the polygon"
                         : "with its cargo the centre of mass is not inside the convex hull of the "
                           "polygon");
  return CentreOfMass{own, all};
}

Loaded with_cargo(const Vec2& own, const Settings& settings, std::size_t items) {
  if (items == 0) return {settings.weight, own};
  double weight = settings.weight;
  Vec2 moments;  // about C0
  for (std::size_t i = 0; i < items; ++i) {
    const Cargo& item = settings.cargo[i];
    weight += item.weight;
    moments += item.weight * (item.at - own);
  }
  return {weight, own + moments / weight};
}

}  // namespace evenlift
