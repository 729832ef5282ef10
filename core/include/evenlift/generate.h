// Polygons from a family, a size and a seed: the same on every platform, always valid.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "evenlift/result.h"
#include "evenlift/vec.h"

namespace evenlift {

// regular: n corners on a circle. convex: irregular convex. star: star-shaped about its centre,
// random radii. comb: teeth facing each other across C, so that edge-pairs number about n^2 / 4.
// spiral: a wound strip. random: the outline of a random tree, of which a ray from C meets about
// sqrt(n) edges.
enum class Family : std::uint8_t { regular, convex, star, comb, spiral, random };
inline constexpr Family all_families[] = {Family::regular, Family::convex, Family::star,
                                          Family::comb,    Family::spiral, Family::random};
std::string_view name(Family family);
std::optional<Family> family_from_name(std::string_view name);

// Exactly n vertices, counter-clockwise, coordinates within 0 .. 1000 on a decimal grid (three
// decimals up to n = 1000, at most nine beyond). Strictly convex in the families regular and
// convex; random is not star-shaped from n = 6 on. n from 3 (comb and spiral: 8) to max_vertices;
// the error names the option "n". The seed does not change regular. Expected O(n), convex
// O(n log n).
Result<Points> generate(Family family, std::size_t n, std::uint64_t seed);

}  // namespace evenlift
