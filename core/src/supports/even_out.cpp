#include <algorithm>
#include <array>

#include "balanced/completions.h"
#include "evenlift/supports.h"
#include "evenlift/tolerance.h"

namespace evenlift {
namespace {

using Robots = std::vector<LiftingPoint>;

Vec2 centroid_of(const Robots& robots) {
  Vec2 sum;
  for (const LiftingPoint& robot : robots) sum += robot.position;
  return sum / static_cast<double>(robots.size());
}

// The best move so far, by the sum of squared displacements.
class NearestEven {
 public:
  NearestEven(const balanced::Rules& rules, const Robots& robots)
      : rules_(rules), robots_(robots) {}

  // Tries all places of robots i < j, perhaps with a third at `place`.
  void try_two(std::size_t i, std::size_t j, std::optional<std::size_t> third = std::nullopt,
               const LiftingPoint& place = {}) {
    Robots all = robots_;
    if (third) all[*third] = place;
    const double before = third ? square(place, robots_[*third]) : 0;
    if (best_ && !(before < least_)) return;
    Robots others, staying;
    for (std::size_t k = 0; k < all.size(); ++k) {
      if (k == i || k == j) continue;
      others.push_back(all[k]);
      if (k != third) staying.push_back(all[k]);
    }
    if (third && rules_.collides(staying, staying.size(), place)) return;
    for (const Candidate& candidate : balanced::all_pairs_to_complete(rules_, others)) {
      const LiftingPoint &r1 = candidate.chord.r1, &r2 = candidate.chord.r2;
      for (const auto& ends : {std::array{r1, r2}, std::array{r2, r1}}) {
        const double way = before + square(ends[0], robots_[i]) + square(ends[1], robots_[j]);
        if (best_ && !(way < least_)) continue;
        if (rules_.collides(others, others.size(), r1) ||
            rules_.collides(others, others.size(), r2))
          continue;
        all[i] = ends[0];
        all[j] = ends[1];
        best_ = all;
        least_ = way;
      }
    }
  }

  const std::optional<Robots>& best() const { return best_; }

 private:
  static double square(const LiftingPoint& a, const LiftingPoint& b) {
    return squared_length(a.position - b.position);
  }

  const balanced::Rules& rules_;
  const Robots& robots_;
  std::optional<Robots> best_;
  double least_ = 0;
};

}  // namespace

std::optional<Robots> even_out(const BalancedProblem& problem, const Robots& robots) {
  const std::size_t m = robots.size();
  const double near = near_distance(problem.rules().polygon().diameter());
  if (m > 0 && length(centroid_of(robots) - problem.rules().centre()) <= near) return robots;
  NearestEven nearest(problem.rules(), robots);
  for (std::size_t i = 0; i < m; ++i)
    for (std::size_t j = i + 1; j < m; ++j) nearest.try_two(i, j);
  if (nearest.best() || m > most_evened_by_three) return nearest.best();
  for (std::size_t third = 0; third < m; ++third)
    for (const LiftingPoint& place : problem.rules().stands())
      for (std::size_t i = 0; i < m; ++i)
        for (std::size_t j = i + 1; j < m; ++j)
          if (i != third && j != third) nearest.try_two(i, j, third, place);
  return nearest.best();
}

}  // namespace evenlift
