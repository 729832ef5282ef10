// The outline of P as a walk from v*, and its trial points (algorithm.md, Balanced robots). They do
// not depend on which vertex is first in the list.
#pragma once

#include <cstdint>
#include <vector>

#include "evenlift/chords.h"
#include "evenlift/polygon.h"
#include "evenlift/stands.h"

namespace evenlift::balanced {

class Outline {
 public:
  // The polygon must outlive it. O(n).
  Outline(const Polygon& polygon, const Vec2& centre);

  // The length of the outline, Lambda.
  double length() const { return starts_.back(); }

  // The edges in the order of the walk. O(n).
  std::vector<std::uint32_t> edges() const;

  // The distance along the outline, counter-clockwise from v* to a point on an edge. It is in
  // [0, Lambda). A distance within tau Lambda of Lambda counts as 0. O(1).
  double place(const LiftingPoint& point) const;

  // The trial points, in order. For robots with a size (`room`), these are lifting points spread
  // over the usable intervals (docs/stands.md), then the ends and the middle of each interval. The
  // ends and middles are left out if there are more intervals than spread points. O(n).
  std::vector<LiftingPoint> stands(const Stands* room = nullptr) const;

 private:
  std::vector<LiftingPoint> usable_stands(std::uint32_t number, const Stands& room) const;
  std::vector<LiftingPoint> interval_stands(std::uint32_t most, const Stands& room) const;
  std::uint32_t edge_of_step(std::size_t step) const;
  std::vector<LiftingPoint> even_stands(std::uint32_t number) const;
  std::vector<LiftingPoint> reflex_stands(std::uint32_t most) const;

  const Polygon& polygon_;
  std::vector<std::uint32_t> vertices_;  // from v* counter-clockwise
  std::vector<std::uint32_t> steps_;     // by edge: the step of the walk along it
  std::vector<double> starts_;           // by step: the distance from v* to it; finally Lambda
};

}  // namespace evenlift::balanced
