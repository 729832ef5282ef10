// Converts the core's placement for the oracle of sets.
#pragma once

#include <vector>

#include "balanced/set_oracle.h"
#include "evenlift/chords.h"
#include "evenlift/polygon.h"

namespace evenlift::testing {

inline set_oracle::Object object_of(const Polygon& polygon, const Vec2& centre) {
  set_oracle::Object object;
  for (const Vec2& v : polygon.vertices()) object.vertices.push_back({v.x, v.y});
  object.centre = {centre.x, centre.y};
  return object;
}

inline std::vector<set_oracle::Point> plain(const std::vector<LiftingPoint>& robots) {
  std::vector<set_oracle::Point> points;
  for (const LiftingPoint& robot : robots) points.push_back({robot.position.x, robot.position.y});
  return points;
}

}  // namespace evenlift::testing
