#include "balanced/outline.h"

#include <algorithm>

#include "evenlift/tolerance.h"
#include "exact/sorted_indices.h"

namespace evenlift::balanced {
namespace {

constexpr std::size_t many_vertices = 1000;
constexpr std::uint32_t usual_stands = 64, stands_of_many_vertices = 16;

// v*: among the vertices farthest from C within tolerance, the leftmost, then the lowest.
std::uint32_t first_vertex(const Polygon& polygon, const Vec2& centre) {
  const double farthest = farthest_vertex(polygon, centre);
  const double near = near_distance(polygon.diameter());
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

// In a clockwise list, a step runs against the edge that ends at its vertex.
std::uint32_t Outline::edge_of_step(std::size_t step) const {
  const std::uint32_t vertex = vertices_[step];
  return polygon_.counter_clockwise() ? vertex
                                      : static_cast<std::uint32_t>(polygon_.previous(vertex));
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

std::vector<LiftingPoint> Outline::usable_stands(std::uint32_t number, const Stands& room) const {
  double total = 0;
  for (std::uint32_t edge = 0; edge < vertices_.size(); ++edge)
    for (const Stretch& stretch : room.usable(edge)) total += stretch.to - stretch.from;
  std::vector<LiftingPoint> stands;
  double before = 0;
  for (std::size_t step = 0; step < vertices_.size(); ++step) {
    const std::uint32_t edge = edge_of_step(step);
    const Vec2 &p = polygon_.edge_start(edge), &q = polygon_.edge_end(edge);
    const double size = evenlift::length(q - p);
    std::vector<Stretch> stretches(room.usable(edge).begin(), room.usable(edge).end());
    if (!polygon_.counter_clockwise()) std::reverse(stretches.begin(), stretches.end());
    for (const Stretch& stretch : stretches) {
      const double part = stretch.to - stretch.from;
      while (stands.size() < number) {
        const double way = (static_cast<double>(stands.size()) + 0.5) * total / number - before;
        if (way > part) break;
        const double t = polygon_.counter_clockwise() ? stretch.from + way : stretch.to - way;
        stands.push_back(room.lifting_point({p + (t / size) * (q - p), edge}));
      }
      before += part;
    }
  }
  return stands;
}

std::vector<std::uint32_t> Outline::edges() const {
  std::vector<std::uint32_t> edges;
  edges.reserve(vertices_.size());
  for (std::size_t step = 0; step < vertices_.size(); ++step) edges.push_back(edge_of_step(step));
  return edges;
}

std::vector<LiftingPoint> Outline::interval_stands(std::uint32_t most, const Stands& room) const {
  std::vector<LiftingPoint> stands;
  for (const std::uint32_t edge : edges()) {
    const Vec2 &p = polygon_.edge_start(edge), &q = polygon_.edge_end(edge);
    const double size = evenlift::length(q - p);
    std::vector<Stretch> stretches(room.usable(edge).begin(), room.usable(edge).end());
    if (!polygon_.counter_clockwise())
      for (Stretch& stretch : stretches) std::swap(stretch.from, stretch.to);
    if (!polygon_.counter_clockwise()) std::reverse(stretches.begin(), stretches.end());
    for (const Stretch& stretch : stretches) {
      if (stands.size() == 3 * std::size_t{most}) return {};
      for (const double t : {stretch.from, (stretch.from + stretch.to) / 2, stretch.to})
        stands.push_back(room.lifting_point({p + (t / size) * (q - p), edge}));
    }
  }
  return stands;
}

std::vector<LiftingPoint> Outline::stands(const Stands* room) const {
  const std::uint32_t number =
      vertices_.size() > many_vertices ? stands_of_many_vertices : usual_stands;
  std::vector<LiftingPoint> stands = room ? usable_stands(number, *room) : even_stands(number);
  const std::vector<LiftingPoint> more =
      room ? interval_stands(number, *room) : reflex_stands(number);
  stands.insert(stands.end(), more.begin(), more.end());
  return stands;
}

}  // namespace evenlift::balanced
