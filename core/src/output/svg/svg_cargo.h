// Discs of cargo, whose area tells the weight, and the object's own centre of mass.
#pragma once

#include <string>

#include "evenlift/placement.h"
#include "evenlift/vec.h"

namespace evenlift::svg {

// The corners of their boxes, except of items that overhang so far that the object would become
// small. O(n + items).
void add_discs_of_cargo(const Placement& placement, Points& points);

// The mark is hollow. O(1).
std::string cargo_disc(const Vec2& at, double radius);
std::string own_centre_mark(const Vec2& at, double radius);

// The item's name, cut if long, or else its weight. O(1).
std::string cargo_label(const Cargo& item, const Units& units);

}  // namespace evenlift::svg
