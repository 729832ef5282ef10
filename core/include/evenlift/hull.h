// Convex hulls and areas of point lists.
#pragma once

#include "evenlift/vec.h"

namespace evenlift {

// Corners of the convex hull of points, counter-clockwise from the lowest of the leftmost. They are
// found by exact orientation (Andrew's monotone chain). With `flat` above 0, those are left out
// that lie within `flat` of another corner, or off a side between the corners that stay by at most
// tau of its length: points on one line are so however rounding has moved them. Points that all lie
// within `flat` of one line give the two ends; equal points give one. O(m log m), and O(r^2) for
// each run of r corners that are left out.
Points convex_hull(Points points, double flat = 0);

// The hull of the corners of a hull, as convex_hull gives them, and two more points. O(m), and
// O(r^2) for each run of r corners that are left out.
Points widen_hull(const Points& hull, const Vec2& p, const Vec2& q, double flat = 0);

// Signed area by the shoelace formula relative to the first point, positive counter-clockwise.
// O(m).
double signed_area(const Points& points);

}  // namespace evenlift
