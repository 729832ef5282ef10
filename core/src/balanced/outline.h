// The outline of P as a walk from v*, which does not depend on the first vertex of the list, and
// the trial points along it.
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

  // Lambda.
  double length() const { return starts_.back(); }

  // The edges in the order of the walk. O(n).
  std::vector<std::uint32_t> edges() const;

  // The distance from v* counter-clockwise to a point on one of the edges, in [0, Lambda). A point
  // within tau Lambda of the end of the walk counts as its beginning. O(1).
  double place(const LiftingPoint& point) const;

  // The trial points, in their order. If robots have a size, the trial points are lifting points
  // spread over the usable ranges. The ends and the middle of each usable interval follow, unless
  // there are more intervals than trial points. O(n).
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
  std::vector<double> starts_;           // by step: the distance before it; then Lambda
};

}  // namespace evenlift::balanced
