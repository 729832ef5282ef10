// The outline of P as a walk from v*, and its trial points (algorithm.md, Balanced robots). Neither
// depends on which vertex is first in the list.
#pragma once

#include <cstdint>
#include <vector>

#include "evenlift/chords.h"
#include "evenlift/polygon.h"
#include "evenlift/stands.h"

namespace evenlift::balanced {

class Outline {
 public:
  // The polygon must outlive the Outline. O(n).
  Outline(const Polygon& polygon, const Vec2& centre);

  // The length of the outline, Lambda.
  double length() const { return starts_.back(); }

  // The edges in the order of the walk. O(n).
  std::vector<std::uint32_t> edges() const;

  // Returns the distance along the outline, counter-clockwise from v* to a point on an edge. It is
  // in [0, Lambda); a distance within tau Lambda of Lambda counts as 0. O(1).
  double place(const LiftingPoint& point) const;

  // The trial points, in order. If robots have a size or there are no-go parts, `room` must be
  // given. The trial points are then the lifting points of contacts at equal distances along all
  // usable intervals (docs/stands.md). The lifting points for the ends and the middle of each
  // interval follow, but only if there are no more intervals than points at equal distances. O(n).
  std::vector<LiftingPoint> stands(const Stands* room = nullptr) const;

 private:
  std::vector<LiftingPoint> usable_stands(std::uint32_t number, const Stands& room) const;
  std::vector<LiftingPoint> interval_stands(std::uint32_t most, const Stands& room) const;
  std::uint32_t edge_of_step(std::size_t step) const;
  std::vector<LiftingPoint> even_stands(std::uint32_t number) const;
  std::vector<LiftingPoint> reflex_stands(std::uint32_t most) const;

  const Polygon& polygon_;
  std::vector<std::uint32_t> vertices_;  // from v* counter-clockwise
  std::vector<std::uint32_t> steps_;     // by edge: the step of the walk along this edge
  std::vector<double> starts_;           // by step: its distance from v*; the last is Lambda
};

}  // namespace evenlift::balanced
