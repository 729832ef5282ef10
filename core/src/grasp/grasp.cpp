#include "grasp/grasp.h"

#include <algorithm>
#include <map>
#include <utility>

#include "evenlift/predicates.h"
#include "evenlift/tolerance.h"
#include "exact/sorted_indices.h"

namespace evenlift {
namespace {

using Touch = Grasp::Touch;

// Whether a touch's edge has a direction in [0, 180) degrees. Comparing coordinates is exact.
bool points_up(const Touch& touch) {
  return touch.to.y > touch.from.y || (touch.to.y == touch.from.y && touch.to.x > touch.from.x);
}

double turn_of(const Touch& a, const Touch& b) {
  return cross_of_differences(a.from, a.to, b.from, b.to);
}

bool same_direction(const Touch& a, const Touch& b) {
  return points_up(a) == points_up(b) && turn_of(a, b) == 0;
}

Touch touch_of(const Polygon& polygon, const Contact& contact) {
  Vec2 from = polygon.edge_start(contact.edge), to = polygon.edge_end(contact.edge);
  if (!polygon.counter_clockwise()) std::swap(from, to);
  return {from, to, contact.position, contact.edge};
}

struct PlacedTouch {
  Touch touch;
  double place = 0;  // along the direction of its edge
  std::size_t contact = 0;
};

// The first and the last contact along each edge, in the order of the contacts. They are few even
// for many robots, so what follows costs little.
std::vector<PlacedTouch> extremes_of_edges(const Polygon& polygon, const Grasp& grasp,
                                           const std::vector<Contact>& contacts) {
  struct Extremes {
    PlacedTouch first, last;
  };
  std::map<std::uint32_t, Extremes> of_edge;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const std::uint32_t edge = contacts[i].edge;
    PlacedTouch placed{touch_of(polygon, contacts[i]), 0, i};
    placed.place = along(grasp, placed.touch) / length(placed.touch.direction());
    const auto [found, is_new] = of_edge.try_emplace(edge, Extremes{placed, placed});
    auto& [first, last] = found->second;
    if (placed.place < first.place) first = placed;
    if (placed.place >= last.place) last = placed;
  }
  std::vector<PlacedTouch> extremes;
  for (const auto& [edge, ends] : of_edge) {
    extremes.push_back(ends.first);
    if (ends.last.contact != ends.first.contact) extremes.push_back(ends.last);
  }
  sort_items(extremes,
             [](const PlacedTouch& a, const PlacedTouch& b) { return a.contact < b.contact; });
  return extremes;
}

// Keeps the first and the last of the touches whose edges have the same direction, decided exactly.
std::vector<Touch> extremes_of_directions(const std::vector<PlacedTouch>& touches) {
  const auto order = sorted_indices(touches.size(), [&](std::uint32_t i, std::uint32_t j) {
    const Touch &a = touches[i].touch, &b = touches[j].touch;
    if (points_up(a) != points_up(b)) return points_up(a);
    if (const double turn = turn_of(a, b); turn != 0) return turn > 0;
    return touches[i].place < touches[j].place;
  });
  std::vector<std::uint32_t> kept;
  for (std::size_t k = 0; k < order.size(); ++k) {
    const auto like = [&](std::size_t other) {
      return same_direction(touches[order[other]].touch, touches[order[k]].touch);
    };
    if (k == 0 || !like(k - 1) || k + 1 == order.size() || !like(k + 1)) kept.push_back(order[k]);
  }
  std::sort(kept.begin(), kept.end());
  std::vector<Touch> extremes;
  extremes.reserve(kept.size());
  for (const std::uint32_t i : kept) extremes.push_back(touches[i].touch);
  return extremes;
}

}  // namespace

std::vector<Grasp::Touch> touches_of(const Polygon& polygon, const std::vector<Contact>& contacts) {
  std::vector<Touch> touches;
  touches.reserve(contacts.size());
  for (const Contact& contact : contacts) touches.push_back(touch_of(polygon, contact));
  return touches;
}

double along(const Grasp& grasp, const Grasp::Touch& touch) {
  return dot_of_differences(touch.from, touch.to, grasp.centre, touch.position);
}

Grasp make_grasp(const Polygon& polygon, const Vec2& centre, double radius,
                 const std::vector<Contact>& contacts) {
  Grasp grasp{
      centre, polygon.diagonal(), polygon.diameter(), near_distance(polygon.diameter()), radius,
      {}};
  grasp.touches = extremes_of_directions(extremes_of_edges(polygon, grasp, contacts));
  return grasp;
}

std::vector<Wrench> wrenches(const Grasp& grasp) {
  std::vector<Wrench> all;
  for (const Grasp::Touch& touch : grasp.touches) {
    const Vec2 n = touch.inward();
    all.emplace_back(n.x, n.y, cross(touch.position - grasp.centre, n) / grasp.radius);
  }
  std::vector<Wrench> ordered;
  for (const std::uint32_t i : sorted_indices(all.size(), [&](std::uint32_t a, std::uint32_t b) {
         if (grasp.touches[a].edge != grasp.touches[b].edge)
           return grasp.touches[a].edge < grasp.touches[b].edge;
         return all[a].z < all[b].z;
       }))
    ordered.push_back(all[i]);
  return ordered;
}

}  // namespace evenlift
