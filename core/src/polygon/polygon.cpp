#include "evenlift/polygon.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "evenlift/document.h"
#include "evenlift/hull.h"
#include "evenlift/plane.h"
#include "evenlift/predicates.h"
#include "evenlift/tolerance.h"
#include "exact/bits.h"
#include "exact/double_double.h"
#include "exact/dyadic.h"
#include "exact/sorted_indices.h"
#include "polygon/simplicity.h"

namespace evenlift {
namespace {

InputError at_vertex(ErrorCode code, std::string message, std::size_t i) {
  return {code, std::move(message), {Place::Kind::vertex, i, i, {}}};
}

// Differences of accepted coordinates are at least 1e-116, so lengths, areas and moments of even
// the thinnest object stay far from underflow.
bool is_too_near_to_0(const Vec2& v) {
  const auto tiny = [](double x) { return x != 0 && std::fabs(x) < min_coordinate; };
  return tiny(v.x()) || tiny(v.y());
}

std::optional<InputError> check_coordinates(const Points& vertices) {
  if (vertices.size() < 3) {
    return InputError{ErrorCode::too_few_vertices, "a polygon needs at least 3 vertices", {}};
  }
  if (vertices.size() > max_vertices) {
    return InputError{ErrorCode::too_many_vertices, "more than 1048576 vertices", {}};
  }
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const Vec2& v = vertices[i];
    if (!std::isfinite(v.x()) || !std::isfinite(v.y())) {
      return at_vertex(ErrorCode::bad_coordinate, "a coordinate is not a finite number", i);
    }
    if (std::fabs(v.x()) > max_coordinate || std::fabs(v.y()) > max_coordinate) {
      return at_vertex(ErrorCode::bad_coordinate, "a coordinate exceeds 1e9 in size", i);
    }
  }
  return std::nullopt;
}

std::optional<InputError> check_repetition(const Points& vertices, const SortedIndices& order) {
  std::optional<Place> first;
  for (std::size_t k = 1; k < order.size(); ++k) {
    if (vertices[order[k - 1]] != vertices[order[k]]) continue;
    const Place place{Place::Kind::vertex, order[k - 1], order[k], {}};
    if (!first || place.other < first->other) first = place;
  }
  if (!first) return std::nullopt;
  return InputError{ErrorCode::repeated_vertex, "two vertices are at the same place", *first};
}

bool all_on_one_line(const Points& vertices) {
  return std::all_of(vertices.begin() + 2, vertices.end(),
                     [&](const Vec2& v) { return orient(vertices[0], vertices[1], v) == 0; });
}

struct Moments {
  double area;  // above 0
  Vec2 centroid;
};

// Twice the signed area and six times its first moments, relative to a point. The sums of the
// absolute terms bound the rounding errors even if most of the terms cancel.
struct Sums {
  DoubleDouble doubled_area, x, y;
  double size_area = 0, size_moments = 0;
};

Sums double_double_sums(const Points& vertices, const Vec2& corner) {
  // Products below 2^-969 lose bits. Counting every term as at least this large covers the loss.
  constexpr double least_size = 0x1p-960;
  Sums sums;
  const auto relative = [&](const Vec2& v) {
    return std::pair(two_difference(v.x(), corner.x()), two_difference(v.y(), corner.y()));
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

// The sums without rounding, relative to the origin.
struct ExactSums {
  Dyadic doubled_area, x, y;
};

ExactSums exact_sums(const Points& vertices) {
  ExactSums sums;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const Vec2 &p = vertices[i], &q = vertices[i + 1 == vertices.size() ? 0 : i + 1];
    const Dyadic px(p.x()), py(p.y()), qx(q.x()), qy(q.y());
    const Dyadic part = px * qy - qx * py;
    sums.doubled_area = sums.doubled_area + part;
    sums.x = sums.x + (px + qx) * part;
    sums.y = sums.y + (py + qy) * part;
  }
  return sums;
}

// The double nearest to the quotient; in a tie, the even one. The divisor must not be 0.
double rounded_quotient(const Dyadic& numerator, const Dyadic& divisor) {
  // Each round adds about fifty correct bits. Afterwards the exact quotient lies between this one
  // and a neighbour.
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

// Area and centroid, in double-double relative to a corner of the bounding box, so that polygons
// far from the origin lose no digits. Both are rounded to doubles once. If the error bound allows
// more than one double, as with thin polygons and centroids near 0, exact sums decide.
Moments moments(const Points& vertices, const Vec2& corner) {
  const Sums sums = double_double_sums(vertices, corner);
  const DoubleDouble divisor = DoubleDouble(3.0) * sums.doubled_area;
  const DoubleDouble x = sums.x / divisor + DoubleDouble(corner.x());
  const DoubleDouble y = sums.y / divisor + DoubleDouble(corner.y());

  // Each operation has an error of at most 2^-100 of its operands, and a sum has fewer than 2^22
  // operations.
  constexpr double unit = 0x1p-78;
  const double size = std::fabs(divisor.hi);
  const double reach = std::fabs(sums.x.hi / size) + std::fabs(sums.y.hi / size);
  const double error_bound = unit * (sums.size_moments / size + reach * (sums.size_area / size) +
                                     reach + std::fabs(corner.x()) + std::fabs(corner.y()));
  const auto is_certain = [](const DoubleDouble& value, double bound) {
    return value.hi + (value.lo - bound) == value.hi && value.hi + (value.lo + bound) == value.hi;
  };
  if (is_certain(x, error_bound) && is_certain(y, error_bound) &&
      is_certain(sums.doubled_area, unit * sums.size_area))
    return {0.5 * std::fabs(sums.doubled_area.to_double()), {x.to_double(), y.to_double()}};
  return exact_moments(vertices);
}

}  // namespace

// The lowest of the leftmost vertices is a corner of the convex hull and never straight, so its
// turn gives the polygon's orientation.
bool is_counter_clockwise(const Points& vertices) {
  std::size_t lowest = 0;
  for (std::size_t i = 1; i < vertices.size(); ++i) {
    const Vec2 &v = vertices[i], &best = vertices[lowest];
    if (v.x() < best.x() || (v.x() == best.x() && v.y() < best.y())) lowest = i;
  }
  const std::size_t n = vertices.size();
  return orient(vertices[(lowest + n - 1) % n], vertices[lowest], vertices[(lowest + 1) % n]) > 0;
}

Result<Polygon> Polygon::create(Points vertices) {
  if (auto error = check_coordinates(vertices)) return *error;
  const SortedIndices order = lexicographic_order(vertices);
  if (auto error = check_repetition(vertices, order)) return *error;
  if (all_on_one_line(vertices)) {
    return InputError{
        ErrorCode::no_area, "the polygon has no area: all its vertices are on one line", {}};
  }
  if (const auto crossing = find_crossing(vertices, order)) {
    return InputError{ErrorCode::edges_cross,
                      "the edges cross, touch or overlap",
                      {Place::Kind::edge, crossing->first, crossing->second, {}}};
  }

  const Box box = bounding_box(vertices);
  if (box.diagonal() < min_diagonal) {
    return InputError{ErrorCode::object_too_small,
                      "the object is too small: its bounding box's diagonal is below 1e-9",
                      {}};
  }
  const auto tiny = std::find_if(vertices.begin(), vertices.end(), is_too_near_to_0);
  if (tiny != vertices.end()) {
    return at_vertex(ErrorCode::bad_coordinate, "a coordinate is below 1e-100 in size but not 0",
                     static_cast<std::size_t>(tiny - vertices.begin()));
  }

  Polygon polygon;
  const Moments m = moments(vertices, box.low);
  polygon.diagonal_ = box.diagonal();
  polygon.area_ = m.area;
  polygon.centroid_ = m.centroid;
  polygon.counter_clockwise_ = is_counter_clockwise(vertices);
  polygon.hull_ = convex_hull(vertices);
  polygon.diameter_ = evenlift::diameter(polygon.hull_);
  polygon.vertices_ = std::move(vertices);
  polygon.convex_ = true;
  for (std::size_t i = 0; i < polygon.size() && polygon.convex_; ++i) {
    polygon.convex_ = polygon.turn_side(i) >= 0;
  }
  return polygon;
}

Turn Polygon::turn(std::size_t i) const {
  const Vec2 before = vertices_[i] - vertices_[previous(i)],
             after = vertices_[next(i)] - vertices_[i];
  if (directions_agree(before, after)) return Turn::straight;
  return turn_side(i) > 0 ? Turn::convex : Turn::reflex;
}

bool Polygon::is_corner(std::size_t i) const {
  if (turn(i) != Turn::convex) return false;
  constexpr double cosine_of_15_degrees = 0.96592582628906828675;
  const Vec2 before = vertices_[i] - vertices_[previous(i)],
             after = vertices_[next(i)] - vertices_[i];
  return dot(before, after) < (cosine_of_15_degrees - tau) * length(before) * length(after);
}

double Polygon::turn_side(std::size_t i) const {
  const double side = orient(vertices_[previous(i)], vertices_[i], vertices_[next(i)]);
  return counter_clockwise_ ? side : -side;
}

Result<Vec2> check_centre_of_mass(const Polygon& polygon, const std::optional<Vec2>& given) {
  const Vec2 centre = given.value_or(polygon.centroid());
  const Place place{Place::Kind::centre_of_mass, 0, 0, {}};
  if (!std::isfinite(centre.x()) || !std::isfinite(centre.y())) {
    return InputError{ErrorCode::bad_coordinate,
                      "a coordinate of the centre of mass is not a finite number", place};
  }
  if (std::fabs(centre.x()) > max_coordinate || std::fabs(centre.y()) > max_coordinate) {
    return InputError{ErrorCode::bad_coordinate,
                      "a coordinate of the centre of mass exceeds 1e9 in size", place};
  }
  if (given && is_too_near_to_0(*given)) {
    return InputError{ErrorCode::bad_coordinate,
                      "a coordinate of the centre of mass is below 1e-100 in size but not 0",
                      place};
  }
  const Points& hull = polygon.hull();
  for (std::size_t i = 0; i < hull.size(); ++i) {
    if (orient(hull[i], hull[(i + 1) % hull.size()], centre) <= 0) {
      return InputError{ErrorCode::centre_outside_hull,
                        "the centre of mass is not inside the convex hull of the polygon", place};
    }
  }
  return centre;
}

double farthest_vertex(const Polygon& polygon, const Vec2& centre) {
  double farthest = 0;
  for (const Vec2& v : polygon.vertices()) farthest = std::max(farthest, length(v - centre));
  return farthest;
}

}  // namespace evenlift
