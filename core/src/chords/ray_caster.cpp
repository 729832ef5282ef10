#include "chords/ray_caster.h"

#include <algorithm>
#include <cmath>

#include "evenlift/predicates.h"
#include "evenlift/tolerance.h"

namespace evenlift {

RayCaster::RayCaster(const Polygon& polygon, const Vec2& centre) : centre_(centre) {
  const double near = near_distance(polygon.diameter());
  edges_.reserve(polygon.size());
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 &p = polygon.edge_start(i), &q = polygon.edge_end(i);
    const double doubled_area = orient(centre, p, q);
    const bool radial = std::fabs(doubled_area) <= near * length(q - p);
    // Counter-clockwise about C, so that the order of the vertex list does not affect the rounding.
    if (radial || doubled_area > 0) {
      edges_.push_back({p - centre, q - centre, doubled_area, radial});
    } else {
      edges_.push_back({q - centre, p - centre, -doubled_area, radial});
    }
  }
}

std::vector<RayCaster::Hit> RayCaster::hits(const Vec2& u) const {
  std::vector<Hit> hits;
  const double unit = length(u);
  for (std::uint32_t i = 0; i < edges_.size(); ++i) {
    const Edge& edge = edges_[i];
    if (edge.radial) {
      // Each vertex counts once: as the start of its edge, or as the end if the next edge is not
      // radial and so does not list it.
      if (directions_agree(u, edge.start))
        hits.push_back({length(edge.start), {centre_ + edge.start, i}});
      const std::uint32_t next = i + 1 == edges_.size() ? 0 : i + 1;
      if (!edges_[next].radial && directions_agree(u, edge.end)) {
        hits.push_back({length(edge.end), {centre_ + edge.end, i}});
      }
      continue;
    }
    // Half-open, so that a vertex on the ray belongs to exactly one of its two edges.
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
