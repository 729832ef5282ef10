// The requirements on balanced robots, and the comparison of two sets by the keys of
// evenlift/balanced.h. A key is computed only when needed, and cheap keys come first. Nearly all
// sets lose by a bound.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "balanced/coarse_cover.h"
#include "balanced/cover.h"
#include "balanced/outline.h"
#include "balanced/small_hull.h"
#include "balanced/triples.h"
#include "candidates/even_chords.h"
#include "evenlift/balanced.h"
#include "evenlift/balanced_history.h"
#include "evenlift/stands.h"
#include "grasp/hold_levels.h"
#include "grasp/margins.h"

namespace evenlift::balanced {

// A set with those of its keys that have been computed.
struct RatedSet {
  std::vector<LiftingPoint> robots;
  std::uint32_t near_pairs = 0;
  std::optional<int> steady;
  std::optional<std::uint32_t> level;
  std::optional<SmallHull> hull;
  std::optional<double> coverage, spread;
  std::optional<std::vector<double>> places;

  // Clears the keys for other robots, which have this number of near pairs.
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
  // The cost of a completion in units of most_work (balanced.h); 0 for outlines whose work is not
  // bounded.
  std::uint64_t work_of_completion() const { return work_of_completion_; }
  const std::vector<Triple>& triples() const { return triples_; }

  // Where robots with a size can stand; null for points that may stand anywhere.
  const Stands* room() const { return room_.get(); }
  // Whether `other` collides with one of the first `number` robots. O(number).
  bool collides(const std::vector<LiftingPoint>& robots, std::size_t number,
                const LiftingPoint& other) const;

  // The number of the first `number` robots that are too near to `other`. O(number).
  std::uint32_t near_pairs(const std::vector<LiftingPoint>& robots, std::size_t number,
                           const LiftingPoint& other) const;

  // The number of near pairs of all robots. O(m^2).
  std::uint32_t near_pairs(const std::vector<LiftingPoint>& robots) const;

  // Whether the goal is hold, but the margin misses the first level.
  bool misses_hold(RatedSet& set) const { return holds_ && level(set) == 0; }
  // Whether a reaches a higher level than b.
  bool holds_better(RatedSet& a, RatedSet& b) const { return level(a) > level(b); }

  bool better(RatedSet& a, RatedSet& b) const;

  // The key that decides between two sets; nothing if they tie in all keys.
  std::optional<BalancedKey> decided_by(RatedSet& a, RatedSet& b) const;

  // The set of these robots, with its number of near pairs. O(m^2).
  RatedSet rated(const std::vector<LiftingPoint>& robots) const;

  BalancedKeys keys(RatedSet& set) const;

  // The same set, with its keys, and with its robots in order along the outline.
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

  // The first key in which two sets differ, and the better set: 1 for a, -1 for b, 0 for a tie.
  struct Decision {
    int order = 0;
    BalancedKey key = BalancedKey::near_pairs;
  };
  Decision decide(RatedSet& a, RatedSet& b) const;

  PolygonWithHoles object_;
  Vec2 centre_;
  std::uint32_t robots_;
  bool holds_;  // whether the goal is hold
  HoldRequirements firm_;
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
