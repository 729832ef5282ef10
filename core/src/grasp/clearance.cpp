#include <algorithm>
#include <cmath>

#include "evenlift/closure.h"
#include "evenlift/tolerance.h"
#include "exact/sorted_indices.h"

namespace evenlift {
namespace {

// The contacts, farthest from a corner or from an end of their side first. If the first k give form
// closure or a large margin, so do more, so bisection finds the least k.
class FarthestFirst {
 public:
  FarthestFirst(const Polygon& polygon, const Vec2& centre, const std::vector<Contact>& contacts,
                double Contact::*distance)
      : polygon_(polygon),
        centre_(centre),
        radius_(farthest_vertex(polygon, centre)),
        distance_(distance) {
    for (const std::uint32_t i : sorted_indices(contacts.size(), [&](auto a, auto b) {
           return contacts[a].*distance > contacts[b].*distance;
         }))
      contacts_.push_back(contacts[i]);
  }

  // The least k for which the first k contacts hold; size() + 1 if there is none.
  std::size_t fewest_that_hold() const {
    return first(1, [&](std::size_t number) {
      return in_form_closure(polygon_, centre_, first_contacts(number));
    });
  }

  const Contact& last_of(std::size_t number) const { return contacts_[number - 1]; }
  std::size_t size() const { return contacts_.size(); }

  // Clearance::tolerance (closure.h). With more contacts the distance falls and the margin grows,
  // so the best number is one of two neighbours.
  double tolerance() const {
    const auto by_margin = [&](std::size_t number) {
      const auto margin = analyse_hold(polygon_, centre_, first_contacts(number)).margin;
      return radius_ * std::max(0.0, margin.value_or(0));
    };
    const auto within = [&](std::size_t number) {
      return std::min(last_of(number).*distance_, by_margin(number));
    };
    const std::size_t enough = first(
        1, [&](std::size_t number) { return by_margin(number) >= last_of(number).*distance_; });
    double best = 0;
    if (enough <= size()) best = within(enough);
    if (enough > 1) best = std::max(best, within(enough - 1));
    return best;
  }

 private:
  std::vector<Contact> first_contacts(std::size_t number) const {
    return {contacts_.begin(), contacts_.begin() + static_cast<std::ptrdiff_t>(number)};
  }

  // The first number from `low` on that fulfils a condition, which all larger ones must also
  // fulfil.
  template <class Condition>
  std::size_t first(std::size_t low, Condition fulfils) const {
    std::size_t high = size() + 1;
    while (low < high) {
      const std::size_t middle = low + (high - low) / 2;
      if (fulfils(middle))
        high = middle;
      else
        low = middle + 1;
    }
    return low;
  }

  const Polygon& polygon_;
  Vec2 centre_;
  double radius_;
  double Contact::*distance_;
  std::vector<Contact> contacts_;
};

}  // namespace

std::vector<Contact> clear_contacts(const Polygon& polygon, const std::vector<Contact>& contacts,
                                    double clear) {
  const double least = clear - near_distance(polygon.diameter());
  std::vector<Contact> kept;
  kept.reserve(contacts.size());
  for (const Contact& contact : contacts)
    if (contact.to_corner >= least) kept.push_back(contact);
  return kept;
}

Clearance analyse_clearance(const Polygon& polygon, const Vec2& centre,
                            const std::vector<Contact>& contacts) {
  const FarthestFirst farthest(polygon, centre, contacts, &Contact::to_corner);
  const std::size_t fewest = farthest.fewest_that_hold();
  Clearance clearance;
  if (fewest > farthest.size()) return clearance;
  const Contact& nearest = farthest.last_of(fewest);
  clearance.distance = nearest.to_corner;
  if (std::isfinite(nearest.to_corner)) clearance.point = nearest.point;
  clearance.tolerance = FarthestFirst(polygon, centre, contacts, &Contact::to_end).tolerance();
  return clearance;
}

HoldRequirements hold_requirements(const Polygon& polygon, const Vec2& centre,
                                   const Settings& settings) {
  return {settings.min_margin,
          settings.clear.value_or(usual_clear * farthest_vertex(polygon, centre))};
}

bool is_clear(const Polygon& polygon, const Clearance& clearance, double clear) {
  return clearance.distance >= clear - near_distance(polygon.diameter());
}

}  // namespace evenlift
