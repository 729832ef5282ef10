#include <algorithm>
#include <array>
#include <cstddef>

#include "balanced/completions.h"
#include "evenlift/balanced.h"

namespace evenlift {
namespace {

double square(const LiftingPoint& a, const LiftingPoint& b) {
  return squared_length(a.position - b.position);
}

}  // namespace

std::optional<std::vector<LiftingPoint>> move_robot(const BalancedProblem& problem,
                                                    std::vector<LiftingPoint> robots,
                                                    std::size_t moved, const LiftingPoint& to) {
  const std::size_t m = robots.size();
  if (m < 3 || moved >= m) return std::nullopt;
  const Stands* room = problem.rules().room();
  if (room && !room->can_lift(room->lifting_point(to))) return std::nullopt;
  const std::array<std::size_t, 2> followers{(moved + m - 1) % m, (moved + 1) % m};
  robots[moved] = room ? room->lifting_point(to) : to;
  std::vector<LiftingPoint> others;
  for (std::size_t i = 0; i < m; ++i)
    if (i != followers[0] && i != followers[1]) others.push_back(robots[i]);

  // Either end of the chord may go to either follower.
  std::optional<std::array<LiftingPoint, 2>> nearest;
  double least = 0;
  for (const Candidate& candidate : balanced::all_pairs_to_complete(problem.rules(), others)) {
    const LiftingPoint &r1 = candidate.chord.r1, &r2 = candidate.chord.r2;
    for (const std::array<LiftingPoint, 2>& ends : {std::array{r1, r2}, std::array{r2, r1}}) {
      const double way =
          square(ends[0], robots[followers[0]]) + square(ends[1], robots[followers[1]]);
      if (nearest && !(way < least)) continue;
      if (problem.rules().collides(others, others.size(), r1) ||
          problem.rules().collides(others, others.size(), r2))
        continue;
      nearest = ends;
      least = way;
    }
  }
  if (!nearest || (room && room->any_collide(others))) return std::nullopt;
  for (std::size_t i = 0; i < followers.size(); ++i) robots[followers[i]] = (*nearest)[i];
  return robots;
}

}  // namespace evenlift
