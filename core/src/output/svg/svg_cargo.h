// Draws discs of cargo, whose areas show the weights, and the object's own centre of mass.
#pragma once

#include <string>

#include "evenlift/report.h"
#include "evenlift/vec.h"

namespace evenlift::svg {

// Adds corners of the boxes around the discs. Leaves out items whose middle is more than L/2
// outside the object's box, since the picture would otherwise show a small object. O(n + items).
void add_discs_of_cargo(const Placement& placement, Points& points);

// Draw the disc of an item, and the hollow mark of the centre of mass without cargo. O(1).
std::string cargo_disc(const Vec2& at, double radius);
std::string own_centre_mark(const Vec2& at, double radius);

// The item's name, cut if it is long; its weight if it has no name. O(1).
std::string cargo_label(const Cargo& item, const Units& units);

}  // namespace evenlift::svg
