// Small polygons with holes, one for each number, for comparing the core with the oracle.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "oracle/oracle.h"
#include "shapes/small_polygons.h"

namespace holed_polygons {

/// At most `most` holes in a polygon: stars and convex rings about random points, in either
/// orientation, as large as they happen to fit. Every fourth grows until it almost touches another
/// ring. Each fits exactly. There may be fewer, or none if the polygon is thin.
std::vector<oracle::Ring> holes_in(const oracle::Ring& outline, std::uint64_t seed,
                                   std::size_t most);

/// A case with one to six holes, as far as they fit.
small_polygons::Case with_holes(small_polygons::Case c, std::uint64_t number);

/// The plain case of that number (small_polygons.h) with holes. Its C is the given one, or the
/// centroid without the holes.
small_polygons::Case make_case(std::uint64_t number);

/// Rings on a grid so small that they often cross, touch or contain each other: rarely valid. The
/// first is a valid polygon.
std::vector<oracle::Ring> careless_rings(std::uint64_t number);

}  // namespace holed_polygons
