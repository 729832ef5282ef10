// The levels of the heat map: of the object's weight, the forces that tip it. Between two
// neighbours lies a band.
#pragma once

namespace evenlift::view {

inline constexpr double heat_levels[] = {0.1, 0.2, 0.5, 1, 2};

}  // namespace evenlift::view
