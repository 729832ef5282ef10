// Clipping by half-planes.
#pragma once

#include "evenlift/vec.h"

namespace evenlift {

// The part of a closed chain on or to the left of the line a -> b: Sutherland and Hodgman. Of a
// polygon that is not convex the parts may hang together along the line; its signed area is right.
// O(m).
Points clip_left(const Points& chain, const Vec2& a, const Vec2& b);

}  // namespace evenlift
