// Convex hulls, and areas of closed rings of points.
#pragma once

#include "evenlift/vec.h"

namespace evenlift {

// The corners of the convex hull, counter-clockwise from the lowest of the leftmost, by Andrew's
// monotone chain (A. M. Andrew, Another efficient algorithm for convex hulls in two dimensions,
// 1979) with exact orientations.
//
// With `flat` above 0, corners that only rounding creates are omitted: those within `flat` of
// another, and each run of corners that a straight side can replace, if they are no farther from
// that side than tau times its length. If all points are within `flat` of one line, the result is
// their two ends; if all are equal, it is one point. O(m log m), plus O(h^2) for h corners within 4
// `flat` of one line, and O(r^2) for each run of r omitted corners.
Points convex_hull(Points points, double flat = 0);

// The convex hull of p, q and a result of convex_hull. O(m), plus the cost of omitting corners.
Points widen_hull(const Points& hull, const Vec2& p, const Vec2& q, double flat = 0);

// The greatest distance between two corners, by rotating calipers (M. I. Shamos, Computational
// geometry, 1978). The hull must come from convex_hull with `flat` 0 and have an area. O(h).
double diameter(const Points& hull);

// The area of a closed ring by the shoelace formula, relative to the first point; it is positive if
// the ring is counter-clockwise. O(m).
double signed_area(const Points& points);

}  // namespace evenlift
