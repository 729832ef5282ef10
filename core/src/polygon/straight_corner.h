// Corners of a hull that only rounding makes.
#pragma once

#include "evenlift/vec.h"

namespace evenlift {

// Whether only rounding makes a corner between two others: it is within `flat` of either, or on the
// side between them, within tau of its length. O(1).
bool is_straight_corner(const Vec2& before, const Vec2& corner, const Vec2& after, double flat);

}  // namespace evenlift
