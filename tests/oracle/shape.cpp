#include "oracle/exact.h"

#include <algorithm>

namespace oracle {
namespace {

/// For p on the line of a b: whether it is on the closed segment.
bool in_box(const ExactVec& a, const ExactVec& b, const ExactVec& p) {
  return p.x >= std::min(a.x, b.x) && p.x <= std::max(a.x, b.x) && p.y >= std::min(a.y, b.y) &&
         p.y <= std::max(a.y, b.y);
}

}  // namespace

std::vector<ExactVec> exact_points(const std::vector<Point>& points) {
  std::vector<ExactVec> result;
  result.reserve(points.size());
  for (const Point& p : points) result.push_back(exact(p));
  return result;
}

Exact doubled_area(const std::vector<ExactVec>& v) {
  Exact sum = 0;
  for (std::size_t i = 0; i < v.size(); ++i) sum += cross(v[i], v[(i + 1) % v.size()]);
  return sum;
}

bool meet(const ExactVec& a, const ExactVec& b, const ExactVec& c, const ExactVec& d) {
  const int abc = sign(orient(a, b, c)), abd = sign(orient(a, b, d));
  const int cda = sign(orient(c, d, a)), cdb = sign(orient(c, d, b));
  if (abc * abd < 0 && cda * cdb < 0) return true;
  return (abc == 0 && in_box(a, b, c)) || (abd == 0 && in_box(a, b, d)) ||
         (cda == 0 && in_box(c, d, a)) || (cdb == 0 && in_box(c, d, b));
}

namespace {

bool simple(const std::vector<ExactVec>& v) {
  const std::size_t n = v.size();
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i + 1; j < n; ++j) {
      const ExactVec &a = v[i], &b = v[(i + 1) % n], &c = v[j], &d = v[(j + 1) % n];
      if (j == i + 1 || (i == 0 && j == n - 1)) {
        // Neighbours may meet only at the shared vertex, without folding back.
        const ExactVec shared = j == i + 1 ? b : a;
        const ExactVec one = (j == i + 1 ? a : b) - shared, other = (j == i + 1 ? d : c) - shared;
        if (cross(one, other) == 0 && dot(one, other) > 0) return false;
      } else if (meet(a, b, c, d)) {
        return false;
      }
    }
  }
  return true;
}

/// p is strictly in the hull of v if every line through p has vertices strictly on both sides.
/// Lines through p and a vertex suffice: any other can be turned until it meets one.
bool strictly_in_hull(const std::vector<ExactVec>& v, const ExactVec& p) {
  for (const ExactVec& through : v) {
    if (through == p) continue;
    bool left = false, right = false;
    for (const ExactVec& other : v) {
      const int side = sign(orient(p, through, other));
      left = left || side > 0;
      right = right || side < 0;
    }
    if (!left || !right) return false;
  }
  return true;
}

/// The bounding box's diagonal is below 1e-9.
bool too_small(const std::vector<ExactVec>& v) {
  ExactVec low = v[0], high = low;
  for (const ExactVec& p : v) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  return length(real(high - low)) < tau;
}

bool bad(const Point& p) { return !(std::fabs(p[0]) <= 1e9 && std::fabs(p[1]) <= 1e9); }

bool tiny(const Point& p) {
  const auto below = [](double x) { return x != 0 && std::fabs(x) < 1e-100; };
  return below(p[0]) || below(p[1]);
}

}  // namespace

double nearest_double(const Exact& value) {
  if (value == 0) return 0;
  const bool negative = value < 0;
  mp::cpp_int num = abs(numerator(value)), den = denominator(value);
  // At least 64 bits of quotient, the lowest made sticky, leave only one rounding to 53 bits.
  int shift = static_cast<int>(msb(den)) - static_cast<int>(msb(num)) + 65;
  if (shift > 1074) shift = 1074;  // the grid of subnormals: never round twice
  if (shift > 0)
    num <<= shift;
  else
    den <<= -shift;
  mp::cpp_int quotient, rest;
  divide_qr(num, den, quotient, rest);
  if (quotient == 0) {
    const bool up = rest * 2 > den;
    return (negative ? -1 : 1) * (up ? std::ldexp(1.0, -shift) : 0.0);
  }
  const int bits = static_cast<int>(msb(quotient)) + 1;
  int drop = bits - 53;
  if (drop > 0) {
    const mp::cpp_int low = quotient & ((mp::cpp_int(1) << drop) - 1), half = mp::cpp_int(1)
                                                                              << (drop - 1);
    quotient >>= drop;
    if (low > half || (low == half && (rest != 0 || (quotient & 1) != 0))) quotient += 1;
  } else {
    if (rest * 2 > den || (rest * 2 == den && (quotient & 1) != 0)) quotient += 1;
    drop = 0;
  }
  return (negative ? -1 : 1) * std::ldexp(quotient.convert_to<double>(), drop - shift);
}

Point centroid(const std::vector<Point>& vertices) {
  Problem solid;
  solid.vertices = vertices;
  return centroid(solid);
}

Refusal refusal_of_ring(const Ring& ring) {
  if (ring.size() < 3) return Refusal::too_few_vertices;
  if (std::any_of(ring.begin(), ring.end(), bad)) return Refusal::bad_coordinate;
  const std::vector<ExactVec> v = exact_points(ring);
  for (std::size_t i = 0; i < v.size(); ++i)
    for (std::size_t j = i + 1; j < v.size(); ++j)
      if (v[i] == v[j]) return Refusal::repeated_vertex;
  const auto on_first_line = [&](const ExactVec& p) { return orient(v[0], v[1], p) == 0; };
  if (std::all_of(v.begin(), v.end(), on_first_line)) return Refusal::no_area;
  if (!simple(v)) return Refusal::not_simple;
  if (too_small(v)) return Refusal::too_small;
  if (std::any_of(ring.begin(), ring.end(), tiny)) return Refusal::bad_coordinate;
  return Refusal::none;
}

Refusal refusal(const Problem& problem) {
  if (const Refusal why = refusal_of_ring(problem.vertices); why != Refusal::none) return why;
  if (const Refusal why = refusal_of_holes(problem.vertices, problem.holes); why != Refusal::none)
    return why;
  const std::vector<ExactVec> v = exact_points(problem.vertices);
  const Point c = problem.centre_of_mass ? *problem.centre_of_mass : centroid(problem);
  if (bad(c) || (problem.centre_of_mass && tiny(c))) return Refusal::bad_coordinate;
  if (!strictly_in_hull(v, exact(c))) return Refusal::centre_outside;
  if (!(problem.min_ratio >= 0 && problem.min_ratio <= 1)) return Refusal::bad_ratio;
  if (problem.teams < 1) return Refusal::bad_teams;
  return Refusal::none;
}

std::shared_ptr<const ExactShape> exact_shape(const Problem& problem) {
  auto shape = std::make_shared<ExactShape>();
  shape->centre = exact(problem.centre_of_mass ? *problem.centre_of_mass : centroid(problem));
  shape->vertices = exact_points(problem.vertices);
  if (doubled_area(shape->vertices) < 0)
    std::reverse(shape->vertices.begin(), shape->vertices.end());
  for (ExactVec& v : shape->vertices) {
    v = v - shape->centre;
    shape->real_vertices.push_back(real(v));
  }
  Real squared = 0;
  for (const RealVec& v : shape->real_vertices)
    for (const RealVec& w : shape->real_vertices) squared = std::max(squared, dot(v - w, v - w));
  shape->size = sqrt(squared);
  shape->area = Real(doubled_area(shape->vertices)) / 2;
  for (const Ring& hole : problem.holes) {
    std::vector<ExactVec> ring = exact_points(hole);
    if (doubled_area(ring) < 0) std::reverse(ring.begin(), ring.end());
    shape->area -= Real(doubled_area(ring)) / 2;
    shape->holes.emplace_back();
    for (const ExactVec& v : ring) shape->holes.back().push_back(real(v - shape->centre));
  }
  return shape;
}

}  // namespace oracle
