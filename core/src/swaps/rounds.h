// Choices of teams on trial, and quick proofs that a choice cannot be the best.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "balanced/search.h"
#include "evenlift/stands.h"
#include "evenlift/swaps.h"
#include "grasp/grasp.h"

namespace evenlift::swaps {

// The robots of a candidate, or of the teams that stay while another team is swapped.
struct Part {
  std::vector<LiftingPoint> robots;
  std::vector<Wrench> wrenches;
  double ratios = 0;
};

// A choice on trial: a candidate, and the part `other` to which it is added. Parts are numbered:
// first the candidates, then the parts that stay.
struct Trial {
  std::uint32_t candidate = 0, other = 0;
  double coverage = 0;           // of the choice, or its upper bound
  std::uint8_t sharpness = 0;    // 0 and 1: bounds, 2: exact
  std::uint8_t most_level = 3;   // upper bound of the choice's margin level
  std::uint8_t least_level = 0;  // lower bound of that level
};

class Choices {
 public:
  // The object, candidates and stands must outlive this object. O(K log n) for K candidates.
  Choices(const PolygonWithHoles& object, const Vec2& centre,
          const std::vector<Candidate>& candidates, const HoldRequirements& hold,
          const Stands* stands = nullptr);

  // The part of the teams on these candidates, except team number `without`, counted from 0.
  Part part_of(const std::vector<std::uint32_t>& taken,
               std::optional<std::size_t> without = std::nullopt) const;

  HoldKeys keys_of(const Part& part) const;

  // The number of candidates, and of parts that stay.
  std::uint32_t size() const { return static_cast<std::uint32_t>(parts_.size()); }
  std::uint32_t parts() const { return static_cast<std::uint32_t>(staying_.size()); }

  void set_parts(std::vector<Part> parts);

  // Whether no robots of the two parts collide. O(robots).
  bool fit(std::uint32_t candidate, std::uint32_t other) const;

  // Returns a trial with a first bound of its coverage. O(robots).
  Trial trial(std::uint32_t candidate, std::uint32_t other) const;

  // Bounds the coverage more closely; the second call computes it exactly.
  void sharpen(Trial& trial) const;

  // Whether a known direction proves that the margin is below `level`, which must be above 0.
  bool surely_below(const Trial& trial, std::uint32_t level);

  // Whether the margin reaches the level, and the hold is firm. If the margin does not, the direction of the weakest hold becomes known.
  bool reaches(const Trial& trial, std::uint32_t level);

  // Whether the work so far exceeds most_swap_steps (swaps.h).
  bool is_spent() const { return steps_ > most_swap_steps; }
  std::uint64_t steps() const { return steps_; }

  double ratios(const Trial& trial) const {
    return part(trial.candidate).ratios + part(trial.other).ratios;
  }

 private:
  const Part& part(std::uint32_t number) const {
    return number < parts_.size() ? parts_[number] : staying_[number - parts_.size()];
  }
  const std::vector<LiftingPoint>& robots_of(const Trial& trial) const;
  void know(const Wrench& direction);

  const PolygonWithHoles& object_;
  const std::vector<Candidate>& candidates_;
  const Stands* stands_;  // null if robots have no size
  Vec2 centre_;
  std::array<double, 3> bounds_;  // the least margins of levels 1 to 3
  balanced::CoarseCover coarse_cover_;
  balanced::Cover cover_;
  Margins margins_;
  std::vector<Part> parts_;                   // of the candidates
  std::vector<Part> staying_;                 // parts that stay
  std::vector<Wrench> directions_;            // to test for weakness; the last useful one is first
  mutable std::vector<LiftingPoint> robots_;  // reused by all trials
  mutable std::uint64_t steps_ = 0;
};

// --- A round of swaps, which finds the best of the choices on trial.

struct Better {
  Trial trial;
  HoldKeys keys;
  HoldKey decided_by = HoldKey::level;
};

// Returns the best trial if it is better than the present choice, otherwise nullopt. If trials tie
// in all keys, the first is chosen.
std::optional<Better> best_trial(Choices& choices, std::vector<Trial> trials, const HoldKeys& now);

}  // namespace evenlift::swaps
