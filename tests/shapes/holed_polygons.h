// Small polygons with holes, one per number, for comparing the core with the oracle.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "oracle/oracle.h"
#include "shapes/small_polygons.h"

namespace holed_polygons {

/// At most `most` holes, perhaps none in a thin polygon: stars and convex rings about random
/// points, in either orientation, as large as fits. Every fourth grows until it almost touches
/// another ring. Each fits exactly.
std::vector<oracle::Ring> holes_in(const oracle::Ring& outline, std::uint64_t seed,
                                   std::size_t most);

/// With one to six holes, as far as they fit.
small_polygons::Case with_holes(small_polygons::Case c, std::uint64_t number);

/// That number's plain case (small_polygons.h) with holes. C is the given one, or the centroid
/// without holes.
small_polygons::Case make_case(std::uint64_t number);

/// On a grid so small that rings often cross, touch or contain each other: rarely valid. The first
/// is a valid polygon.
std::vector<oracle::Ring> careless_rings(std::uint64_t number);

}  // namespace holed_polygons
