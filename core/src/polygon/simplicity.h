// Whether a closed chain of distinct vertices is a simple polygon, exactly.
#pragma once

#include <cstddef>
#include <optional>
#include <utility>

#include "evenlift/vec.h"
#include "exact/sorted_indices.h"

namespace evenlift {

// Two edges that meet other than as neighbours at their shared vertex, if there are any: the
// smaller index first. Needs distinct vertices, and their lexicographic_order. Sweep of Shamos and
// Hoey (Geometric intersection problems, 1976) over the vertices in lexicographic order, with exact
// predicates; O(n log n).
std::optional<std::pair<std::size_t, std::size_t>> find_crossing(const Points& vertices,
                                                                 const SortedIndices& order);

}  // namespace evenlift
