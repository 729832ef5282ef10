// The requirements on balanced robots, and the comparison of two sets by the keys of
// evenlift/balanced.h. Rules computes a key only when it is needed, and first tries cheap bounds of
// the coverage, by which nearly all sets lose.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "balanced/cover.h"
#include "balanced/outline.h"
#include "balanced/triples.h"
#include "candidates/even_chords.h"
#include "evenlift/balanced.h"
#include "evenlift/balanced_history.h"
#include "evenlift/stands.h"
#include "grasp/hold_levels.h"
#include "grasp/margins.h"

namespace evenlift::balanced {

// A set with those of its keys (see BalancedKeys) that have been computed.
struct RatedSet {
  std::vector<LiftingPoint> robots;
  std::uint32_t near_pairs = 0;
  std::optional<int> steady;
  std::optional<Margins::Level> level;
  std::optional<SmallHull> hull;
  std::optional<double> coverage, spread;
  std::uint64_t steps_of_coverage = 0;  // cover.h
  std::optional<std::vector<double>> places;

  // Clears the keys after `robots` has changed. `pairs` is the number of near pairs of the new
  // robots.
  void begin(std::uint32_t pairs);
};

class Rules {
 public:
  Rules(PolygonWithHoles object, const Vec2& centre, const Settings& settings);
  Rules(const Rules&) = delete;
  Rules& operator=(const Rules&) = delete;

  const Polygon& polygon() const { return object_.outline(); }
  const Vec2& centre() const { return centre_; }
  std::uint32_t robots() const { return robots_; }
  const EvenChords& chords() const { return chords_; }
  const Outline& outline() const { return outline_; }
  const std::vector<LiftingPoint>& stands() const { return stands_; }
  // What a completion adds to BalancedWork::completions; 0 if they are not counted.
  std::uint64_t work_of_completion() const { return work_of_completion_; }
  // Whether the boundary has more than 1,000 vertices.
  bool is_large() const { return work_of_completion_ > 0; }
  // The part of the limits (balanced.h) that this work uses; 1 or more if it exceeds one.
  double used(const BalancedWork& work) const;
  // The steps that it took to compute those keys of a set that are known. O(1).
  std::uint64_t steps_of(const RatedSet& set) const;
  const std::vector<Triple>& triples() const { return triples_; }

  // The places where robots can stand; null if robots are points that may stand anywhere.
  const Stands* room() const { return room_.get(); }
  // Whether `other` collides with one of the first `number` robots. O(number).
  bool collides(const std::vector<LiftingPoint>& robots, std::size_t number,
                const LiftingPoint& other) const;

  // Of the first `number` robots, counts those that are too near to `other`. O(number).
  std::uint32_t near_pairs(const std::vector<LiftingPoint>& robots, std::size_t number,
                           const LiftingPoint& other) const;

  // The number of near pairs of all robots. O(m^2).
  std::uint32_t near_pairs(const std::vector<LiftingPoint>& robots) const;

  // Whether the goal is `hold`, but the set has level 0.
  bool misses_hold(RatedSet& set) const { return holds_ && level(set) == 0; }
  // Whether the set `a` reaches a higher level than the set `b`.
  bool holds_better(RatedSet& a, RatedSet& b) const { return level(a) > level(b); }

  bool better(RatedSet& a, RatedSet& b) const;

  // Returns the key that decides between two sets; nothing if the sets tie in all keys.
  std::optional<BalancedKey> decided_by(RatedSet& a, RatedSet& b) const;

  // Returns the set of these robots, with its number of near pairs. O(m^2).
  RatedSet rated(const std::vector<LiftingPoint>& robots) const;

  BalancedKeys keys(RatedSet& set) const;

  // Returns the same set with its keys, but with its robots in order along the outline.
  RatedSet in_order(const RatedSet& set) const;

 private:
  int steady(RatedSet& set) const;
  std::uint32_t level(RatedSet& set) const;
  const SmallHull& hull(RatedSet& set) const;
  bool covers_less(RatedSet& set, double bound) const;
  double coverage(RatedSet& set) const;
  double spread(RatedSet& set) const;
  double place(const LiftingPoint& robot) const;
  const std::vector<double>& places(RatedSet& set) const;
  bool surely_loses_by_coverage(RatedSet& a, RatedSet& b) const;

  // The first key in which two sets differ, and the better set: `order` is 1 if `a` is better, -1
  // if `b` is, and 0 if they tie.
  struct Decision {
    int order = 0;
    BalancedKey key = BalancedKey::near_pairs;
  };
  Decision decide(RatedSet& a, RatedSet& b) const;

  PolygonWithHoles object_;
  Vec2 centre_;
  std::uint32_t robots_;
  bool holds_;  // whether the goal is `hold`
  HoldRequirements hold_;
  double near_square_;  // robots at a smaller squared distance are too near
  int survive_;
  std::shared_ptr<const Stands> room_;
  Outline outline_;
  std::vector<LiftingPoint> stands_;
  std::vector<Triple> triples_;
  EvenChords chords_;
  std::uint64_t work_of_completion_ = 0;
  CoarseCover coarse_cover_;
  Cover cover_;
  Margins margins_;
};

}  // namespace evenlift::balanced
