// The heat map's levels: forces that tip the object, in units of its weight. A band of the heat map
// is between two levels, below the first or above the last.
#pragma once

namespace evenlift::view {

inline constexpr double heat_levels[] = {0.1, 0.2, 0.5, 1, 2};

}  // namespace evenlift::view
