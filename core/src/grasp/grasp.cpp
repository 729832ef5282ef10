#include "grasp/grasp.h"

#include <algorithm>
#include <utility>

#include "evenlift/predicates.h"
#include "evenlift/tolerance.h"
#include "exact/sorted_indices.h"

namespace evenlift {
namespace {

// Whether a touch's edge has a direction in [0, 180) degrees. Comparing coordinates is exact.
bool points_up(const Grasp::Touch& touch) {
  return touch.to.y() > touch.from.y() ||
         (touch.to.y() == touch.from.y() && touch.to.x() > touch.from.x());
}

// Most touches of a large team share their edge, for which the exact predicate would take its
// longest way to its zero.
double turn_of(const Grasp::Touch& a, const Grasp::Touch& b) {
  return a.edge == b.edge ? 0 : cross_of_differences(a.from, a.to, b.from, b.to);
}

bool same_direction(const Grasp::Touch& a, const Grasp::Touch& b) {
  return points_up(a) == points_up(b) && turn_of(a, b) == 0;
}

// Among touches whose edges have the same direction, decided exactly, keeps only the touches
// farthest back and farthest along it.
void keep_extremes(Grasp& grasp) {
  const std::vector<Grasp::Touch>& touches = grasp.touches;
  std::vector<double> place(touches.size());
  for (std::size_t i = 0; i < touches.size(); ++i)
    place[i] = along(grasp, touches[i]) / length(touches[i].direction());
  const auto order = sorted_indices(touches.size(), [&](std::uint32_t i, std::uint32_t j) {
    const Grasp::Touch &a = touches[i], &b = touches[j];
    if (points_up(a) != points_up(b)) return points_up(a);
    if (const double turn = turn_of(a, b); turn != 0) return turn > 0;
    return place[i] < place[j];
  });
  std::vector<std::uint32_t> kept;
  for (std::size_t k = 0; k < order.size(); ++k) {
    const Grasp::Touch& touch = touches[order[k]];
    const bool is_first = k == 0 || !same_direction(touches[order[k - 1]], touch);
    const bool is_last = k + 1 == order.size() || !same_direction(touches[order[k + 1]], touch);
    if (is_first || is_last) kept.push_back(order[k]);
  }
  std::sort(kept.begin(), kept.end());
  std::vector<Grasp::Touch> extremes;
  extremes.reserve(kept.size());
  for (const std::uint32_t i : kept) extremes.push_back(touches[i]);
  grasp.touches = std::move(extremes);
}

}  // namespace

double along(const Grasp& grasp, const Grasp::Touch& touch) {
  return dot_of_differences(touch.from, touch.to, grasp.centre, touch.position);
}

Grasp make_grasp(const Polygon& polygon, const Vec2& centre, double radius,
                 const std::vector<Contact>& contacts) {
  Grasp grasp{
      centre, polygon.diagonal(), polygon.diameter(), near_distance(polygon.diameter()), radius,
      {}};
  grasp.touches.reserve(contacts.size());
  for (const Contact& contact : contacts) {
    Vec2 from = polygon.edge_start(contact.edge), to = polygon.edge_end(contact.edge);
    if (!polygon.counter_clockwise()) std::swap(from, to);
    grasp.touches.push_back({from, to, contact.position, contact.edge});
  }
  keep_extremes(grasp);
  return grasp;
}

std::vector<Wrench> wrenches(const Grasp& grasp) {
  std::vector<Wrench> all;
  for (const Grasp::Touch& touch : grasp.touches) {
    const Vec2 n = touch.inward();
    all.emplace_back(n.x(), n.y(), cross(touch.position - grasp.centre, n) / grasp.radius);
  }
  std::vector<Wrench> ordered;
  for (const std::uint32_t i : sorted_indices(all.size(), [&](std::uint32_t a, std::uint32_t b) {
         if (grasp.touches[a].edge != grasp.touches[b].edge)
           return grasp.touches[a].edge < grasp.touches[b].edge;
         return all[a].z() < all[b].z();
       }))
    ordered.push_back(all[i]);
  return ordered;
}

}  // namespace evenlift
