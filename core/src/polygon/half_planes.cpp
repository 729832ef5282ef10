#include "polygon/half_planes.h"

#include <algorithm>
#include <cmath>

#include "evenlift/predicates.h"
#include "exact/dyadic.h"
#include "exact/sorted_indices.h"

namespace evenlift {
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
