#include "polygon/moments.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "evenlift/centre_of_mass.h"
#include "evenlift/predicates.h"
#include "exact/bits.h"
#include "exact/double_double.h"
#include "exact/dyadic.h"
#include "exact/sorted_indices.h"
#include "polygon/ring_sweep.h"

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

namespace {

using Indices = std::vector<std::size_t>;

double normals_cross(const HalfPlane& a, const HalfPlane& b) {
  return cross_of_differences(a.from, a.to, b.from, b.to);
}

bool normals_are_same(const HalfPlane& a, const HalfPlane& b) {
  return normals_cross(a, b) == 0 && dot_of_differences(a.from, a.to, b.from, b.to) > 0;
}

// Whether the normal's direction is in [0, 180) degrees. Exact, since it compares coordinates.
bool points_up(const HalfPlane& a) {
  return a.to.y > a.from.y || (a.to.y == a.from.y && a.to.x > a.from.x);
}

struct ExactNormal {
  explicit ExactNormal(const HalfPlane& a)
      : x(Dyadic(a.to.x) - Dyadic(a.from.x)), y(Dyadic(a.to.y) - Dyadic(a.from.y)) {}
  Dyadic x, y;
};

Dyadic exact_cross(const ExactNormal& a, const ExactNormal& b) { return a.x * b.y - a.y * b.x; }

// A floating-point filter: the terms of the sum below have relative errors below 2^-44, so the sum
// has the right sign if above this fraction of the sum of absolute values.
constexpr double filter_threshold = 0x1p-40;
// Smaller products may underflow, which breaks the error bound.
constexpr double smallest_safe = 1e-250;

// The exact sign of the determinant of the rows (normal, bound). If the normals of i and j turn
// left, it is positive if their corner is inside k.
int corner_side(const HalfPlane& i, const HalfPlane& j, const HalfPlane& k) {
  const double terms[] = {i.bound * normals_cross(j, k), -j.bound * normals_cross(i, k),
                          k.bound * normals_cross(i, j)};
  const double sum = terms[0] + terms[1] + terms[2];
  const double size = std::fabs(terms[0]) + std::fabs(terms[1]) + std::fabs(terms[2]);
  if (std::fabs(sum) > filter_threshold * size && size > smallest_safe) return sum > 0 ? 1 : -1;
  const ExactNormal ni(i), nj(j), nk(k);
  return (Dyadic(i.bound) * exact_cross(nj, nk) - Dyadic(j.bound) * exact_cross(ni, nk) +
          Dyadic(k.bound) * exact_cross(ni, nj))
      .sign();
}

// The normal's 1-norm; for parallel normals, proportional to the length.
Dyadic exact_size(const HalfPlane& a) {
  const ExactNormal n(a);
  return (n.x.sign() < 0 ? -n.x : n.x) + (n.y.sign() < 0 ? -n.y : n.y);
}

// The sign of a.bound |b| + sign b.bound |a|, where |a| is the normal's 1-norm.
int compare_scaled_bounds(const HalfPlane& a, const HalfPlane& b, int sign) {
  const auto rough_size = [](const HalfPlane& c) {
    return std::fabs(c.to.x - c.from.x) + std::fabs(c.to.y - c.from.y);
  };
  const double first = a.bound * rough_size(b), second = sign * (b.bound * rough_size(a));
  const double sum = first + second, size = std::fabs(first) + std::fabs(second);
  if (std::fabs(sum) > filter_threshold * size && size > smallest_safe) return sum > 0 ? 1 : -1;
  const Dyadic exact_first = Dyadic(a.bound) * exact_size(b),
               exact_second = Dyadic(b.bound) * exact_size(a);
  return (sign > 0 ? exact_first + exact_second : exact_first - exact_second).sign();
}

// Compares how far out the lines are, for normals of one direction: -1, 0 or 1.
int compare_bounds(const HalfPlane& a, const HalfPlane& b) {
  return compare_scaled_bounds(a, b, -1);
}

// For half-planes with opposite normals.
int strip_width_sign(const HalfPlane& a, const HalfPlane& b) {
  return compare_scaled_bounds(a, b, 1);
}

// The tightest half-plane of each direction, sorted by normal.
Indices by_direction(const std::vector<HalfPlane>& planes) {
  const auto goes_before = [&](std::uint32_t i, std::uint32_t j) {
    const bool up_i = points_up(planes[i]), up_j = points_up(planes[j]);
    if (up_i != up_j) return up_i;
    return normals_cross(planes[i], planes[j]) > 0;
  };
  Indices tightest;
  for (const std::uint32_t i : sorted_indices(planes.size(), goes_before)) {
    if (tightest.empty() || !normals_are_same(planes[tightest.back()], planes[i])) {
      tightest.push_back(i);
    } else if (compare_bounds(planes[i], planes[tightest.back()]) < 0) {
      tightest.back() = i;
    }
  }
  return tightest;
}

// Whether the angle from i's normal counter-clockwise to j's falls short of 180 degrees by an angle
// whose sine is at most `sine`. `side` > 0 is the normals' cross product.
bool nearly_opposite(const HalfPlane& i, const HalfPlane& j, double side, double sine) {
  const Vec2 ni = i.normal(), nj = j.normal();
  return dot(ni, nj) < 0 && side <= sine * length(ni) * length(nj);
}

NormalGap widest_gap(const std::vector<HalfPlane>& planes, const Indices& order, double sine) {
  if (order.size() == 1) return {order[0], order[0], 1};
  NormalGap widest{order[0], order[1], -1};
  for (std::size_t k = 0; k < order.size(); ++k) {
    const std::size_t i = order[k], j = order[(k + 1) % order.size()];
    const double side = normals_cross(planes[i], planes[j]);
    // No neighbours have the same direction, so if they do not turn, they are opposite.
    int compared = side > 0 ? -1 : side < 0 ? 1 : 0;
    if (side > 0 && nearly_opposite(planes[i], planes[j], side, sine)) compared = 0;
    if (compared > widest.compare_to_half_turn) widest = {i, j, compared};
  }
  return widest;
}

// The half-planes that bound the intersection, counter-clockwise: at least three, or none if it is
// empty. Every gap must be below 180 degrees. The lines enter a double-ended queue by direction. A
// new line removes those at either end whose corner it cuts off.
Indices bounding_planes(const std::vector<HalfPlane>& planes, const Indices& order) {
  Indices queue;
  std::size_t front = 0;
  const auto size = [&] { return queue.size() - front; };
  const auto back_is_cut_by = [&](std::size_t k) {
    return corner_side(planes[queue[queue.size() - 2]], planes[queue.back()], planes[k]) < 0;
  };
  const auto front_is_cut_by = [&](std::size_t k) {
    return corner_side(planes[queue[front]], planes[queue[front + 1]], planes[k]) < 0;
  };
  for (const std::size_t k : order) {
    while (size() >= 2 && back_is_cut_by(k)) queue.pop_back();
    while (size() >= 2 && front_is_cut_by(k)) ++front;
    if (size() >= 1 && normals_cross(planes[queue.back()], planes[k]) <= 0) return {};
    queue.push_back(k);
  }
  while (size() > 2 && back_is_cut_by(queue[front])) queue.pop_back();
  while (size() > 2 && front_is_cut_by(queue.back())) ++front;
  if (size() < 3) return {};
  queue.erase(queue.begin(), queue.begin() + static_cast<std::ptrdiff_t>(front));
  // If one corner is in all half-planes, the intersection is not empty.
  for (const std::size_t k : order) {
    if (k != queue[0] && k != queue[1] &&
        corner_side(planes[queue[0]], planes[queue[1]], planes[k]) < 0)
      return {};
  }
  return queue;
}

}  // namespace

NormalGap widest_gap(const std::vector<HalfPlane>& planes, double sine) {
  return widest_gap(planes, by_direction(planes), sine);
}

bool have_common_point(const std::vector<HalfPlane>& planes) {
  if (planes.empty()) return true;
  const Indices order = by_direction(planes);
  const NormalGap gap = widest_gap(planes, order, 0);
  if (gap.compare_to_half_turn > 0) return true;
  // The strip between the opposite half-planes has a point of all the others.
  if (gap.compare_to_half_turn == 0)
    return strip_width_sign(planes[gap.before], planes[gap.after]) >= 0;
  return !bounding_planes(planes, order).empty();
}

Points bounded_intersection(const std::vector<HalfPlane>& planes) {
  const Indices lines = bounding_planes(planes, by_direction(planes));
  Points corners;
  corners.reserve(lines.size());
  for (std::size_t k = 0; k < lines.size(); ++k) {
    const HalfPlane &i = planes[lines[k]], &j = planes[lines[(k + 1) % lines.size()]];
    const Vec2 ni = i.normal(), nj = j.normal();
    const double determinant = normals_cross(i, j);
    corners.emplace_back((i.bound * nj.y - j.bound * ni.y) / determinant,
                         (j.bound * ni.x - i.bound * nj.x) / determinant);
  }
  return corners;
}

}  // namespace evenlift
