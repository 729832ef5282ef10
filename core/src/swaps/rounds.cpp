#include "swaps/rounds.h"

#include <algorithm>
#include <utility>

#include "balanced/search.h"
#include "evenlift/tolerance.h"
#include "grasp/grasp.h"

namespace evenlift::swaps {
namespace {

// Covers the rounding of u . w, which is below 1e-15: u is a unit vector, and w, with torques in
// units of R, is at most sqrt(2) long. It costs only a few more full examinations.
constexpr double slack = 1e-9;
// A choice that no direction rules out is tested in all.
constexpr std::size_t most_directions = 64;

void append(const Chord& chord, std::vector<LiftingPoint>& robots) {
  robots.push_back(chord.r1);
  robots.push_back(chord.r2);
}

}  // namespace

Choices::Choices(const PolygonWithHoles& object, const Vec2& centre,
                 const std::vector<Candidate>& candidates, const HoldRequirements& hold,
                 const Stands* stands)
    : object_(object),
      candidates_(candidates),
      stands_(stands),
      centre_(centre),
      bounds_(level_bounds(hold.min_margin)),
      coarse_cover_(object, centre),
      cover_(object, centre),
      margins_(object, centre, hold) {
  parts_.reserve(candidates.size());
  for (std::uint32_t i = 0; i < candidates.size(); ++i) parts_.push_back(part_of({i}));
  for (const int x : {-1, 0, 1})
    for (const int y : {-1, 0, 1})
      for (const int z : {-1, 0, 1})
        if (x != 0 || y != 0 || z != 0) know(unit(Wrench(x, y, z)));
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
  part.wrenches = margins_.wrenches_of(contact_points(stands_, part.robots));
  return part;
}

bool Choices::fit(std::uint32_t candidate, std::uint32_t other) const {
  if (!stands_) return true;
  steps_ += part(other).robots.size();
  const std::vector<LiftingPoint>&robots = part(candidate).robots, &others = part(other).robots;
  return std::none_of(robots.begin(), robots.end(), [&](const LiftingPoint& a) {
    return std::any_of(others.begin(), others.end(),
                       [&](const LiftingPoint& b) { return stands_->collide(a, b); });
  });
}

HoldKeys Choices::keys_of(const Part& part) const {
  return {margins_.level_of(contact_points(stands_, part.robots)).level,
          cover_.of(balanced::small_hull(part.robots, centre_), steps_), part.ratios};
}

void Choices::set_parts(std::vector<Part> parts) { staying_ = std::move(parts); }

const std::vector<LiftingPoint>& Choices::robots_of(const Trial& trial) const {
  robots_ = part(trial.other).robots;
  append(candidates_[trial.candidate].chord, robots_);
  return robots_;
}

Trial Choices::trial(std::uint32_t candidate, std::uint32_t other) const {
  constexpr double rounding = 1 + 1e-12;
  Trial trial{candidate, other};
  steps_ += 8 + robots_of(trial).size();
  trial.coverage = rounding * balanced::small_hull(robots_of(trial), centre_).area / object_.area();
  return trial;
}

void Choices::sharpen(Trial& trial) const {
  const balanced::SmallHull hull = balanced::small_hull(robots_of(trial), centre_);
  steps_ += 16 + robots_of(trial).size();
  trial.coverage = trial.sharpness == 0 ? std::min(trial.coverage, coarse_cover_.most(hull))
                                        : cover_.of(hull, steps_);
  ++trial.sharpness;
}

bool Choices::surely_below(const Trial& trial, std::uint32_t level) {
  const double bound = bounds_[level - 1] - slack;
  const auto stays_below = [&](const Part& part, const Wrench& u) {
    return std::all_of(part.wrenches.begin(), part.wrenches.end(),
                       [&](const Wrench& w) { return dot(u, w) < bound; });
  };
  const Part &first = part(trial.candidate), &second = part(trial.other);
  const auto telling = std::find_if(directions_.begin(), directions_.end(), [&](const Wrench& u) {
    return stays_below(first, u) && stays_below(second, u);
  });
  steps_ += 1 + static_cast<std::uint64_t>(telling - directions_.begin());
  if (telling == directions_.end()) return false;
  // A direction that ruled out one choice often rules out the next.
  std::rotate(directions_.begin(), telling, telling + 1);
  return true;
}

void Choices::know(const Wrench& direction) {
  if (directions_.size() == most_directions) directions_.pop_back();
  directions_.insert(directions_.begin(), direction);
}

bool Choices::reaches(const Trial& trial, std::uint32_t level) {
  const std::vector<LiftingPoint> points = contact_points(stands_, robots_of(trial));
  const std::vector<Wrench> wrenches = margins_.wrenches_of(points);
  steps_ += 20 * wrenches.size();
  if (wrenches.empty()) return false;
  const WeakestDirection weakest = weakest_direction(wrenches);
  if (level_of(weakest.margin, bounds_) >= level) {
    if (level == 0) return true;
    steps_ += 100 * wrenches.size();
    return margins_.are_firm(points, weakest);
  }
  know(weakest.direction);
  return false;
}

namespace {

constexpr std::uint8_t exact = 2;

// The trials of one level, the greatest possible coverage first, then in order.
class ByCoverage {
 public:
  ByCoverage(std::vector<Trial>& trials, std::vector<std::uint32_t> which)
      : trials_(trials), heap_(std::move(which)) {
    std::make_heap(heap_.begin(), heap_.end(), covers_less());
  }

  bool empty() const { return heap_.empty(); }
  std::uint32_t first() const { return heap_.front(); }
  void pop() {
    std::pop_heap(heap_.begin(), heap_.end(), covers_less());
    heap_.pop_back();
  }
  // After the first trial's coverage has decreased.
  void sift() {
    std::pop_heap(heap_.begin(), heap_.end(), covers_less());
    std::push_heap(heap_.begin(), heap_.end(), covers_less());
  }

 private:
  struct CoversLess {
    const std::vector<Trial>& trials;
    bool operator()(std::uint32_t a, std::uint32_t b) const {
      const double p = trials[a].coverage, q = trials[b].coverage;
      return p != q ? p < q : a > b;
    }
  };
  CoversLess covers_less() const { return {trials_}; }

  std::vector<Trial>& trials_;
  std::vector<std::uint32_t> heap_;
};

// Level by level, the best first.
class Round {
 public:
  Round(Choices& choices, std::vector<Trial> trials, const HoldKeys& now)
      : choices_(choices), trials_(std::move(trials)), now_(now) {}

  std::optional<Better> run() {
    for (std::uint32_t level = best_level; level + 1 > now_.level; --level) {
      const std::vector<std::uint32_t> found = best_by_coverage(level);
      if (choices_.is_spent()) break;
      if (!found.empty()) return best_by_ratios(found, level);
      if (level == 0) break;
    }
    return std::nullopt;
  }

 private:
  HoldKeys keys(const Trial& trial, std::uint32_t level) const {
    return {level, trial.coverage, choices_.ratios(trial)};
  }

  // Trials that may reach a level and are not certainly worse than the present choice.
  std::vector<std::uint32_t> possible(std::uint32_t level, double least) {
    std::vector<std::uint32_t> which;
    for (std::uint32_t i = 0; i < trials_.size(); ++i) {
      Trial& trial = trials_[i];
      if (trial.most_level < level || trial.coverage < least) continue;
      if (fails(trial, level)) continue;
      which.push_back(i);
    }
    return which;
  }

  // Whether known directions prove that the trial is below the level.
  bool fails(Trial& trial, std::uint32_t level) {
    if (trial.least_level >= level || !choices_.surely_below(trial, level)) return false;
    trial.most_level = static_cast<std::uint8_t>(level - 1);
    return true;
  }

  // Of the trials at the level that are better than the present choice, those that tie for the
  // largest coverage. No trial may be above the level.
  std::vector<std::uint32_t> best_by_coverage(std::uint32_t level) {
    double least = level == now_.level ? now_.coverage - coverage_tie : -1;
    ByCoverage queue(trials_, possible(level, least));
    std::vector<std::uint32_t> found;
    while (!queue.empty() && trials_[queue.first()].coverage >= least && !choices_.is_spent()) {
      Trial& trial = trials_[queue.first()];
      // Above the present level, no coverage is too small until a trial is found, so the margin is
      // tested first.
      const bool margin_first = least < 0;
      if (fails(trial, level) || (margin_first && !reaches(trial, level))) {
        queue.pop();
      } else if (trial.sharpness < exact) {
        choices_.sharpen(trial);
        queue.sift();
      } else {
        const std::uint32_t which = queue.first();
        queue.pop();
        if (!better_by(keys(trial, level), now_) || !reaches(trial, level)) continue;
        if (found.empty()) least = std::max(least, trial.coverage - coverage_tie);
        found.push_back(which);
      }
    }
    return found;
  }

  bool reaches(Trial& trial, std::uint32_t level) {
    if (trial.least_level >= level) return true;
    if (choices_.reaches(trial, level)) {
      trial.least_level = static_cast<std::uint8_t>(level);
      return true;
    }
    trial.most_level = static_cast<std::uint8_t>(level - 1);
    return false;
  }

  Better best_by_ratios(std::vector<std::uint32_t> found, std::uint32_t level) const {
    double largest = 0;
    for (const std::uint32_t i : found) largest = std::max(largest, choices_.ratios(trials_[i]));
    std::erase_if(found,
                  [&](std::uint32_t i) { return choices_.ratios(trials_[i]) < largest - tau; });
    const Trial& best = trials_[*std::min_element(found.begin(), found.end())];
    const HoldKeys now = keys(best, level);
    return {best, now, *better_by(now, now_)};
  }

  Choices& choices_;
  std::vector<Trial> trials_;
  const HoldKeys& now_;
};

}  // namespace

std::optional<Better> best_trial(Choices& choices, std::vector<Trial> trials, const HoldKeys& now) {
  return Round(choices, std::move(trials), now).run();
}

}  // namespace evenlift::swaps
