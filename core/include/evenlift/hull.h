// Convex hulls, and areas of closed rings of points.
#pragma once

#include "evenlift/vec.h"

namespace evenlift {

// The corners of the convex hull of points, counter-clockwise from the lowest of the leftmost, by
// Andrew's monotone chain (A. M. Andrew, Another efficient algorithm for convex hulls in two
// dimensions, 1979) with exact orientations.
//
// With `flat` above 0, corners that only rounding creates are omitted. These are corners within
// `flat` of another corner, and each run of corners that one straight side can replace because none
// of them is farther from that side than tau times the side's length. If all points lie within
// `flat` of one line, the result is the two ends; if all are equal, one point. O(m log m), plus
// O(h^2) for h corners if they lie within 4 `flat` of one line, and O(r^2) for each run of r
// omitted corners.
Points convex_hull(Points points, double flat = 0);

// The convex hull of the points p and q and the corners of `hull`, which must come from
// convex_hull. O(m), plus the cost of omitting corners in convex_hull.
Points widen_hull(const Points& hull, const Vec2& p, const Vec2& q, double flat = 0);

// The greatest distance between two corners of a hull, by rotating calipers (M. I. Shamos,
// Computational geometry, 1978). The hull must come from convex_hull with `flat` 0 and have an
// area. O(h).
double diameter(const Points& hull);

// The signed area of a ring by the shoelace formula, relative to its first point: positive if the
// ring is counter-clockwise. O(m).
double signed_area(const Points& points);

}  // namespace evenlift
