#include "chords/ray_caster.h"

#include <algorithm>
#include <cmath>

#include "evenlift/predicates.h"
#include "evenlift/tolerance.h"

namespace evenlift {

RayCaster::RayCaster(const Polygon& polygon, const Vec2& centre) : centre_(centre) {
  const double near = near_distance(polygon.diameter());
  edges_.reserve(polygon.size());
  vertices_.reserve(polygon.size());
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 &p = polygon.edge_start(i), &q = polygon.edge_end(i);
    vertices_.push_back(p - centre);
    const double doubled_area = orient(centre, p, q);
    const bool radial = std::fabs(doubled_area) <= near * length(q - p);
    // Counter-clockwise, so that the order of the vertex list does not affect the rounding.
    if (radial || doubled_area > 0) {
      edges_.push_back({p - centre, q - centre, doubled_area, radial});
    } else {
      edges_.push_back({q - centre, p - centre, -doubled_area, radial});
    }
  }
}

// Both edges at a vertex use this test, so it is listed once, even where the boundary touches the
// ray there and turns back.
bool RayCaster::meets_vertex(const Vec2& u, std::uint32_t vertex) const {
  return directions_agree(u, vertices_[vertex]);
}

std::uint32_t RayCaster::before(std::uint32_t vertex) const {
  return (vertex == 0 ? static_cast<std::uint32_t>(edges_.size()) : vertex) - 1;
}

std::vector<RayCaster::Hit> RayCaster::hits(const Vec2& u) const {
  std::vector<Hit> hits;
  const double unit = length(u);
  const auto n = static_cast<std::uint32_t>(edges_.size());
  const bool meets_first = meets_vertex(u, 0);
  bool meets_start = meets_first;
  for (std::uint32_t i = 0; i < n; ++i) {
    const bool meets_end = i + 1 == n ? meets_first : meets_vertex(u, i + 1);
    if (meets_start) {
      const bool ends_radial = !edges_[i].radial && edges_[before(i)].radial;
      hits.push_back({length(vertices_[i]), {centre_ + vertices_[i], ends_radial ? before(i) : i}});
    }
    // An edge met at an end is met nowhere else.
    const bool inside = !edges_[i].radial && !meets_start && !meets_end;
    meets_start = meets_end;
    if (!inside) continue;
    const Edge& edge = edges_[i];
    const bool start_left = cross(u, edge.start) >= 0, end_left = cross(u, edge.end) >= 0;
    if (start_left == end_left) continue;
    const double multiple = edge.doubled_area / cross(u, edge.end - edge.start);
    if (multiple > 0) hits.push_back({multiple * unit, {centre_ + multiple * u, i}});
  }
  std::sort(hits.begin(), hits.end(), [](const Hit& a, const Hit& b) {
    return a.distance != b.distance ? a.distance < b.distance : a.point.edge < b.point.edge;
  });
  return hits;
}

RayCaster::Hit RayCaster::farthest(const Vec2& u, const std::vector<std::uint32_t>& edges) const {
  Hit farthest{-1, {}};
  for (const std::uint32_t i : edges) {
    const Hit hit = hit_on(u, i);
    if (hit.distance > farthest.distance) farthest = hit;
  }
  return farthest;
}

RayCaster::Hit RayCaster::hit_on(const Vec2& u, std::uint32_t edge) const {
  const Edge& met = edges_[edge];
  const double side_start = cross(u, met.start), side_end = cross(u, met.end);
  const double part = std::clamp(side_start / (side_start - side_end), 0.0, 1.0);
  const Vec2 point = met.start + part * (met.end - met.start);
  return {length(point), {centre_ + point, edge}};
}

}  // namespace evenlift
