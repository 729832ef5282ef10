// The levels of a margin compare sets of teams or balanced robots with the goal hold
// (algorithm.md).
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>

namespace evenlift {

inline constexpr std::uint32_t best_level = 3;

// The margins of the levels 1 to 3, ascending.
using LevelBounds = std::array<double, best_level>;
inline LevelBounds level_bounds(double min_margin) {
  constexpr double least_margin = 0.001, halfway = 0.4;
  LevelBounds bounds{least_margin, halfway * min_margin, min_margin};
  std::sort(bounds.begin(), bounds.end());
  return bounds;
}

// 0 without a margin.
inline std::uint32_t level_of(const std::optional<double>& margin, const LevelBounds& bounds) {
  if (!margin) return 0;
  return static_cast<std::uint32_t>(std::upper_bound(bounds.begin(), bounds.end(), *margin) -
                                    bounds.begin());
}

}  // namespace evenlift
