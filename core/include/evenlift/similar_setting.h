// Finds the setting that the user may mean by a mistyped name.
#pragma once

#include <string>
#include <string_view>

namespace evenlift {

// The name of the setting that is closest to the typed name (closest_name()); empty if no name is
// close.
std::string_view similar_setting(std::string_view typed);

// "unknown setting", or "unknown setting; did you mean weight?".
std::string unknown_setting(std::string_view typed);

}  // namespace evenlift
