// Clips rings, closed polygonal lines, by half-planes (I. E. Sutherland and G. W. Hodgman,
// Reentrant polygon clipping, 1974).
#pragma once

#include "evenlift/vec.h"

namespace evenlift {

// The part of the ring on or to the left of the line a -> b. Parts of a ring that is not convex may
// be connected by overlapping edges along the line; the signed area is still correct. O(m) for m
// vertices.
Points clip_left(const Points& ring, const Vec2& a, const Vec2& b);

// Clips by the line through `from` along `direction`. If two close points were moved, rounding may
// have turned their line; then pass the difference of the original points as `direction`. O(m).
Points clip_left_of_ray(const Points& ring, const Vec2& from, const Vec2& direction);

// The signed area of the part of the ring to the left of both a -> b and b -> c. The function clips
// twice in one pass, without storing the result. O(m).
double area_left_of_both(const Points& ring, const Vec2& a, const Vec2& b, const Vec2& c);

}  // namespace evenlift
