// Whether the robots also immobilize the object (algorithm.md, Immobilization; thesis 5.5).
//
// The terms are those of the literature on grasping. Reuleaux's method decides first-order form
// closure: the instantaneous centres of rotation that each contact leaves free form a half-plane.
// The object is in form closure if the clockwise half-planes have no point in common, the
// counter-clockwise half-planes have none either, and no translation is free (F. Reuleaux, The
// Kinematics of Machinery, 1876). The margin is the measure of grasp quality by Ferrari and Canny
// (C. Ferrari and J. Canny, Planning optimal grasps, 1992). Second-order immobility follows E.
// Rimon and J. W. Burdick (Mobility of bodies in contact, 1998).
//
// A hold that needs a robot extremely close to a corner cannot be built: at the corner itself the
// contact is lost. So contacts have a distance from the nearest corner, holds have a clearance and
// a tolerance, and searches rely only on contacts far enough from corners (algorithm.md, Clearance
// and tolerance).
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "evenlift/chords.h"
#include "evenlift/document.h"

namespace evenlift {

// A frictionless contact of a robot with an edge.
struct Contact {
  Vec2 position = Vec2::Zero();
  std::uint32_t edge = 0;
  std::uint32_t point = 0;  // index of the robot's lifting point
  // The distance from the nearest corner (Polygon::is_corner) at which the contact's edge ends;
  // edges joined by straight vertices count as one. Infinite without such a corner, and in a reflex
  // vertex, whose notch keeps the robot in place.
  double to_corner = std::numeric_limits<double>::infinity();
  // The distance from the nearest convex vertex at which the contact's straight side ends, however
  // little the outline turns there: beyond it, a robot touches another side. Infinite without such
  // a vertex, and in a reflex vertex.
  double to_end = std::numeric_limits<double>::infinity();
};

// The direction, as a unit vector, in which a contact with an edge pushes. The second overload
// takes an edge between two vertices of a polygon of the given orientation. O(1).
Vec2 inward_normal(const Polygon& polygon, std::uint32_t edge);
Vec2 inward_normal(const Vec2& from, const Vec2& to, bool counter_clockwise);

// The contacts of lifting points; a robot beneath the object has none. A robot has one contact
// inside an edge, two at a reflex vertex, one at a straight vertex. At a convex vertex its push has
// no definite direction, so it is not counted; this can only enlarge the free regions, which errs
// on the safe side. A robot is at a vertex if it is within tau L of it. O((m + n) log n) for m
// points, if few vertices lie within tau L of one another.
std::vector<Contact> contacts(const Polygon& polygon, const std::vector<LiftingPoint>& points);

// The contacts at least `clear` from every corner, within tau L. O(contacts).
std::vector<Contact> clear_contacts(const Polygon& polygon, const std::vector<Contact>& contacts,
                                    double clear);

// The free instantaneous centres of rotation in one direction: a convex region, which may be
// unbounded or far away.
struct FreeRegion {
  bool exists = false;    // some centre is free, near or far
  bool has_area = false;  // false: the region is a point or a line, up to tolerance
  Points clipped;         // the region within the square about C with half side 100 diagonal(),
                          // counter-clockwise; at most two points if it has no area there
};

// The regions of rotation centres that contacts leave free. O(n + m log m) for m contacts on e
// edges, plus at worst O(e^2) to clip a region or to find one that has no area.
struct FreeRegions {
  FreeRegion clockwise, counterclockwise;
};
FreeRegions free_regions(const Polygon& polygon, const Vec2& centre,
                         const std::vector<Contact>& contacts);

// How precisely robots must stand to hold the object, in units of length. Let m(k) be the margin of
// the contacts at least k from corners, and s(k) the margin of the contacts at least k from the
// ends of their straight sides.
struct Clearance {
  // The supremum of the k with m(k) > 0: infinite if the hold needs no contact beside a corner, and
  // 0 without form closure.
  double distance = 0;
  // The lifting point whose contact is at that distance. Without this contact and all contacts
  // nearer to corners, the object is not held. None if the distance is 0 or infinite.
  std::optional<std::uint32_t> point;
  // The supremum of min(k, R s(k)) over all k. Form closure persists if every robot is off by less
  // than that along its side, all at once in any combination, provided that robots in reflex
  // vertices stay there. No contact that counts leaves its side. A wrench changes by at most the
  // distance that its robot is off, divided by R, and the margin shrinks by no more than the
  // largest of these changes. 0 without form closure.
  double tolerance = 0;
};

// O(log m) analyses like those of analyse_hold(), for m contacts.
Clearance analyse_clearance(const Polygon& polygon, const Vec2& centre,
                            const std::vector<Contact>& contacts);

struct Closure {
  bool form_closure = false;  // no motion is free to first order
  // The quality measure of Ferrari and Canny: the radius of the largest ball about the origin in
  // the convex hull of the contacts' wrenches (n, (p - C) x n / R), n being the inward unit normal;
  // if the origin is outside, minus its distance from the hull. Above 0 in form closure; none
  // without contacts. The convex hull expresses one limit on the sum of all contact forces (the L1
  // form). The margin depends on C and R, so it compares placements of one object, not objects.
  std::optional<double> margin;
  bool second_order = false;  // immobile to second order, although motions are free to first order
  bool translation_free = true;
  std::optional<Vec2> translation;  // a free direction of unit length, if any
  FreeRegion clockwise, counterclockwise;
  Clearance clearance;
};

// Form closure and margin as in Closure; computing them alone is cheaper if the contacts are known.
// O(n + m log m) for m contacts, and O(e^2) on e edges. The second overload takes the lifting
// points of robots.
struct Hold {
  bool form_closure = false;
  std::optional<double> margin;
};
Hold analyse_hold(const Polygon& polygon, const Vec2& centre, const std::vector<Contact>& contacts);
Hold analyse_hold(const Polygon& polygon, const Vec2& centre,
                  const std::vector<LiftingPoint>& points);

// The requirements on a hold: the minimum margin, and the distance from corners below which
// contacts do not count.
struct HoldRequirements {
  double min_margin = 0.05;
  double clear = 0;
};

// The requirements in the settings, where the default `clear` is a fraction of R. O(n).
HoldRequirements hold_requirements(const Polygon& polygon, const Vec2& centre,
                                   const Settings& settings);

// Whether a hold with this clearance relies only on contacts at least `clear` from corners, within
// tau L. O(1).
bool is_clear(const Polygon& polygon, const Clearance& clearance, double clear);

// Returns the same as analyse_closure(...).form_closure, but is cheaper. Adding points never ends
// form closure. O(m log m + n log n).
bool in_form_closure(const Polygon& polygon, const Vec2& centre,
                     const std::vector<Contact>& contacts);
bool in_form_closure(const Polygon& polygon, const Vec2& centre,
                     const std::vector<LiftingPoint>& points);

// The thesis's own, weaker test (5.5): whether neither region of free rotation centres has an area.
// Objects that can slide along parallel sides or turn about a single point also pass it.
// O(m log m + n log n).
bool no_region_has_area(const Polygon& polygon, const Vec2& centre,
                        const std::vector<LiftingPoint>& points);

// Analyses the grasp of robots at `points`. The regions are widened by tau L, and a translation is
// free within tau; apart from these tolerances, the tests are exact for the edges' directions and
// the rounded points. Among contacts on edges of the same direction, only the first and the last
// count. O(n log n + m log m) for m contacts on edges of e directions, at worst O(e^2) for the
// regions, and for margin, clearance and tolerance O(log m) calls of wrench_margin().
Closure analyse_closure(const Polygon& polygon, const Vec2& centre,
                        const std::vector<LiftingPoint>& points);

}  // namespace evenlift
