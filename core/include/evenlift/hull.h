// Convex hulls, and areas of closed rings of points.
#pragma once

#include "evenlift/vec.h"

namespace evenlift {

// Returns the corners of the convex hull of m points, counter-clockwise from the lowest of the
// leftmost corners, by Andrew's monotone chain (A. M. Andrew, Another efficient algorithm for
// convex hulls in two dimensions, 1979) with exact orientations.
//
// With `flat` above 0, corners that only rounding creates are omitted. These are corners within
// `flat` of another corner, and runs of corners that one straight side can replace: every corner of
// the run is at most tau times the side's length from the side. If all points are within `flat` of
// one line, the result is the two extremes; if all points are equal, it is one point. O(m log m),
// plus O(h^2) if all h corners are within 4 `flat` of one line, and O(r^2) for each run of r
// omitted corners.
Points convex_hull(Points points, double flat = 0);

// Returns the convex hull of p, q and `hull`, which must come from convex_hull(). O(h) for h
// corners, plus the cost of omitting corners.
Points widen_hull(const Points& hull, const Vec2& p, const Vec2& q, double flat = 0);

// Returns the greatest distance between two corners, by rotating calipers (M. I. Shamos,
// Computational geometry, 1978). The hull must come from convex_hull with `flat` 0 and have an
// area. O(h).
double diameter(const Points& hull);

// Returns the area of a closed ring of m points by the shoelace formula, with coordinates relative
// to the first point. The area is positive if the ring is counter-clockwise. O(m).
double signed_area(const Points& points);

}  // namespace evenlift
