#include "grasp/grasp.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "evenlift/tolerance.h"
#include "exact/sorted_indices.h"
#include "polygon/corners.h"

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

// On each part of an edge within reach, the distance is greatest at one of the ends. Where the
// normal does not turn, a robot changes its moment by no more than its way.
double HoldErrors::beside(const Push& push, double error) const {
  if (push.contact.in_notch) return 0;
  const double moment = error / radius_;
  double greatest = 0;
  walk_outline(polygon_, push.contact.position, push.contact.edge, error,
               [&](std::uint32_t edge, const Vec2& from, const Vec2& to) {
                 for (const Vec2& position : {from, to}) {
                   const Wrench change = wrench_at(position, edge) - push.wrench;
                   if (length(Vec2(change.x, change.y)) <= tau) break;
                   const double higher = std::max(0.0, std::fabs(change.z) - moment);
                   greatest = std::max(greatest, length(Wrench(change.x, change.y, higher)));
                 }
                 return greatest < most_margin;
               });
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

// With all moments raised, and with all lowered. Of contacts with one normal the outermost count.
double HoldErrors::least_margin(const std::vector<Reached>& all, double most_beside,
                                double error) const {
  std::vector<Contact> free, exact;
  for (const auto& [push, distance] : all)
    if (distance <= most_beside) (push->contact.in_notch ? exact : free).push_back(push->contact);
  const auto wrenches_of = [&](const std::vector<Contact>& contacts) {
    return wrenches(make_grasp(polygon_, centre_, radius_, contacts));
  };
  const std::vector<Wrench> kept = wrenches_of(exact), moving = wrenches_of(free);
  if (kept.empty() && moving.empty()) return -1;
  const auto margin = [&](double turn) {
    std::vector<Wrench> moved = kept;
    for (const Wrench& wrench : moving) moved.push_back(wrench + Wrench(0, 0, turn));
    return wrench_margin(moved);
  };
  const double raised = margin(error / radius_);
  return raised > 0 ? std::min(raised, margin(-error / radius_)) : raised;
}

// Whether no contact pushes along a direction once all moments are changed in the worse sense.
bool HoldErrors::is_lost_along(const Wrench& direction, double error) const {
  const double less = std::fabs(direction.z) * error / radius_;
  return std::none_of(pushes_.begin(), pushes_.end(), [&](const Push& push) {
    return push.contact.to_corner > error &&
           dot(push.wrench, direction) - (push.contact.in_notch ? 0 : less) > 0;
  });
}

// The margin falls with the contacts that it counts, so no x is tried that is not below the margin
// with larger ones.
bool HoldErrors::hold_within(double error, const WeakestDirection& known) const {
  if (is_lost_along(known.direction, error)) return false;
  const std::vector<Reached> all = reached(error);
  const double turn = error / radius_;
  if (!all.empty() && known.margin > turn + all.back().beside + tau) return true;
  double below = std::numeric_limits<double>::infinity();
  while (true) {
    const auto end =
        std::lower_bound(all.begin(), all.end(), below,
                         [](const Reached& each, double bound) { return each.beside < bound; });
    if (end == all.begin()) return false;
    const double x = (end - 1)->beside;
    const double least = least_margin(all, x, error);
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
  return least_margin(exact, 0, 0) > 0;
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
