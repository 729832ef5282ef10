// Contacts, margins and levels of holds, and holds with robots that are off.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "evenlift/closure.h"
#include "evenlift/vec.h"
#include "polygon/corners.h"

namespace evenlift {

// --- Finds the contacts of robots with an object, and the distances of these contacts from corners.

class ContactFinder {
 public:
  // The polygon must outlive the finder. O(n log n).
  explicit ContactFinder(const Polygon& polygon);

  // Returns the same as contacts() (closure.h). O(m log n) for m points, if few vertices lie within
  // tau L of one another.
  std::vector<Contact> find(const std::vector<LiftingPoint>& points) const;

 private:
  // A cell of a grid of squares with side 4 tau L. All points within tau L of a given point lie in
  // at most four of these squares.
  using Cell = std::array<double, 2>;
  Cell cell_of(const Vec2& p) const;
  // Takes each vertex in the cells around a point, among them all within tau L of it.
  template <class Take>
  void each_vertex_near(const Vec2& p, Take take) const;

  const Polygon& polygon_;
  double near_;
  std::vector<Cell> cells_;             // by vertex
  std::vector<std::uint32_t> by_cell_;  // the vertices in the order of their cells
  Corners corners_;
};

// --- The margin of a grasp, by C. Ferrari and J. Canny (Planning optimal grasps, 1992). Their measure
// is often called epsilon or Q1. This is the L1 form, with one limit for the sum of all contact
// forces.

using Wrench = Vec3;  // force x, force y, torque

// The minimum over all unit vectors u of the maximum of u . w over the wrenches w. This is the
// radius of the largest ball about the origin in their convex hull; if the origin is outside, it is
// minus the hull's distance from the origin. There must be at least one wrench. O(m^2) for up to 32
// wrenches. For more, the hull is built only from the wrenches that bound the ball, usually a few
// dozen; finding each of these takes O(m).
double wrench_margin(const std::vector<Wrench>& wrenches);

// The margin, and a unit vector u for which the maximum of u . w is nearly the margin. For any
// other set of wrenches w, the maximum of u . w is an upper bound of that set's margin. The bound
// is close if the set is similar to the given one.
struct WeakestDirection {
  double margin = 0;
  Wrench direction{1, 0, 0};
};
WeakestDirection weakest_direction(const std::vector<Wrench>& wrenches);

// --- Computes the margins of many placements on one object.

class Margins {
 public:
  // The polygon must outlive this object. Contacts nearer than `hold.clear` to a corner do not
  // count. O(n log n).
  Margins(const Polygon& polygon, const Vec2& centre, const HoldRequirements& hold);

  // Returns the margin that analyse_hold() would compute from the contacts of robots at these
  // points, without those that do not count. Returns nothing if no contact counts. O(m log n) for m
  // points, plus the cost of wrench_margin().
  std::optional<double> of(const std::vector<LiftingPoint>& points) const;

  // The wrenches that the margin needs. Of several contacts on edges of the same direction, only
  // the first and the last are included (grasp.h). O(m log n).
  std::vector<Wrench> wrenches_of(const std::vector<LiftingPoint>& points) const;

  // Whether robots at these points, which have this margin, still hold the object if they are off
  // by `hold.tolerance`, within tau L. O(m log n), plus the cost of holds_within() (closure.h) if
  // the margin is small or a bend is near.
  bool are_firm(const std::vector<LiftingPoint>& points, const WeakestDirection& margin) const;

  // The level of these robots' margin (hold_levels.h); 0 if they are not firm. `tested` says whether
  // that was in question.
  struct Level {
    std::uint32_t level = 0;
    bool tested = false;
  };
  Level level_of(const std::vector<LiftingPoint>& points) const;

 private:
  const Polygon& polygon_;
  Vec2 centre_;
  double radius_;
  HoldRequirements hold_;
  ContactFinder finder_;
};

// --- With the goal hold, choices of teams and sets of balanced robots are compared by the level of
// their margin (algorithm.md, Choosing teams that hold).

inline constexpr std::uint32_t best_level = 3;

// The least margins of levels 1, 2 and 3, ascending.
using LevelBounds = std::array<double, best_level>;
inline LevelBounds level_bounds(double min_margin) {
  constexpr double least_margin = 0.001, halfway = 0.4;
  LevelBounds bounds{least_margin, halfway * min_margin, min_margin};
  std::sort(bounds.begin(), bounds.end());
  return bounds;
}

// The level of a margin, 0 .. best_level; 0 if there is no margin.
inline std::uint32_t level_of(const std::optional<double>& margin, const LevelBounds& bounds) {
  if (!margin) return 0;
  return static_cast<std::uint32_t>(std::upper_bound(bounds.begin(), bounds.end(), *margin) -
                                    bounds.begin());
}

// --- Whether a hold survives robots that are off along the outline (algorithm.md, Clearance and
// tolerance). holds_within() in evenlift/closure.h explains it.

class HoldErrors {
 public:
  // The polygon must outlive this object; `radius` is R. O(m log m) for m contacts.
  HoldErrors(const Polygon& polygon, const Vec2& centre, double radius,
             const std::vector<Contact>& contacts);

  // Whether form closure surely persists if all robots are off by up to `error`. `known` is the
  // margin of some of the contacts farther than that from corners, and its direction. With it the
  // answer is mostly found at once: the margin is large enough, or the moments alone end the hold in
  // that direction.
  bool hold_within(double error, const WeakestDirection& known = {}) const;

  // The supremum of the errors within which form closure persists; infinite if there is none.
  double tolerance() const;

 private:
  struct Push {
    Contact contact;
    Wrench wrench;
  };
  struct Reached {
    const Push* push;
    double beside;  // the greatest distance of a wrench within reach from those on its own side
  };

  bool hold_without_others() const;
  Wrench wrench_at(const Vec2& position, std::uint32_t edge) const;
  double beside(const Push& push, double error) const;
  std::vector<Reached> reached(double error) const;
  bool is_lost_along(const Wrench& direction, double error) const;
  double least_margin(const std::vector<Reached>& all, double most_beside, double error) const;

  const Polygon& polygon_;
  Vec2 centre_;
  double radius_;
  std::vector<Push> pushes_;
};

// --- The object and its robots' contacts in the form that the tests of form closure and the margin
// need.

// A touch is a contact together with the edge that it is on. The edge is directed with the interior
// on its left, so the inward normal is the edge's direction turned by +90 degrees.
struct Grasp {
  struct Touch {
    Vec2 from, to;  // the ends of the edge, in this direction
    Vec2 position;
    std::uint32_t edge;
    Vec2 direction() const { return to - from; }
    Vec2 inward() const { return left_normal(to - from) / length(to - from); }
  };
  Vec2 centre;
  double diagonal = 0;  // the diagonal of the bounding box
  double diameter = 0;  // L
  double near = 0;      // tau L
  double radius = 0;    // R: the largest distance of a vertex from C
  std::vector<Touch> touches;
};

// Returns the grasp with these contacts. Of several contacts on edges of the same direction, the
// grasp keeps only the first and the last in this direction. The wrenches and normal lines of the
// others lie between the wrenches and normal lines of these two and add nothing. `radius` is R. O(m
// log e) for m contacts on e edges.
Grasp make_grasp(const Polygon& polygon, const Vec2& centre, double radius,
                 const std::vector<Contact>& contacts);

// The touches of all these contacts, in their order. O(m).
std::vector<Grasp::Touch> touches_of(const Polygon& polygon, const std::vector<Contact>& contacts);

// The touch's position along its edge, measured from the foot of the perpendicular from C to the
// edge's line, times the edge's length. O(1).
double along(const Grasp& grasp, const Grasp::Touch& touch);

// The wrenches of the touches, with torques in units of R. They are sorted by edge and torque, so
// that the margin does not depend on the order of the robots. O(m log m).
std::vector<Wrench> wrenches(const Grasp& grasp);

}  // namespace evenlift
