// The effects of failing robots. A robot fails and then carries nothing. The analysis is static: at
// a sudden failure, loads swing beyond the new ones, those of the nearest robots by about twice the
// change, others by more.
//
// The robots *carry* the object if C lies in their convex hull within tau L: they can balance its
// weight. The object is *steady* if C lies inside the hull by more than tau L. A steady object also
// withstands a light downward press anywhere, as long as the robots keep their height and none is
// overloaded. Without the tolerance, rounding would decide both, since C lies on the line of a
// team's two robots only up to rounding. Far from the origin, coordinates are rounded by more than
// tau L; there, the tolerance is that rounding.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "evenlift/loads.h"
#include "evenlift/polygon_with_holes.h"
#include "evenlift/uncertainty.h"
#include "evenlift/vec.h"

namespace evenlift {

// The number of robots that may fail at once, whichever they are, while the others still carry the
// object; -1 if all robots together do not carry it. It is one less than the depth of C. The depth
// is the least number of robots on one side of a line through C, including those within tolerance
// of the line (half-space depth; J. W. Tukey, Mathematics and the picturing of data, 1975). Of t
// teams of two, any t - 1 robots may fail, since each side of any line through C, the line
// included, has a robot of each team. `robots` are positions, in any order and perhaps equal;
// `diameter` > 0 is L. O(m log m).
int failures_carried(const Points& robots, const Vec2& centre, double diameter);

// The number of robots that may fail at once, whichever they are, while the object stays steady and
// C lies at least `inside` within the hull of the rest. It is found like failures_carried(), but a
// robot counts only if its distance from the line exceeds the tolerance and is, within tolerance,
// at least `inside`. The number is at most failures_carried(), and -1 if all robots together do not
// suffice, as with one team of two. O(m log m).
int failures_steady(const Points& robots, const Vec2& centre, double diameter, double inside = 0);

inline constexpr std::size_t most_robots_listed = 64;

// The state of the object on the remaining robots.
struct RestOfRobots {
  bool steady = false;
  bool clear = false;            // steady, and C is at least `inside` within their hull
  double tipping_distance = 0;   // see uncertainty.h
  double coverage = 0;           // see stability.h
  bool form_closure = false;     // see closure.h
  std::optional<double> margin;  // see closure.h
  // The greatest load if the failed robot's team stops carrying and the other teams carry equal
  // parts; empty if there are no other teams.
  std::optional<double> greatest_by_plan;
  // The greatest loads by the models `springs` and `best` (load_models.h).
  double greatest_by_springs = 0, least_greatest = 0;
  std::vector<double> springs;  // the loads by springs; 0 for the failed robot. Empty for more than
                                // most_robots_listed, since all failures would have m^2 loads
  // Whether the reach of the disturbance is at most the tipping distance, within tolerance.
  bool stays = true;
  // The greatest loads by springs within the disturbance (uncertainty.h), and the greatest of them;
  // empty if the object does not stay. Without a disturbance they are those of `springs`.
  std::vector<double> ends;
  std::optional<double> greatest_end;
};

// The effect of each robot's failure, in the order of the robots; an entry is empty if the others
// do not carry the object. The teams must be those of a placement on the polygon. `inside` is as
// for failures_steady(), and the disturbance as for load_changes() (uncertainty.h). O(n log n + m n
// + m^2 log m) for m robots, plus O(h n + m h n') for the coverage (stability.h) and O(m^3) for the
// margin. The least greatest load takes O(m^4) up to 65 robots; beyond that, it takes O(m^2) for
// each of about a hundred steps.
std::vector<std::optional<RestOfRobots>> single_failures(const PolygonWithHoles& object,
                                                         const Vec2& centre, double weight,
                                                         const std::vector<Team>& teams,
                                                         double inside = 0,
                                                         const Disturbance& disturbance = {});

// The effect of one robot's failure. Robots are numbered as in find_robot() (loads.h). Costs 1/m of
// single_failures(), plus O(n log n + h n).
std::optional<RestOfRobots> single_failure(const PolygonWithHoles& object, const Vec2& centre,
                                           double weight, const std::vector<Team>& teams,
                                           std::size_t robot, double inside = 0,
                                           const Disturbance& disturbance = {});

}  // namespace evenlift
