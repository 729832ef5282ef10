#include <algorithm>
#include <cmath>

#include "evenlift/closure.h"
#include "evenlift/tolerance.h"
#include "exact/sorted_indices.h"
#include "grasp/hold_errors.h"

namespace evenlift {
namespace {

// The contacts, farthest from a corner first. If the first k give form closure, so do more, so
// bisection finds the least k.
class FarthestFirst {
 public:
  FarthestFirst(const Polygon& polygon, const Vec2& centre, const std::vector<Contact>& contacts)
      : polygon_(polygon), centre_(centre) {
    for (const std::uint32_t i : sorted_indices(contacts.size(), [&](auto a, auto b) {
           return contacts[a].to_corner > contacts[b].to_corner;
         }))
      contacts_.push_back(contacts[i]);
  }

  // The least k for which the first k contacts hold; size() + 1 if there is none.
  std::size_t fewest_that_hold() const {
    std::size_t low = 1, high = size() + 1;
    while (low < high) {
      const std::size_t middle = low + (high - low) / 2;
      const auto end = contacts_.begin() + static_cast<std::ptrdiff_t>(middle);
      if (in_form_closure(polygon_, centre_, std::vector<Contact>(contacts_.begin(), end)))
        high = middle;
      else
        low = middle + 1;
    }
    return low;
  }

  const Contact& last_of(std::size_t number) const { return contacts_[number - 1]; }
  std::size_t size() const { return contacts_.size(); }

 private:
  const Polygon& polygon_;
  Vec2 centre_;
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
  const FarthestFirst farthest(polygon, centre, contacts);
  const std::size_t fewest = farthest.fewest_that_hold();
  Clearance clearance;
  if (fewest > farthest.size()) return clearance;
  const Contact& nearest = farthest.last_of(fewest);
  clearance.distance = nearest.to_corner;
  if (std::isfinite(nearest.to_corner)) clearance.point = nearest.point;
  clearance.tolerance =
      HoldErrors(polygon, centre, farthest_vertex(polygon, centre), contacts).tolerance();
  return clearance;
}

bool holds_within(const Polygon& polygon, const Vec2& centre, const std::vector<Contact>& contacts,
                  double error) {
  return HoldErrors(polygon, centre, farthest_vertex(polygon, centre), contacts).hold_within(error);
}

HoldRequirements hold_requirements(const Polygon& polygon, const Vec2& centre,
                                   const Settings& settings) {
  double clear = settings.clear.value_or(usual_clear * farthest_vertex(polygon, centre));
  if (settings.method == Method::given)
    clear = std::max(0.0, clear - usual_snap * polygon.diameter());
  const double accuracy = settings.accuracy.value_or(0);
  return {settings.min_margin, clear, std::max(clear / 2, accuracy), std::max(clear, accuracy)};
}

bool is_firm(const Polygon& polygon, const Clearance& clearance, const HoldRequirements& hold) {
  const double near = near_distance(polygon.diameter());
  return clearance.distance >= hold.clear - near && clearance.tolerance >= hold.tolerance - near;
}

}  // namespace evenlift
