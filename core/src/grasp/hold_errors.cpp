#include "grasp/hold_errors.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "evenlift/tolerance.h"
#include "exact/sorted_indices.h"

namespace evenlift {
namespace {

constexpr std::size_t most_contacts = 128;
constexpr double most_margin = 1;  // no hold has a greater one

}  // namespace

// Ordered by the outline, so that the order of the robots does not matter.
HoldErrors::HoldErrors(const Polygon& polygon, const Vec2& centre, double radius,
                       const std::vector<Contact>& contacts)
    : polygon_(polygon), centre_(centre), radius_(radius) {
  std::vector<Push> all;
  all.reserve(contacts.size());
  for (const Contact& contact : contacts)
    all.push_back({contact, wrench_at(contact.position, contact.edge)});
  const auto order = sorted_indices(all.size(), [&](std::uint32_t a, std::uint32_t b) {
    if (all[a].contact.edge != all[b].contact.edge)
      return all[a].contact.edge < all[b].contact.edge;
    return all[a].wrench.z < all[b].wrench.z;
  });
  const std::size_t number = std::min(order.size(), most_contacts);
  for (std::size_t k = 0; k < number; ++k) pushes_.push_back(all[order[k * order.size() / number]]);
}

Wrench HoldErrors::wrench_at(const Vec2& position, std::uint32_t edge) const {
  const Vec2 n = inward_normal(polygon_, edge);
  return {n.x, n.y, cross(position - centre_, n) / radius_};
}

// Follows the outline in both directions. On each edge that it reaches, the distance is greatest at
// one of the ends of the part within reach.
double HoldErrors::beside(const Push& push, double error) const {
  if (push.contact.in_notch) return 0;
  const double moment = error / radius_;
  double greatest = 0;
  const auto look_at = [&](const Vec2& position, std::size_t edge) {
    const Wrench from = wrench_at(position, static_cast<std::uint32_t>(edge)) - push.wrench;
    const double higher = std::max(0.0, std::fabs(from.z) - moment);
    greatest = std::max(greatest, length(Wrench(from.x, from.y, higher)));
  };
  const auto follow = [&](bool on) {
    std::size_t edge = push.contact.edge;
    Vec2 at = push.contact.position;
    double left = error;
    bool on_own_side = true;
    for (std::size_t passed = 0; passed < polygon_.size() && greatest < most_margin; ++passed) {
      const std::size_t end = on ? polygon_.next(edge) : edge;
      const double way = length(polygon_.vertex(end) - at);
      if (!on_own_side && left < way)
        look_at(at + (left / way) * (polygon_.vertex(end) - at), edge);
      if (left < way) return;
      if (!on_own_side) look_at(polygon_.vertex(end), edge);
      left -= way;
      at = polygon_.vertex(end);
      edge = on ? end : polygon_.previous(edge);
      on_own_side = on_own_side && polygon_.turn(end) == Turn::straight;
      if (!on_own_side) look_at(at, edge);
    }
  };
  follow(true);
  follow(false);
  return greatest;
}

// The contacts that no corner takes away, the least changed first.
std::vector<HoldErrors::Reached> HoldErrors::reached(double error) const {
  std::vector<Reached> all;
  for (const Push& push : pushes_)
    if (push.contact.to_corner > error) all.push_back({&push, beside(push, error)});
  std::vector<Reached> ordered;
  ordered.reserve(all.size());
  for (const std::uint32_t i :
       sorted_indices(all.size(), [&](auto a, auto b) { return all[a].beside < all[b].beside; }))
    ordered.push_back(all[i]);
  return ordered;
}

double HoldErrors::margin(const std::vector<Reached>& all, double most_beside, double turn) const {
  std::vector<Wrench> wrenches;
  for (const auto& [push, distance] : all) {
    if (distance > most_beside) continue;
    wrenches.push_back(push->wrench);
    if (!push->contact.in_notch) wrenches.back().z += turn;
  }
  return wrenches.empty() ? -1 : wrench_margin(wrenches);
}

// The margin falls with the contacts that it counts, so no x is tried that is not below the margin
// with larger ones.
bool HoldErrors::hold_within(double error, double known) const {
  const std::vector<Reached> all = reached(error);
  const double turn = error / radius_;
  if (known > turn + tau && !all.empty() && all.back().beside == 0) return true;
  double below = std::numeric_limits<double>::infinity();
  while (true) {
    const auto end =
        std::lower_bound(all.begin(), all.end(), below,
                         [](const Reached& each, double bound) { return each.beside < bound; });
    if (end == all.begin()) return false;
    const double x = (end - 1)->beside;
    const double least = std::min(margin(all, x, turn), margin(all, x, -turn));
    if (least > x) return true;
    if (least <= 0) return false;
    below = least;
  }
}

// Those in notches, which stay there.
bool HoldErrors::hold_without_others() const {
  std::vector<Reached> exact;
  for (const Push& push : pushes_)
    if (push.contact.in_notch) exact.push_back({&push, 0});
  return margin(exact, 0, 0) > 0;
}

// From small errors on, within which few vertices are.
double HoldErrors::tolerance() const {
  if (hold_without_others()) return std::numeric_limits<double>::infinity();
  constexpr double first = 1e-3, most = 4;  // of R; farther off, each robot pushes the other way
  double low = 0, high = first * radius_;
  for (; high < most * radius_ && hold_within(high); high *= 2) low = high;
  constexpr int halvings = 40;
  for (int i = 0; i < halvings; ++i) {
    const double middle = low + (high - low) / 2;
    (hold_within(middle) ? low : high) = middle;
  }
  // Where a corner ends it, its distance is exact.
  for (const Push& push : pushes_)
    if (push.contact.to_corner > low && push.contact.to_corner <= high)
      return push.contact.to_corner;
  return low;
}

}  // namespace evenlift
