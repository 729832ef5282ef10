// The command `evenlift place --shape all`.
#pragma once

#include "commands/place_options.h"

namespace evenlift::native {

// Prints a table with a row for each shape, or with --json a line for each, even if shapes are
// refused. Throws Failure before printing if an option is invalid or needs a single shape, or the
// input cannot be read; after printing if a shape was refused or a condition is not kept.
void place_all(const PlaceOptions& options);

}  // namespace evenlift::native
