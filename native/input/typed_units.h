// Units behind typed numbers.
#pragma once

#include <string>

#include "evenlift/settings.h"

namespace evenlift::native {

// The text of a setting with each number that has a unit, as in "30 lb", "600mm" or "3,4:5kg:motor",
// converted to these units and without its own. Units of settings that take none, names, and words that are
// no unit stay as they are, to be refused. Converted numbers have the digits that were
// typed, at least nine and at most twelve. Throws Failure if a length has a unit and the coordinates have none. O(bytes).
std::string in_own_units(Setting setting, const std::string& text, const Units& units);

}  // namespace evenlift::native
