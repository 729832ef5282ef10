// Convex hulls and areas of point lists.
#pragma once

#include "evenlift/vec.h"

namespace evenlift {

// Corners of the convex hull of points, counter-clockwise from the lowest of the leftmost, by exact
// orientation: no corner is dropped for being almost straight, none kept that is straight. Points
// that all lie within `flat` of one line give the two ends; equal points give one. Andrew's
// monotone chain, O(m log m).
Points convex_hull(Points points, double flat = 0);

// The same of the corners of a hull, as convex_hull gives them, and two more points. O(m).
Points widen_hull(const Points& hull, const Vec2& p, const Vec2& q, double flat = 0);

// Signed area by the shoelace formula relative to the first point, positive counter-clockwise.
// O(m).
double signed_area(const Points& points);

}  // namespace evenlift
