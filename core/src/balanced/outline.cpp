#include "balanced/outline.h"

#include <algorithm>

#include "evenlift/tolerance.h"
#include "exact/sorted_indices.h"

namespace evenlift::balanced {
namespace {

constexpr std::size_t many_vertices = 1000;
constexpr std::uint32_t usual_stands = 64, stands_of_many_vertices = 16;

// v*: of the vertices farthest from C within tolerance the leftmost, then the lowest.
std::uint32_t first_vertex(const Polygon& polygon, const Vec2& centre) {
  const double farthest = farthest_vertex(polygon, centre);
  const double near = near_distance(polygon.diagonal());
  std::optional<std::uint32_t> first;
  for (std::uint32_t v = 0; v < polygon.size(); ++v) {
    if (length(polygon.vertex(v) - centre) < farthest - near) continue;
    if (!first || lexicographically_before(polygon.vertex(v), polygon.vertex(*first))) first = v;
  }
  return *first;
}

}  // namespace

Outline::Outline(const Polygon& polygon, const Vec2& centre)
    : polygon_(polygon), steps_(polygon.size()) {
  std::uint32_t here = first_vertex(polygon, centre);
  starts_.push_back(0);
  for (std::uint32_t step = 0; step < polygon.size(); ++step) {
    const auto next = static_cast<std::uint32_t>(
        polygon.counter_clockwise() ? polygon.next(here) : polygon.previous(here));
    vertices_.push_back(here);
    steps_[polygon.counter_clockwise() ? here : next] = step;
    starts_.push_back(starts_.back() +
                      evenlift::length(polygon.vertex(next) - polygon.vertex(here)));
    here = next;
  }
}

double Outline::place(const LiftingPoint& point) const {
  const std::uint32_t step = steps_[point.edge];
  const double place =
      starts_[step] + evenlift::length(point.position - polygon_.vertex(vertices_[step]));
  return place < length() - tau * length() ? place : 0;
}

std::vector<LiftingPoint> Outline::even_stands(std::uint32_t number) const {
  std::vector<LiftingPoint> stands;
  std::size_t step = 0;
  for (std::uint32_t j = 0; j < number; ++j) {
    const double place = (j + 0.5) * length() / number;
    while (step + 1 < vertices_.size() && starts_[step + 1] <= place) ++step;
    const std::uint32_t from = vertices_[step],
                        to = vertices_[step + 1 < vertices_.size() ? step + 1 : 0];
    const Vec2 &a = polygon_.vertex(from), &b = polygon_.vertex(to);
    const double part = (place - starts_[step]) / (starts_[step + 1] - starts_[step]);
    stands.push_back({a + part * (b - a), polygon_.counter_clockwise() ? from : to});
  }
  return stands;
}

std::vector<LiftingPoint> Outline::reflex_stands(std::uint32_t most) const {
  std::vector<LiftingPoint> stands;
  for (const std::uint32_t v : vertices_) {
    if (polygon_.turn(v) != Turn::reflex) continue;
    if (stands.size() == most) return {};
    stands.push_back({polygon_.vertex(v), v});
  }
  return stands;
}

std::vector<LiftingPoint> Outline::stands() const {
  const std::uint32_t number =
      vertices_.size() > many_vertices ? stands_of_many_vertices : usual_stands;
  std::vector<LiftingPoint> stands = even_stands(number);
  const std::vector<LiftingPoint> reflex = reflex_stands(number);
  stands.insert(stands.end(), reflex.begin(), reflex.end());
  return stands;
}

}  // namespace evenlift::balanced
