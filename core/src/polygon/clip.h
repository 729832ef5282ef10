// Clipping by half-planes.
#pragma once

#include "evenlift/vec.h"

namespace evenlift {

// The part of a closed chain on or to the left of the line a -> b: Sutherland and Hodgman. Of a
// polygon that is not convex the parts may hang together along the line; its signed area is right.
// O(m).
Points clip_left(const Points& chain, const Vec2& a, const Vec2& b);

// The same for the line through a point in a direction: for points so near to each other that, once
// they are moved, the line through them is another.
Points clip_left_of_ray(const Points& chain, const Vec2& from, const Vec2& direction);

// The signed area of what is left of a closed chain, clipped to the left of a -> b and then of b ->
// c: in one pass, without keeping it. O(m).
double area_left_of_both(const Points& chain, const Vec2& a, const Vec2& b, const Vec2& c);

}  // namespace evenlift
