// Polygons from a family, a size and a seed: always valid, and the same on every platform.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "evenlift/result.h"
#include "evenlift/vec.h"

namespace evenlift {

// The families of polygons. regular: n corners on a circle. convex: an irregular convex polygon.
// star: star-shaped about its centre, with random radii. comb: teeth that face each other across C,
// with about n^2 / 4 edge pairs. spiral: a wound strip. random: the outline of a random tree; a ray
// from C meets about sqrt(n) edges.
enum class Family : std::uint8_t { regular, convex, star, comb, spiral, random };
inline constexpr Family all_families[] = {Family::regular, Family::convex, Family::star,
                                          Family::comb,    Family::spiral, Family::random};

// name() returns a family's name, such as "comb"; family_from_name() returns the family of a name,
// if it is known. O(1).
std::string_view name(Family family);
std::optional<Family> family_from_name(std::string_view name);

// A polygon of n vertices, counter-clockwise, with coordinates in 0 .. 1000. They have at most
// three decimals up to n = 1000, otherwise at most nine. regular and convex are strictly convex;
// random is not star-shaped from n = 6 on. n is 3 (comb and spiral: 8) .. max_vertices; for other
// n, the error names the option "n". The seed does not affect regular. Expected O(n); convex O(n
// log n).
Result<Points> generate(Family family, std::size_t n, std::uint64_t seed);

}  // namespace evenlift
