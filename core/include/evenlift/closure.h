// Whether the robots also immobilize the object (algorithm.md, Immobilization; thesis 5.5).
//
// Reuleaux's method decides first-order form closure (F. Reuleaux, The Kinematics of Machinery,
// 1876). Each contact leaves a half-plane of rotation centres free for clockwise turns, and another
// for counter-clockwise turns. In form closure, the half-planes for clockwise turns have no point
// in common, nor do those for counter-clockwise turns, and no translation is free. The margin is a
// grasp quality (C. Ferrari and J. Canny, Planning optimal grasps, 1992). Second-order immobility
// follows E. Rimon and J. W. Burdick (Mobility of bodies in contact, 1998).
//
// A hold that needs a robot extremely close to a corner cannot be built, since at the corner the
// contact is lost. Searches therefore rely only on contacts far enough from corners (algorithm.md,
// Clearance and tolerance).
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
  Vec2 position;
  std::uint32_t edge = 0;
  std::uint32_t point = 0;  // the index of the robot's lifting point
  // The distance along the outline to the nearest corner (Polygon::is_corner), past vertices that
  // turn little; infinite if there is none, or none before the next notch (Polygon::is_notch).
  double to_corner = std::numeric_limits<double>::infinity();
  // The robot stands in a notch, and is pressed into it: it stands exactly.
  bool in_notch = false;
};

// The unit vector in whose direction a contact pushes the object: into the object, perpendicular to
// the edge. The second function takes the ends of the edge and the polygon's orientation. O(1).
Vec2 inward_normal(const Polygon& polygon, std::uint32_t edge);
Vec2 inward_normal(const Vec2& from, const Vec2& to, bool counter_clockwise);

// The contacts of lifting points: one inside an edge, two at a reflex vertex, one at a straight
// vertex, none beneath the object. At a convex vertex the push has no definite direction and is not
// counted. This can only enlarge the free regions, so a hold is never overstated. A robot within
// tau L of a vertex counts as standing at it. O((m + n) log n) for m points, if few vertices lie
// within tau L of one another.
std::vector<Contact> contacts(const Polygon& polygon, const std::vector<LiftingPoint>& points);

// The contacts at least `clear` from every corner, within tau L. O(contacts).
std::vector<Contact> clear_contacts(const Polygon& polygon, const std::vector<Contact>& contacts,
                                    double clear);

// The free centres of rotation in one direction: a convex region, perhaps unbounded or far away.
struct FreeRegion {
  bool exists = false;    // whether any centre is free
  bool has_area = false;  // a region without area is a point or part of a line, within tolerance
  Points clipped;         // the part within the square about C whose half side is 100 diagonal()
                          // (polygon.h), counter-clockwise; at most two points if it has no area
};

// The free centres of rotation in both directions. O(n + m log m) for m contacts on e edges, plus
// at worst O(e^2) to clip a region or to find one without area.
struct FreeRegions {
  FreeRegion clockwise, counterclockwise;
};
FreeRegions free_regions(const Polygon& polygon, const Vec2& centre,
                         const std::vector<Contact>& contacts);

// How precisely robots must stand, in units of length (algorithm.md, Clearance and tolerance).
struct Clearance {
  // Let m(k) be the margin of the contacts at least k from corners. The clearance is the supremum
  // of the k with m(k) > 0. It is infinite if form closure needs no contact on a side that ends at
  // a corner, and 0 without form closure.
  double distance = 0;
  // The lifting point whose contact is at that distance from a corner. The contacts farther from
  // corners do not hold the object on their own. Empty if the distance is 0 or infinite.
  std::optional<std::uint32_t> point;
  // Form closure persists if all robots are off along the outline by less than this, in any
  // combination, provided that robots in notches stay there; see holds_within(). 0 without form
  // closure; infinite if robots in notches suffice. Unless vertices that are not corners are within
  // reach, the hold is lost just beyond it when all robots are off in the same sense.
  double tolerance = 0;
};

// The clearance of a hold by m contacts. Costs O(log m) analyses like analyse_hold(), and some 50
// calls of holds_within().
Clearance analyse_clearance(const Polygon& polygon, const Vec2& centre,
                            const std::vector<Contact>& contacts);

// Whether form closure surely persists if all robots are off along the outline by up to `error`. A
// robot on one straight side changes only the moment of its wrench (see Closure), by up to error /
// R, and in the worst case all do in the same sense. Beyond a vertex, the normal turns too: a
// contact whose wrench may then be x away from those on its own side counts only if the margin of
// the contacts with at most this x exceeds x. Of more than 128 contacts, 128 count. Costs a few
// margins, and O(contacts + vertices within `error` of each).
bool holds_within(const Polygon& polygon, const Vec2& centre, const std::vector<Contact>& contacts,
                  double error);

struct Closure {
  bool form_closure = false;  // whether no motion is free to first order
  // The radius of the largest ball about the origin in the convex hull of the contacts' wrenches
  // (n, (p - C) x n / R), where n is the inward unit normal at the contact p. If the origin is
  // outside, the margin is minus the origin's distance from the hull. It is above 0 in form
  // closure, and empty without contacts. The hull corresponds to one limit on the sum of all
  // contact forces (the L1 form). The margin depends on C and R, so compare it only between
  // placements of one object.
  std::optional<double> margin;
  bool second_order = false;  // whether the object is immobile to second order only
  bool translation_free = true;
  std::optional<Vec2> translation;  // a free direction, of unit length
  FreeRegion clockwise, counterclockwise;
  Clearance clearance;
};

// Form closure and margin as in Closure, at less cost, above all if the contacts are known. O(n + m
// log m), plus O(e^2) at worst for the margin, for m contacts on e edges.
struct Hold {
  bool form_closure = false;
  std::optional<double> margin;
};
Hold analyse_hold(const Polygon& polygon, const Vec2& centre, const std::vector<Contact>& contacts);
Hold analyse_hold(const Polygon& polygon, const Vec2& centre,
                  const std::vector<LiftingPoint>& points);

// What a hold must have to count as one: the minimum margin, the least distance from corners at
// which contacts count, and the least tolerance (algorithm.md, A hold is firm).
struct HoldRequirements {
  double min_margin = 0.05;
  double clear = 0;
  double tolerance = 0;
  // After a failure, and also without one, C should be at least this far inside the lifting base.
  double inside = 0;
};

// The requirements in the settings. If the setting `clear` is empty, the distance is usual_clear
// (document.h) times R. With the method `given` it is less by usual_snap times L, since places that
// are typed have few digits. The tolerance is half of that, and `inside` is that, or the setting
// `accuracy` if it is more. O(n).
HoldRequirements hold_requirements(const Polygon& polygon, const Vec2& centre,
                                   const Settings& settings);

// Whether the clearance and the tolerance are at least those required, within tau L. If so, and
// there is form closure, the contacts at least `clear` from corners suffice for it. O(1).
bool is_firm(const Polygon& polygon, const Clearance& clearance, const HoldRequirements& hold);

// The form_closure of analyse_closure(), at less cost. Adding points never ends form closure. O(m
// log m + n log n).
bool in_form_closure(const Polygon& polygon, const Vec2& centre,
                     const std::vector<Contact>& contacts);
bool in_form_closure(const Polygon& polygon, const Vec2& centre,
                     const std::vector<LiftingPoint>& points);

// The thesis's own, weaker test (5.5): neither free region has an area. Objects that can slide
// along parallel sides or turn about a single point also pass it. O(m log m + n log n).
bool no_region_has_area(const Polygon& polygon, const Vec2& centre,
                        const std::vector<LiftingPoint>& points);

// Analyses how robots at these points hold the object. The regions are widened by tau L, and the
// test for free translations has a tolerance of tau; otherwise the tests are exact for the edges'
// directions and the rounded points. Of several contacts on edges of the same direction, only the
// two outermost count. O(n log n + m log m) for m contacts on edges of e directions, plus at worst
// O(e^2) for the regions, plus O(log m) analyses like analyse_hold().
Closure analyse_closure(const Polygon& polygon, const Vec2& centre,
                        const std::vector<LiftingPoint>& points);

}  // namespace evenlift
