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

// Whether the normal's direction is in [0, 180) degrees; comparisons of coordinates are exact.
bool points_up(const HalfPlane& a) {
  return a.to.y() > a.from.y() || (a.to.y() == a.from.y() && a.to.x() > a.from.x());
}

struct ExactNormal {
  explicit ExactNormal(const HalfPlane& a)
      : x(Dyadic(a.to.x()) - Dyadic(a.from.x())), y(Dyadic(a.to.y()) - Dyadic(a.from.y())) {}
  Dyadic x, y;
};

Dyadic exact_cross(const ExactNormal& a, const ExactNormal& b) { return a.x * b.y - a.y * b.x; }

// A sum of terms whose relative errors are below 2^-44 has the right sign if it is not smaller than
// this part of their sizes.
constexpr double sum_is_enough = 0x1p-40;

// Sign of the determinant of the rows (normal, bound): for normals i, j that turn left it is
// positive if the corner of i and j lies inside k.
int corner_side(const HalfPlane& i, const HalfPlane& j, const HalfPlane& k) {
  const double terms[] = {i.bound * normals_cross(j, k), -j.bound * normals_cross(i, k),
                          k.bound * normals_cross(i, j)};
  const double sum = terms[0] + terms[1] + terms[2];
  const double size = std::fabs(terms[0]) + std::fabs(terms[1]) + std::fabs(terms[2]);
  if (std::fabs(sum) > sum_is_enough * size && size > 1e-250) return sum > 0 ? 1 : -1;
  const ExactNormal ni(i), nj(j), nk(k);
  return (Dyadic(i.bound) * exact_cross(nj, nk) - Dyadic(j.bound) * exact_cross(ni, nk) +
          Dyadic(k.bound) * exact_cross(ni, nj))
      .sign();
}

Dyadic exact_size(const HalfPlane& a) {
  const ExactNormal n(a);
  return (n.x.sign() < 0 ? -n.x : n.x) + (n.y.sign() < 0 ? -n.y : n.y);
}

// Sign of bound(a) |b| + factor bound(b) |a| for parallel normals: with factor -1 compares how far
// out two of the same direction lie, with +1 the width of the strip between two opposite ones.
int compare_bounds(const HalfPlane& a, const HalfPlane& b, int factor) {
  const Dyadic first = Dyadic(a.bound) * exact_size(b), second = Dyadic(b.bound) * exact_size(a);
  return (factor < 0 ? first - second : first + second).sign();
}

// Indices by direction of the normal; of equal directions only the tightest.
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
    } else if (compare_bounds(planes[i], planes[tightest.back()], -1) < 0) {
      tightest.back() = i;
    }
  }
  return tightest;
}

// Whether the angle from the normal of i counter-clockwise to that of j, of which the exact sine
// has the sign of `side` > 0, is 180 degrees within `sine`.
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
    // No two neighbours have the same direction: without a turn they are opposite.
    int excess = side > 0 ? -1 : side < 0 ? 1 : 0;
    if (side > 0 && nearly_opposite(planes[i], planes[j], side, sine)) excess = 0;
    if (excess > widest.excess) widest = {i, j, excess};
  }
  return widest;
}

// The half-planes that bound the intersection, counter-clockwise, if every gap is below 180
// degrees; at least three, or none if the intersection is empty. A queue of lines by direction from
// whose ends those are dropped whose corner a new one cuts off.
Indices ring(const std::vector<HalfPlane>& planes, const Indices& order) {
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
  // A corner that lies in all half-planes proves that the ring is one.
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
  if (gap.excess > 0) return true;
  // The others all give way along the strip between the two opposite ones.
  if (gap.excess == 0) return compare_bounds(planes[gap.before], planes[gap.after], 1) >= 0;
  return !ring(planes, order).empty();
}

Points bounded_intersection(const std::vector<HalfPlane>& planes) {
  const Indices lines = ring(planes, by_direction(planes));
  Points corners;
  corners.reserve(lines.size());
  for (std::size_t k = 0; k < lines.size(); ++k) {
    const HalfPlane &i = planes[lines[k]], &j = planes[lines[(k + 1) % lines.size()]];
    const Vec2 ni = i.normal(), nj = j.normal();
    const double area = normals_cross(i, j);
    corners.emplace_back((i.bound * nj.y() - j.bound * ni.y()) / area,
                         (j.bound * ni.x() - i.bound * nj.x()) / area);
  }
  return corners;
}

}  // namespace evenlift
