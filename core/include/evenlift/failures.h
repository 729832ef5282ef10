// What happens if robots fail: let go of the object, all at once and without a warning. All of it
// is static: for a moment a sudden loss can double the change of a load.
//
// The object is *carried* by robots if C lies in their convex hull within tolerance (tau L): they
// can balance its weight. It is *steady* if C lies inside that hull by more than the tolerance:
// then it also withstands a small push anywhere. Both are decided within the tolerance, so that
// rounding tips neither: the two robots of a team and C lie on one line only up to rounding. Where
// objects are so far from the origin that coordinates are not known to tau L, the tolerance is that
// rounding.
#pragma once

#include <optional>
#include <vector>

#include "evenlift/loads.h"
#include "evenlift/polygon.h"
#include "evenlift/vec.h"

namespace evenlift {

// How many robots may fail at once, whichever they are, so that the rest still carries the object:
// the depth of C less one. The depth is the least number of robots on one side of a line through C,
// those within tolerance of the line included (half-space depth; J. W. Tukey, Mathematics and the
// picturing of data, 1975). -1 if not even all robots together carry it. Teams of two: t teams
// carry any t - 1 failures, since each side of a line through C has one robot of each team.
// `robots` are the positions of the robots, in any order, some perhaps at the same place;
// `diameter` > 0 is L, the object's diameter. O(m log m).
int failures_carried(const Points& robots, const Vec2& centre, double diameter);

// The same for robots that keep the object steady: robots within tolerance of the line do not
// count. Never more than failures_carried. -1 if the object is not steady even with all robots, as
// with a single team of two. With `inside` C counts as inside the hull only if it is at least so
// far from its edge, within tolerance: robots nearer to the line than that do not count. O(m log
// m).
int failures_steady(const Points& robots, const Vec2& centre, double diameter, double inside = 0);

// What holds of the robots that are left if they still carry the object.
struct RestOfRobots {
  bool steady = false;
  bool clear = false;           // steady, and C is at least `inside` inside their hull
  double tipping_distance = 0;  // see doubt.h
  double coverage = 0;          // see stability.h
  bool form_closure = false;    // see closure.h, like the margin
  std::optional<double> margin;
  std::optional<double> greatest_by_plan;  // the greatest load if the partners of the failed robot
                                           // let go, too, and each other team bears its part; none
                                           // without another team
  double greatest_by_springs = 0, least_greatest = 0;  // see load_models.h: springs and best
};

// What happens if one robot fails, for each of them, in their order; nothing where the rest does
// not carry the object. The teams must be those of a placement on the polygon. `inside` is as for
// failures_steady. For m robots O(n log n + m n + m^2 log m), O(h n + m h n') for the coverage
// (stability.h), O(m^3) for the margin, and for the least greatest load O(m^4) up to 65 robots, or
// O(m^2) for each of its some hundred steps.
std::vector<std::optional<RestOfRobots>> single_failures(const Polygon& polygon, const Vec2& centre,
                                                         double weight,
                                                         const std::vector<Team>& teams,
                                                         double inside = 0);

// The same of one robot, as find_robot() (loads.h) counts them. The m-th part of the cost, besides
// O(n log n + h n).
std::optional<RestOfRobots> single_failure(const Polygon& polygon, const Vec2& centre,
                                           double weight, const std::vector<Team>& teams,
                                           std::size_t robot, double inside = 0);

}  // namespace evenlift
