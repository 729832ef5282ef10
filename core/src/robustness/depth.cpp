// The depth of C among the robots, by a line that turns once around C.
#include <algorithm>
#include <cmath>

#include "evenlift/failures.h"
#include "evenlift/tolerance.h"
#include "exact/pseudo_angle.h"
#include "exact/sorted_indices.h"
#include "robustness/known_size.h"

namespace evenlift {
namespace {

// Whether a robot within tolerance of the line counts.
enum class OnTheLine { counts, does_not };

// A robot at d from C is on the side of the unit vector u if u . d >= -near (counts) or u . d >
// near (does not). These u form an arc of pseudo-angles: closed and slightly more than a half-turn,
// or open and slightly less.
struct Arc {
  double begin, end;
};

Arc arc_of(const Vec2& d, double near, OnTheLine on_the_line) {
  const double distance = length(d);
  // At the arc's ends, u . d is `along`, and u has the components `along` and `across` over |d|.
  const double along = on_the_line == OnTheLine::counts ? -near : near;
  const double across = std::sqrt((distance - near) * (distance + near));
  const Vec2 side = across * left_normal(d);
  return {pseudo_angle(along * d - side), pseudo_angle(along * d + side)};
}

// The least number of arcs that overlap in one direction.
int least_overlap(const std::vector<Arc>& arcs, OnTheLine on_the_line) {
  // Event 2 i begins arc i, and event 2 i + 1 ends it.
  const auto angle = [&](std::uint32_t event) {
    const Arc& arc = arcs[event / 2];
    return event % 2 == 0 ? arc.begin : arc.end;
  };
  // Where closed arcs meet, they overlap; open arcs leave a gap.
  const std::uint32_t first_of_equal = on_the_line == OnTheLine::counts ? 0 : 1;
  const SortedIndices events =
      sorted_indices(2 * arcs.size(), [&](std::uint32_t i, std::uint32_t j) {
        if (angle(i) != angle(j)) return angle(i) < angle(j);
        return i % 2 == first_of_equal && j % 2 != first_of_equal;
      });
  int overlap = 0;
  for (const Arc& arc : arcs) overlap += arc.begin > arc.end ? 1 : 0;
  int least = overlap;
  for (const std::uint32_t event : events) {
    overlap += event % 2 == 0 ? 1 : -1;
    least = std::min(least, overlap);
  }
  return least;
}

// The least number of robots on one side of a line through C.
//
// C and each robot are at most L apart, and `near` is at least tau L. So arcs differ from a
// half-turn by at least tau at either end, and the rounding of directions, about 1e-16, matters
// only at the limit of the tolerance.
int depth(const Points& robots, const Vec2& centre, double near, OnTheLine on_the_line) {
  std::vector<Arc> arcs;
  arcs.reserve(robots.size());
  int at_centre = 0;
  for (const Vec2& robot : robots) {
    const Vec2 d = robot - centre;
    if (length(d) <= near) {
      ++at_centre;
    } else {
      arcs.push_back(arc_of(d, near, on_the_line));
    }
  }
  const int always = on_the_line == OnTheLine::counts ? at_centre : 0;
  return always + least_overlap(arcs, on_the_line);
}

double tolerance(const Points& robots, const Vec2& centre, double diameter) {
  return near_distance(known_size(robots, centre, diameter));
}

}  // namespace

int failures_carried(const Points& robots, const Vec2& centre, double diameter) {
  return depth(robots, centre, tolerance(robots, centre, diameter), OnTheLine::counts) - 1;
}

int failures_steady(const Points& robots, const Vec2& centre, double diameter, double inside) {
  const double near = tolerance(robots, centre, diameter);
  return depth(robots, centre, std::max(near, inside - near), OnTheLine::does_not) - 1;
}

}  // namespace evenlift
