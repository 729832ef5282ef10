#include "exchange/choices.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "balanced/small_hull.h"
#include "evenlift/tolerance.h"

namespace evenlift::exchange {
namespace {

constexpr double least_margin = 0.001, halfway = 0.4;
// Bounds of margins are computed in plain doubles.
constexpr double slack = 1e-9;
// Where the reach of parts is kept: memory for all directions together, in numbers.
constexpr std::size_t most_reaches = std::size_t{1} << 23, most_directions = 256;

std::array<double, 3> ascending(double min_margin) {
  std::array<double, 3> bounds{least_margin, halfway * min_margin, min_margin};
  std::sort(bounds.begin(), bounds.end());
  return bounds;
}

void append(const Chord& chord, std::vector<LiftingPoint>& robots) {
  robots.push_back(chord.r1);
  robots.push_back(chord.r2);
}

}  // namespace

Choices::Choices(const Polygon& polygon, const Vec2& centre,
                 const std::vector<Candidate>& candidates, double min_margin)
    : polygon_(polygon),
      candidates_(candidates),
      centre_(centre),
      bounds_(ascending(min_margin)),
      coarse_cover_(polygon, centre),
      cover_(polygon, centre),
      margins_(polygon, centre) {
  parts_.reserve(candidates.size());
  for (std::uint32_t i = 0; i < candidates.size(); ++i) parts_.push_back(part_of({i}));
  most_directions_ = std::clamp(most_reaches / std::max<std::size_t>(candidates.size(), 1),
                                std::size_t{26}, most_directions);
  for (const int x : {-1, 0, 1})
    for (const int y : {-1, 0, 1})
      for (const int z : {-1, 0, 1})
        if (x != 0 || y != 0 || z != 0) know(Wrench(x, y, z).normalized());
}

Part Choices::part_of(const std::vector<std::uint32_t>& taken,
                      std::optional<std::size_t> without) const {
  Part part;
  for (std::size_t team = 0; team < taken.size(); ++team) {
    if (team == without) continue;
    const Chord& chord = candidates_[taken[team]].chord;
    append(chord, part.robots);
    part.ratios += chord.ratio;
  }
  part.wrenches = margins_.wrenches_of(part.robots);
  return part;
}

std::uint32_t Choices::level_of(const std::optional<double>& margin) const {
  if (!margin) return 0;
  return static_cast<std::uint32_t>(std::upper_bound(bounds_.begin(), bounds_.end(), *margin) -
                                    bounds_.begin());
}

HoldKeys Choices::keys_of(const Part& part) const {
  return {level_of(margins_.of(part.robots)), cover_.of(balanced::small_hull(part.robots, centre_)),
          part.ratios};
}

double Choices::reach(const Part& part, const Wrench& u) {
  double farthest = -std::numeric_limits<double>::infinity();
  for (const Wrench& w : part.wrenches) farthest = std::max(farthest, u.dot(w));
  return farthest;
}

void Choices::know(const Wrench& direction) {
  if (directions_.size() >= most_directions_) return;
  Direction known{direction, {}};
  known.reach.reserve(parts_.size() + staying_.size());
  for (const Part& part : parts_) known.reach.push_back(reach(part, direction));
  for (const Part& part : staying_) known.reach.push_back(reach(part, direction));
  directions_.push_back(std::move(known));
}

void Choices::set_parts(std::vector<Part> parts) {
  staying_ = std::move(parts);
  for (Direction& known : directions_) {
    known.reach.resize(parts_.size());
    for (const Part& part : staying_) known.reach.push_back(reach(part, known.u));
  }
}

const std::vector<LiftingPoint>& Choices::robots_of(const Trial& trial) const {
  robots_ = part(trial.other).robots;
  append(candidates_[trial.candidate].chord, robots_);
  return robots_;
}

Trial Choices::trial(std::uint32_t candidate, std::uint32_t other) const {
  constexpr double rounding = 1 + 1e-12;
  Trial trial{candidate, other};
  trial.coverage =
      rounding * balanced::small_hull(robots_of(trial), centre_).area / polygon_.area();
  return trial;
}

void Choices::sharpen(Trial& trial) const {
  const balanced::SmallHull hull = balanced::small_hull(robots_of(trial), centre_);
  trial.coverage =
      trial.sharpness == 0 ? std::min(trial.coverage, coarse_cover_.most(hull)) : cover_.of(hull);
  ++trial.sharpness;
}

bool Choices::surely_below(const Trial& trial, std::uint32_t level) const {
  const double bound = bounds_[level - 1] - slack;
  return std::any_of(directions_.begin(), directions_.end(), [&](const Direction& known) {
    return known.reach[trial.candidate] < bound && known.reach[trial.other] < bound;
  });
}

bool Choices::reaches(const Trial& trial, std::uint32_t level) {
  const std::vector<Wrench> wrenches = margins_.wrenches_of(robots_of(trial));
  if (wrenches.empty()) return false;
  const WeakestDirection weakest = weakest_direction(wrenches);
  if (level_of(weakest.margin) >= level) return true;
  know(weakest.direction);
  return false;
}

}  // namespace evenlift::exchange
