// Draws discs of cargo, whose areas show the weights, and the object's own centre of mass.
#pragma once

#include <string>

#include "evenlift/placement.h"
#include "evenlift/vec.h"

namespace evenlift::svg {

// Adds the corners of the discs' boxes, except for items that overhang so far that the object would
// become small. O(n + items).
void add_discs_of_cargo(const Placement& placement, Points& points);

// Draws the disc of an item and the mark of the object's own centre, which is hollow. O(1).
std::string cargo_disc(const Vec2& at, double radius);
std::string own_centre_mark(const Vec2& at, double radius);

// The item's name, cut if it is long; its weight if it has no name. O(1).
std::string cargo_label(const Cargo& item, const Units& units);

}  // namespace evenlift::svg
