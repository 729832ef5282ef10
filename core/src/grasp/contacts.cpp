#include <algorithm>
#include <cmath>
#include <optional>

#include "evenlift/closure.h"
#include "evenlift/tolerance.h"
#include "exact/sorted_indices.h"
#include "grasp/grasp.h"

namespace evenlift {
namespace {

// Up to this many points, looking at every vertex costs less than sorting them.
constexpr std::size_t few_points = 32;

// The nearest vertex to a point within a distance; the first in the list wins a tie. O(1) for each
// vertex that is added.
class NearestVertex {
 public:
  NearestVertex(const Polygon& polygon, const Vec2& point, double within)
      : polygon_(polygon), point_(point), least_(within) {}

  // False only for a place that is too far away. The factor 2 exceeds the rounding of a difference.
  bool may_be(const Vec2& place) const { return std::fabs(place.x - point_.x) <= 2 * least_; }

  void add(std::uint32_t vertex) {
    const double distance = length(polygon_.vertex(vertex) - point_);
    if (distance > least_) return;
    if (nearest_ && distance == least_ && *nearest_ < vertex) return;
    nearest_ = vertex;
    least_ = distance;
  }

  const std::optional<std::uint32_t>& found() const { return nearest_; }

 private:
  const Polygon& polygon_;
  Vec2 point_;
  double least_;
  std::optional<std::uint32_t> nearest_;
};

// O(m n) for m points.
std::vector<NearestVertex> nearest_vertices(const Polygon& polygon,
                                            const std::vector<LiftingPoint>& points,
                                            double within) {
  std::vector<NearestVertex> nearest;
  nearest.reserve(points.size());
  for (const LiftingPoint& point : points) nearest.push_back({polygon, point.position, within});
  for (std::uint32_t v = 0; v < polygon.size(); ++v)
    for (NearestVertex& each : nearest)
      if (each.may_be(polygon.vertex(v))) each.add(v);
  return nearest;
}

std::vector<Contact> contacts_of(const Polygon& polygon, const std::vector<LiftingPoint>& points,
                                 const std::vector<NearestVertex>& nearest,
                                 const Corners& corners) {
  std::vector<Contact> contacts;
  const auto add = [&](const Vec2& p, std::size_t edge, std::uint32_t point) {
    const auto on = static_cast<std::uint32_t>(edge);
    contacts.push_back({p, on, point, corners.distance_to(p, on)});
  };
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    if (points[i].edge == beneath) continue;
    const std::optional<std::uint32_t>& vertex = nearest[i].found();
    if (!vertex) {
      add(points[i].position, points[i].edge, i);
      continue;
    }
    const Turn turn = polygon.turn(*vertex);
    if (turn == Turn::convex) continue;
    const bool in_notch = polygon.is_notch(*vertex);
    const std::size_t first = contacts.size();
    add(polygon.vertex(*vertex), *vertex, i);
    if (turn == Turn::reflex) add(polygon.vertex(*vertex), polygon.previous(*vertex), i);
    for (std::size_t k = first; k < contacts.size() && in_notch; ++k) {
      contacts[k].in_notch = true;
      contacts[k].to_corner = std::numeric_limits<double>::infinity();
    }
  }
  return contacts;
}

}  // namespace

ContactFinder::ContactFinder(const Polygon& polygon)
    : polygon_(polygon), near_(near_distance(polygon.diameter())), corners_(polygon) {
  cells_.reserve(polygon.size());
  for (const Vec2& v : polygon.vertices()) cells_.push_back(cell_of(v));
  by_cell_ = sorted_indices(polygon.size(), [&](std::uint32_t a, std::uint32_t b) {
    return cells_[a] != cells_[b] ? cells_[a] < cells_[b] : a < b;
  });
}

ContactFinder::Cell ContactFinder::cell_of(const Vec2& p) const {
  const double side = 4 * near_;
  return {std::floor(p.x / side), std::floor(p.y / side)};
}

template <class Take>
void ContactFinder::each_vertex_near(const Vec2& p, Take take) const {
  const Cell low = cell_of(p - Vec2(near_, near_)), high = cell_of(p + Vec2(near_, near_));
  const auto look_into = [&](const Cell& cell) {
    auto at =
        std::lower_bound(by_cell_.begin(), by_cell_.end(), cell,
                         [&](std::uint32_t v, const Cell& wanted) { return cells_[v] < wanted; });
    for (; at != by_cell_.end() && cells_[*at] == cell; ++at) take(*at);
  };
  look_into(low);
  if (low[1] != high[1]) look_into({low[0], high[1]});
  if (low[0] != high[0]) look_into({high[0], low[1]});
  if (low[0] != high[0] && low[1] != high[1]) look_into(high);
}

std::vector<Contact> ContactFinder::find(const std::vector<LiftingPoint>& points) const {
  std::vector<NearestVertex> nearest;
  nearest.reserve(points.size());
  for (const LiftingPoint& point : points) {
    nearest.push_back({polygon_, point.position, near_});
    each_vertex_near(point.position, [&](std::uint32_t v) { nearest.back().add(v); });
  }
  return contacts_of(polygon_, points, nearest, corners_);
}

Vec2 inward_normal(const Polygon& polygon, std::uint32_t edge) {
  return inward_normal(polygon.edge_start(edge), polygon.edge_end(edge),
                       polygon.counter_clockwise());
}

Vec2 inward_normal(const Vec2& from, const Vec2& to, bool counter_clockwise) {
  Vec2 along = to - from;
  // The squared length of a shorter edge would underflow.
  if (max_norm(along) < 0x1p-400) along *= 0x1p600;
  const Vec2 left = left_normal(along) / length(along);
  return counter_clockwise ? left : Vec2(-left);
}

std::vector<Contact> contacts(const Polygon& polygon, const std::vector<LiftingPoint>& points) {
  if (points.size() > few_points) return ContactFinder(polygon).find(points);
  const double near = near_distance(polygon.diameter());
  return contacts_of(polygon, points, nearest_vertices(polygon, points, near), Corners(polygon));
}

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

Margins::Margins(const Polygon& polygon, const Vec2& centre, const HoldRequirements& hold)
    : polygon_(polygon),
      centre_(centre),
      radius_(farthest_vertex(polygon, centre)),
      hold_(hold),
      finder_(polygon) {}

std::vector<Wrench> Margins::wrenches_of(const std::vector<LiftingPoint>& points) const {
  return wrenches(make_grasp(polygon_, centre_, radius_,
                             clear_contacts(polygon_, finder_.find(points), hold_.clear)));
}

std::optional<double> Margins::of(const std::vector<LiftingPoint>& points) const {
  const std::vector<Wrench> all = wrenches_of(points);
  if (all.empty()) return std::nullopt;
  return wrench_margin(all);
}

bool Margins::are_firm(const std::vector<LiftingPoint>& points,
                       const WeakestDirection& margin) const {
  const double error = hold_.tolerance - near_distance(polygon_.diameter());
  return error <= 0 || HoldErrors(polygon_, centre_, radius_, finder_.find(points))
                           .hold_within(error, hold_.clear > error ? margin : WeakestDirection{});
}

Margins::Level Margins::level_of(const std::vector<LiftingPoint>& points) const {
  const std::vector<Wrench> all = wrenches_of(points);
  if (all.empty()) return {};
  const WeakestDirection margin = weakest_direction(all);
  const std::uint32_t level = evenlift::level_of(margin.margin, level_bounds(hold_.min_margin));
  return {level > 0 && are_firm(points, margin) ? level : 0, level > 0};
}

}  // namespace evenlift
