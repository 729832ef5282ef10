// The object and its robots' contacts in the form that the tests of form closure and the margin
// need.
#pragma once

#include <cstdint>
#include <vector>

#include "evenlift/closure.h"
#include "grasp/wrench_margin.h"

namespace evenlift {

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
