// Whether a closed ring of distinct vertices is a simple polygon. The decision is exact.
#pragma once

#include <cstddef>
#include <optional>
#include <utility>

#include "evenlift/vec.h"
#include "exact/sorted_indices.h"

namespace evenlift {

// Two edges with a common point other than the vertex that neighbours share, the smaller index
// first; nullopt if there are none. The vertices must be distinct, and `order` their
// lexicographic_order. The sweep of M. I. Shamos and D. Hoey (Geometric intersection problems,
// 1976) with exact predicates. O(n log n).
std::optional<std::pair<std::size_t, std::size_t>> find_crossing(const Points& vertices,
                                                                 const SortedIndices& order);

}  // namespace evenlift
