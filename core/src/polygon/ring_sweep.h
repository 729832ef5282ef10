// Whether closed rings cross, and which lies in which. All decisions are exact.
#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "evenlift/vec.h"
#include "exact/sorted_indices.h"

namespace evenlift {

// Closed rings in one list of vertices: ring r ends before ends[r]. Edge i of the list runs from
// vertex i to the next vertex of its ring.
struct Rings {
  Points vertices;
  std::vector<std::size_t> ends;
  std::vector<bool> counter_clockwise;  // by ring; needed only for more than one
  std::size_t size() const { return ends.size(); }
  std::size_t begin(std::size_t ring) const { return ring == 0 ? 0 : ends[ring - 1]; }
};

struct RingSweep {
  // Two edges with a common point other than the vertex that neighbours share, the smaller index
  // first; nothing if there are none.
  std::optional<std::pair<std::size_t, std::size_t>> crossing;
  // If there are none: the innermost ring around each ring.
  std::vector<std::optional<std::size_t>> around;
};

// Checks distinct vertices, whose lexicographic_order is `order`. The sweep of M. I. Shamos and D.
// Hoey (Geometric intersection problems, 1976) with exact predicates. O(n log n).
RingSweep sweep(const Rings& rings, const SortedIndices& order);

}  // namespace evenlift
