// Whether two edges face each other across C, without a sweep over all edges.
#pragma once

#include <cstdint>
#include <optional>

#include "evenlift/chords.h"
#include "evenlift/polygon.h"

namespace evenlift {

// The edge pair in which rays from C meet edge `a` and the opposite rays meet edge `b`. Returns
// nothing if the edges do not face each other (an exact test, as in edge_pairs()), or if the line
// of one passes within `near` of C, so that this edge is radial. O(1).
std::optional<EdgePair> pair_of_edges(const Polygon& polygon, const Vec2& centre, std::uint32_t a,
                                      std::uint32_t b, double near);

}  // namespace evenlift
