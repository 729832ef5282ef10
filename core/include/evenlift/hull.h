// Convex hulls, and areas of closed rings of points.
#pragma once

#include "evenlift/vec.h"

namespace evenlift {

// The corners of the convex hull of points, counter-clockwise from the lowest of the leftmost, by
// Andrew's monotone chain (A. M. Andrew, Another efficient algorithm for convex hulls in two
// dimensions, 1979) with exact orientations.
// With `flat` above 0, corners that only rounding makes are left out: those within `flat` of
// another corner, and those between the ends of a side whose distance from it is at most tau of its
// length. Points that all lie within `flat` of one line give the two ends, equal points give
// one. O(m log m), besides O(h^2) for h corners if they lie within some `flat` of one line, and
// O(r^2) for each run of r corners that are left out.
Points convex_hull(Points points, double flat = 0);

// The convex hull of the corners of a hull, which must come from convex_hull, and two more points.
// O(m), besides what convex_hull needs where corners are left out.
Points widen_hull(const Points& hull, const Vec2& p, const Vec2& q, double flat = 0);

// The greatest distance between two corners of a hull, which must come from convex_hull with `flat`
// 0 and have an area; by rotating calipers (M. I. Shamos, Computational geometry, 1978). O(h).
double diameter(const Points& hull);

// The signed area of a ring by the shoelace formula, relative to its first point: positive if it is
// counter-clockwise. O(m).
double signed_area(const Points& points);

}  // namespace evenlift
