// Polygons with holes, and cargo, by definition.
#include "oracle/exact.h"

#include <algorithm>

namespace oracle {
namespace {

/// Around two segments; comparing doubles is exact.
bool boxes_meet(const Point& a, const Point& b, const Point& c, const Point& d) {
  for (const std::size_t k : {0u, 1u})
    if (std::max(a[k], b[k]) < std::min(c[k], d[k]) || std::max(c[k], d[k]) < std::min(a[k], b[k]))
      return false;
  return true;
}

/// Twice the area, and six times the first moments.
struct Sums {
  Exact doubled_area = 0;
  ExactVec moments{0, 0};
};

/// As if counter-clockwise.
Sums sums_of(const Ring& ring) {
  const std::vector<ExactVec> v = exact_points(ring);
  Sums sums;
  for (std::size_t i = 0; i < v.size(); ++i) {
    const ExactVec &a = v[i], &b = v[(i + 1) % v.size()];
    sums.doubled_area += cross(a, b);
    sums.moments = sums.moments + (a + b) * cross(a, b);
  }
  if (sums.doubled_area < 0) return {-sums.doubled_area, -sums.moments};
  return sums;
}

Sums sums_of(const Problem& problem) {
  Sums sums = sums_of(problem.vertices);
  for (const Ring& hole : problem.holes) {
    const Sums lost = sums_of(hole);
    sums.doubled_area -= lost.doubled_area;
    sums.moments = sums.moments - lost.moments;
  }
  return sums;
}

bool contain_each_other(const Ring& a, const Ring& b) {
  return contains(a, b.front()) || contains(b, a.front());
}

}  // namespace

double area(const Problem& problem) { return nearest_double(sums_of(problem).doubled_area / 2); }

Point centroid(const Problem& problem) {
  const Sums sums = sums_of(problem);
  const Exact scale = 1 / (3 * sums.doubled_area);
  return {nearest_double(sums.moments.x * scale), nearest_double(sums.moments.y * scale)};
}

double covered_share(const Problem& problem, const std::vector<Point>& corners) {
  Problem seen = problem;
  seen.centre_of_mass = corners.front();
  const std::shared_ptr<const ExactShape> shape = exact_shape(seen);
  std::vector<RealVec> convex;
  for (const Point& corner : corners) convex.push_back(real(exact(corner) - shape->centre));
  return static_cast<double>(area_within(*shape, convex) / shape->area);
}

bool segments_meet(const Point& a, const Point& b, const Point& c, const Point& d) {
  return boxes_meet(a, b, c, d) && meet(exact(a), exact(b), exact(c), exact(d));
}

bool rings_meet(const Ring& a, const Ring& b) {
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j)
      if (segments_meet(a[i], a[(i + 1) % a.size()], b[j], b[(j + 1) % b.size()])) return true;
  return false;
}

// By a ray to the left; an edge counts with its lower end only.
bool contains(const Ring& ring, const Point& p) {
  bool odd = false;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    Point low = ring[i], high = ring[(i + 1) % ring.size()];
    if (low[1] > high[1]) std::swap(low, high);
    if (p[1] < low[1] || p[1] >= high[1]) continue;
    if (orient(exact(low), exact(high), exact(p)) < 0) odd = !odd;
  }
  return odd;
}

Refusal refusal_of_holes(const Ring& outline, const std::vector<Ring>& holes) {
  for (const Ring& hole : holes)
    if (refusal_of_ring(hole) != Refusal::none) return Refusal::bad_hole;
  for (std::size_t i = 0; i < holes.size(); ++i) {
    if (rings_meet(outline, holes[i])) return Refusal::rings_meet;
    for (std::size_t j = 0; j < i; ++j)
      if (rings_meet(holes[j], holes[i])) return Refusal::rings_meet;
  }
  for (std::size_t i = 0; i < holes.size(); ++i) {
    if (!contains(outline, holes[i].front())) return Refusal::hole_outside;
    for (std::size_t j = 0; j < i; ++j)
      if (contain_each_other(holes[i], holes[j])) return Refusal::hole_outside;
  }
  return Refusal::none;
}

bool fits(const Ring& outline, const std::vector<Ring>& holes, const Ring& hole) {
  if (!contains(outline, hole.front())) return false;
  const auto apart = [&](const Ring& other) { return !rings_meet(other, hole); };
  const auto beside = [&](const Ring& other) {
    return apart(other) && !contain_each_other(other, hole);
  };
  return apart(outline) && std::all_of(holes.begin(), holes.end(), beside) &&
         refusal_of_ring(hole) == Refusal::none;
}

Point centre_with_cargo(const Point& own, double weight, const std::vector<Cargo>& cargo) {
  Exact all = weight;
  ExactVec moments = exact(own) * Exact(weight);
  for (const Cargo& item : cargo) {
    all += item.weight;
    moments = moments + exact(item.at) * Exact(item.weight);
  }
  return {nearest_double(moments.x / all), nearest_double(moments.y / all)};
}

}  // namespace oracle
