// Whether two edges face each other across C, without a sweep over all edges.
#pragma once

#include <cstdint>
#include <optional>

#include "evenlift/chords.h"
#include "evenlift/polygon.h"

namespace evenlift {

// The edge pair with edge a ahead of C and edge b behind it. Nothing if they do not face each
// other, or if one is radial because its line passes within `near` of C. Exact, like edge_pairs().
// O(1).
std::optional<EdgePair> pair_of_edges(const Polygon& polygon, const Vec2& centre, std::uint32_t a,
                                      std::uint32_t b, double near);

}  // namespace evenlift
