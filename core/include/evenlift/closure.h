// Whether the robots also immobilize the object (algorithm.md, Immobilization; thesis 5.5).
//
// The terms are those of the literature on grasps. First-order form closure is decided by
// Reuleaux's method: the instantaneous centres of rotation that each contact leaves free form a
// half-plane, and the grasp is closed if the clockwise half-planes have no point in common, nor the
// counter-clockwise ones, and no translation is free (F. Reuleaux, The Kinematics of Machinery,
// 1876). The margin is the grasp quality of C. Ferrari and J. Canny (Planning optimal grasps,
// 1992). Second-order immobility follows E. Rimon and J. W. Burdick (Mobility of bodies in contact,
// 1998).
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "evenlift/chords.h"

namespace evenlift {

// A frictionless contact of a robot with an edge.
struct Contact {
  Vec2 position = Vec2::Zero();
  std::uint32_t edge = 0;
  std::uint32_t point = 0;  // index of the lifting point it belongs to
};

// The direction in which a contact with this edge pushes, of unit length; and the same for an edge
// between two vertices of a polygon of the given orientation. O(1).
Vec2 inward_normal(const Polygon& polygon, std::uint32_t edge);
Vec2 inward_normal(const Vec2& from, const Vec2& to, bool counter_clockwise);

// The contacts of lifting points. A robot has one contact inside an edge, two at a reflex vertex,
// one at a straight vertex and none at a convex vertex. It is at a vertex if it is within tau L of
// it. O((m + n) log n) for m points.
std::vector<Contact> contacts(const Polygon& polygon, const std::vector<LiftingPoint>& points);

// The free instantaneous centres of rotation of one sense: a convex region, which may be unbounded
// or far away.
struct FreeRegion {
  bool exists = false;    // some centre is free, wherever it lies
  bool has_area = false;  // false: the region is a point or a line, up to tolerance
  Points clipped;         // the region within the square about C with half side 100 diagonal(),
                          // counter-clockwise; no, one or two points if it has no area there
};

// The regions of free rotation centres that contacts leave. O(n + m log m) for m contacts on e edges,
// and O(e^2) to clip a region at worst, or if it has no area.
struct FreeRegions {
  FreeRegion clockwise, counterclockwise;
};
FreeRegions free_regions(const Polygon& polygon, const Vec2& centre,
                         const std::vector<Contact>& contacts);

struct Closure {
  bool form_closure = false;  // no motion is free to first order
  // Ferrari and Canny's quality: the radius of the largest ball about the origin in the convex hull
  // of the contacts' wrenches (n, (p - C) x n / R), n being the inward unit normal; if the origin is
  // outside, minus its distance from the hull. Above 0 in form closure; none without contacts.
  std::optional<double> margin;
  bool second_order = false;  // immobile to second order, though motions are free to first order
  bool translation_free = true;
  std::optional<Vec2> translation;  // a free direction, unit length, if any
  FreeRegion clockwise, counterclockwise;
};

// Only how firmly the contacts hold: the same as in their Closure, but cheaper if the contacts are
// known. O(n + m log m) for m contacts, and O(e^2) on e edges. The same for robots at `points`.
struct Hold {
  bool form_closure = false;
  std::optional<double> margin;
};
Hold analyse_hold(const Polygon& polygon, const Vec2& centre, const std::vector<Contact>& contacts);
Hold analyse_hold(const Polygon& polygon, const Vec2& centre,
                  const std::vector<LiftingPoint>& points);

// The same as analyse_closure(...).form_closure, but cheaper. Adding points cannot undo it.
// O(m log m + n log n).
bool in_form_closure(const Polygon& polygon, const Vec2& centre,
                     const std::vector<LiftingPoint>& points);

// The thesis's own, weaker test (5.5): whether neither region of free rotation centres has an area.
// It also passes objects that can slide between parallel sides or turn about a single point.
// O(m log m + n log n).
bool no_region_has_area(const Polygon& polygon, const Vec2& centre,
                        const std::vector<LiftingPoint>& points);

// Analyses the grasp of robots at `points`. Whether a region is empty and whether a translation is
// free is decided exactly, from the edges' directions and the rounded points. Of the contacts on
// one edge only the first and the last count. O(n log n + m log m) for m contacts on e edges, and
// O(e^2) for the margin and, at worst, the regions.
Closure analyse_closure(const Polygon& polygon, const Vec2& centre,
                        const std::vector<LiftingPoint>& points);

}  // namespace evenlift
