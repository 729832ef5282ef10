// With the goal hold, choices of teams and sets of balanced robots are compared by the level of
// their margin (algorithm.md, Choosing teams that hold).
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>

namespace evenlift {

inline constexpr std::uint32_t best_level = 3;

// The least margins of levels 1, 2 and 3, ascending.
using LevelBounds = std::array<double, best_level>;
inline LevelBounds level_bounds(double min_margin) {
  constexpr double least_margin = 0.001, halfway = 0.4;
  LevelBounds bounds{least_margin, halfway * min_margin, min_margin};
  std::sort(bounds.begin(), bounds.end());
  return bounds;
}

// The level of a margin, 0 .. best_level; 0 if there is no margin.
inline std::uint32_t level_of(const std::optional<double>& margin, const LevelBounds& bounds) {
  if (!margin) return 0;
  return static_cast<std::uint32_t>(std::upper_bound(bounds.begin(), bounds.end(), *margin) -
                                    bounds.begin());
}

}  // namespace evenlift
