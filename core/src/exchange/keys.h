// When keys of choices tie.
#pragma once

#include <cstdint>

namespace evenlift::exchange {

inline constexpr double coverage_tie = 1e-9;
inline constexpr std::uint32_t best_level = 3;

}  // namespace evenlift::exchange
