// The command `evenlift place --shape all`.
#pragma once

#include "commands/place_options.h"

namespace evenlift::native {

// Prints a table with a row for each shape, or with --json a line for each, even if shapes are
// refused. Throws Failure before printing for options that show or write one placement, and after
// printing if a shape was refused or a condition is not kept.
void place_all(const PlaceOptions& options);

}  // namespace evenlift::native
