// `evenlift place --shape all`: places robots on every shape of a file.
#pragma once

#include "commands/place_options.h"

namespace evenlift::native {

// Prints a table with a row for each shape, or with --json a line for each. A shape that is refused
// does not stop the others. Throws Failure: for options that show or write one placement, before
// anything is printed; after printing, if a shape was refused or a condition is not kept.
void place_all(const PlaceOptions& options);

}  // namespace evenlift::native
