// The least size of coordinates.
#pragma once

#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "evenlift/document.h"
#include "evenlift/vec.h"
#include "exact/sorted_indices.h"

namespace evenlift {

// Whether a coordinate is not 0 but nearer to 0 than is accepted. Differences of accepted
// coordinates are 0 or at least 1e-116 in size, so lengths, areas and moments of even the thinnest
// object stay far from underflow. O(1).
inline bool is_too_near_to_0(double coordinate) {
  return coordinate != 0 && std::fabs(coordinate) < min_coordinate;
}
inline bool is_too_near_to_0(const Vec2& v) {
  return is_too_near_to_0(v.x) || is_too_near_to_0(v.y);
}

// --- Finds edges of rings that cross or touch, and for each ring the innermost ring around it. All
// decisions are exact.

// Rings in one list of vertices: ring r ends before ends[r]. Edge i runs from vertex i to the next
// vertex of its ring.
struct Rings {
  Points vertices;
  std::vector<std::size_t> ends;
  std::vector<bool> counter_clockwise;  // by ring; needed only if there is more than one ring
  std::size_t size() const { return ends.size(); }
  std::size_t begin(std::size_t ring) const { return ring == 0 ? 0 : ends[ring - 1]; }
};

struct RingSweep {
  // Two edges with a common point, the smaller index first; nullopt if there are no such edges. The
  // vertex that neighbours share does not count.
  std::optional<std::pair<std::size_t, std::size_t>> crossing;
  // For each ring, the innermost ring around it; nullopt if there is none. The list is filled only
  // if there is no crossing.
  std::vector<std::optional<std::size_t>> around;
};

// The sweep of M. I. Shamos and D. Hoey (Geometric intersection problems, 1976) with exact
// predicates. The vertices must be distinct. `order` is their lexicographic_order(). O(n log n).
RingSweep sweep(const Rings& rings, const SortedIndices& order);

}  // namespace evenlift
