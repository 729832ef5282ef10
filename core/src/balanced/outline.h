// The outline of P as a walk from v*, whatever the first vertex of the list, and its trial points.
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

  // In the order of the walk. O(n).
  std::vector<std::uint32_t> edges() const;

  // The distance from v* counter-clockwise to a point on an edge, in [0, Lambda). A distance within
  // tau Lambda of Lambda counts as 0. O(1).
  double place(const LiftingPoint& point) const;

  // The trial points in order; for robots with a size lifting points spread over the usable ranges,
  // then the ends and middle of each usable interval, unless there are more intervals than trial
  // points. O(n).
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
