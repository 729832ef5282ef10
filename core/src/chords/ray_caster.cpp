#include "chords/radial_view.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "evenlift/predicates.h"
#include "evenlift/tolerance.h"

namespace evenlift {

Across look_across(const Vec2& centre, const Vec2& w, const Vec2& b, const Vec2& c,
                   double doubled_area) {
  // With X = (C - w) x (c - b) and h = (b - C) x (c - C), the doubled area, the factor is h / X.
  // The sign of h - X shows on which side of the edge the mirror image of w lies. That difference
  // is accurate, so factors near 1 are accurate relative to their difference from 1.
  const double x = cross_of_differences(w, centre, b, c);
  const double difference = orient_mirrored(centre, w, b, c);
  Across across;
  across.compare_to_one = (difference > 0) - (difference < 0);
  if (std::fabs(difference) < 0.5 * x) {
    across.factor = 1.0 + difference / x;
  } else {
    across.factor = doubled_area / x;
  }
  return across;
}

std::optional<double> estimate_across(const Vec2& centre, const Vec2& w, const Vec2& b,
                                      const Vec2& c, double doubled_area) {
  const double first = (centre.x - w.x) * (c.y - b.y), second = (centre.y - w.y) * (c.x - b.x);
  // The two products together have an error below 2^-50 of their sizes; the relative error of the
  // area is below 2^-45.
  constexpr double filter_threshold = 0x1p-15, smallest_safe = 0x1p-800;
  const double x = first - second, size = std::fabs(first) + std::fabs(second);
  if (!(x > filter_threshold * size && size > smallest_safe)) return std::nullopt;
  return doubled_area / x;
}

bool points_right(const Vec2& direction) {
  return is_vertical(direction) ? direction.y > 0 : direction.x > 0;
}

double load_ratio(double arm1, double arm2) { return arm1 < arm2 ? arm1 / arm2 : arm2 / arm1; }

Chord order_ends(const LiftingPoint& ahead, double arm_ahead, const LiftingPoint& behind,
                 double arm_behind, const Vec2& direction) {
  Chord chord{behind, ahead, arm_behind, arm_ahead, load_ratio(arm_ahead, arm_behind)};
  if (!points_right(direction)) {
    std::swap(chord.r1, chord.r2);
    std::swap(chord.arm1, chord.arm2);
  }
  return chord;
}

Chord chord_from_vertex(const Polygon& polygon, const Vec2& centre, std::uint32_t w,
                        std::uint32_t edge_w, const Across& across, std::uint32_t edge_hit,
                        std::uint32_t hit) {
  const Vec2& position = polygon.vertex(w);
  const Vec2 direction = centre - position;
  const double arm = length(direction);
  const bool at_vertex = hit != inside_edge;
  const Vec2 far = at_vertex ? polygon.vertex(hit) : Vec2(centre + across.factor * direction);
  const LiftingPoint start{position, edge_w}, end{far, edge_hit};
  Chord chord = order_ends(end, across.factor * arm, start, arm, direction);
  // From the factor, which is exact if the halves are equal, not from the arms.
  chord.ratio = across.compare_to_one > 0 ? 1.0 / across.factor : across.factor;
  return chord;
}

bool same_chord(const Chord& a, const Chord& b, double near) {
  const auto close = [&](const LiftingPoint& p, const LiftingPoint& q) {
    return length(p.position - q.position) <= near;
  };
  return (close(a.r1, b.r1) && close(a.r2, b.r2)) || (close(a.r1, b.r2) && close(a.r2, b.r1));
}

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
