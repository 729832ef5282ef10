// Polygons from a family, a size and a seed. They are always valid and the same on every platform.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "evenlift/result.h"
#include "evenlift/vec.h"

namespace evenlift {

// regular: n corners on a circle. convex: irregular and convex. star: star-shaped about its centre,
// with random radii. comb: teeth that face each other across C, which makes about n^2 / 4
// edge pairs. spiral: a wound strip. random: the outline of a random tree; a ray from C meets about
// sqrt(n) edges.
enum class Family : std::uint8_t { regular, convex, star, comb, spiral, random };
inline constexpr Family all_families[] = {Family::regular, Family::convex, Family::star,
                                          Family::comb,    Family::spiral, Family::random};

// The name of a family, such as "comb"; and the family with a name, or nothing for an unknown name.
// O(1).
std::string_view name(Family family);
std::optional<Family> family_from_name(std::string_view name);

// A polygon of exactly n vertices, counter-clockwise, with coordinates in 0 .. 1000 that have at
// most three decimals up to n = 1000 and at most nine for larger n. The families regular and convex
// are strictly convex; random is not star-shaped from n = 6 on. n ranges from 3 (comb and spiral:
// 8) to max_vertices; for other n, the error names the option "n". The seed does not affect
// regular. Expected O(n); convex O(n log n).
Result<Points> generate(Family family, std::size_t n, std::uint64_t seed);

}  // namespace evenlift
