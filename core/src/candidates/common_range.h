// Whether two edges face each other across C, without a sweep over all of them.
#pragma once

#include <cstdint>
#include <optional>

#include "evenlift/chords.h"
#include "evenlift/polygon.h"

namespace evenlift {

// The edge-pair of edges a and b, with a before C and b behind it, in no order; nothing if they do
// not face each other, or one of them is radial, its line being within `near` of C. Decided
// exactly, as edge_pairs() does. O(1).
std::optional<EdgePair> pair_of_edges(const Polygon& polygon, const Vec2& centre, std::uint32_t a,
                                      std::uint32_t b, double near);

}  // namespace evenlift
