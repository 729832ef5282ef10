// The effects of failing robots. A robot is assumed to fail suddenly and then to carry nothing. The
// analysis is static, but a sudden loss can for a moment double the change of a load.
//
// The robots *carry* the object if C lies in their convex hull within tolerance (tau L): they can
// balance its weight. The object is *steady* if C lies inside that hull by more than the tolerance:
// then it also withstands a light downward press anywhere, as long as the robots keep their height
// and none is overloaded. Without the tolerance, rounding would decide both: the two robots of a
// team and C lie on one line only up to rounding. Far from the origin, where coordinates are
// rounded by more than tau L, the tolerance is that rounding.
#pragma once

#include <optional>
#include <vector>

#include "evenlift/loads.h"
#include "evenlift/polygon_with_holes.h"
#include "evenlift/uncertainty.h"
#include "evenlift/vec.h"

namespace evenlift {

// The number of robots that may fail at once, whichever they are, with the rest still carrying the
// object: the depth of C minus one. The depth is the least number of robots on one side of a line
// through C, including robots within tolerance of the line (half-space depth; J. W. Tukey,
// Mathematics and the picturing of data, 1975). -1 if not even all robots together carry the
// object. With teams of two, t teams carry it after any t - 1 failures, since each side of a line
// through C has at least one robot of each team. `robots` are the positions of the robots, in any
// order, some perhaps at the same place; `diameter` > 0 is L, the object's diameter. O(m log m).
int failures_carried(const Points& robots, const Vec2& centre, double diameter);

// The number of robots that may fail at once, whichever they are, with the object still steady:
// again the depth minus one, but robots within tolerance of the line do not count. Never more than
// failures_carried(). -1 if the object is not steady even with all robots, as with a single team of
// two. With `inside`, C counts as inside the hull only if it is at least that far from its
// boundary, within tolerance: robots nearer to the line do not count. O(m log m).
int failures_steady(const Points& robots, const Vec2& centre, double diameter, double inside = 0);

// The remaining robots, if they still carry the object.
struct RestOfRobots {
  bool steady = false;
  bool clear = false;           // steady, and C is at least `inside` inside their hull
  double tipping_distance = 0;  // see uncertainty.h
  double coverage = 0;          // see stability.h
  bool form_closure = false;    // see closure.h, also for the margin
  std::optional<double> margin;
  std::optional<double> greatest_by_plan;  // the greatest load if the partners of the failed robot
                                           // also stop carrying, and every other team carries an
                                           // equal part; none without another team
  double greatest_by_springs = 0, least_greatest = 0;  // see load_models.h: springs and best
  std::vector<double> springs;  // the load of each robot by springs; 0 for the failed one
  std::vector<double> ends;     // the greatest load of each by springs within the disturbance
                                // (uncertainty.h); without a disturbance the same as springs
  double greatest_end = 0;      // of these
  bool stays =
      true;  // the reach of the disturbance is at most the tipping distance, within tolerance
};

// The effect of each robot's failure, in the order of the robots; nothing where the rest does not
// carry the object. The teams must be those of a placement on the polygon. `inside` is as for
// failures_steady(), and the disturbance as for load_changes() (uncertainty.h). For m robots the
// function costs O(n log n + m n + m^2 log m), plus O(h n + m h n') for the coverage (stability.h),
// O(m^3) for the margin and, for the least greatest load, O(m^4) up to 65 robots, and beyond that
// O(m^2) for each of about a hundred steps.
std::vector<std::optional<RestOfRobots>> single_failures(const PolygonWithHoles& object,
                                                         const Vec2& centre, double weight,
                                                         const std::vector<Team>& teams,
                                                         double inside = 0,
                                                         const Disturbance& disturbance = {});

// The effect of one robot's failure, numbered as in find_robot() (loads.h). A fraction 1/m of the
// cost of single_failures(), plus O(n log n + h n).
std::optional<RestOfRobots> single_failure(const PolygonWithHoles& object, const Vec2& centre,
                                           double weight, const std::vector<Team>& teams,
                                           std::size_t robot, double inside = 0,
                                           const Disturbance& disturbance = {});

}  // namespace evenlift
