#include "swaps/rounds.h"

#include <algorithm>
#include <utility>

#include "evenlift/tolerance.h"
#include "grasp/hold_levels.h"

namespace evenlift::swaps {
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
