// Generates polygons from a family, a size and a seed. They are always valid, and the same on every
// platform.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "evenlift/result.h"
#include "evenlift/vec.h"

namespace evenlift {

// The families of polygons. `regular`: n corners on a circle. `convex`: an irregular convex
// polygon. `star`: star-shaped about its centre, with random radii. `comb`: teeth that face each
// other across C, with about n^2 / 4 edge pairs. `spiral`: a coiled strip. `random`: the outline of
// a random tree; a ray from C meets about sqrt(n) edges.
enum class Family : std::uint8_t { regular, convex, star, comb, spiral, random };
inline constexpr Family all_families[] = {Family::regular, Family::convex, Family::star,
                                          Family::comb,    Family::spiral, Family::random};

// name() returns a family's name, such as "comb"; family_from_name() returns the family with this
// name, if any. O(1).
std::string_view name(Family family);
std::optional<Family> family_from_name(std::string_view name);

// Returns a polygon of n vertices in counter-clockwise order, with coordinates from 0 to 1000. The
// coordinates have at most three decimals if n is at most 1000, otherwise at most nine. Polygons of
// the families `regular` and `convex` are strictly convex; those of `random` are not star-shaped if
// n is at least 6. If n is below 3 (`comb` and `spiral`: below 8) or above max_vertices, the error
// names the option "n". The seed does not affect `regular`. Expected O(n); `convex`: O(n log n).
Result<Points> generate(Family family, std::size_t n, std::uint64_t seed);

}  // namespace evenlift
