// Reads the slope of the ground as users type it.
#pragma once

#include <string_view>

#include "evenlift/settings.h"

namespace evenlift {

// Reads a ratio such as 0.08, a percentage such as 8%, or an angle such as 4.6deg. Returns whether
// the text is valid and its value in range. If so, stores the value as a ratio.
bool read_slope(std::string_view text, const SettingRange& range, double& slope);

}  // namespace evenlift
