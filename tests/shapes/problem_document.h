// The oracle's problem as the core's document.
#pragma once

#include <cstdint>
#include <vector>

#include "evenlift/document.h"
#include "evenlift/polygon_with_holes.h"
#include "oracle/oracle.h"

namespace evenlift::testing {

inline oracle::Point point_of(const Vec2& v) { return {v.x, v.y}; }

inline oracle::Ring ring_of(const Points& points) {
  oracle::Ring ring;
  for (const Vec2& v : points) ring.push_back(point_of(v));
  return ring;
}

inline Points points_of(const oracle::Ring& ring) {
  Points points;
  for (const oracle::Point& p : ring) points.emplace_back(p[0], p[1]);
  return points;
}

inline std::vector<Points> points_of(const std::vector<oracle::Ring>& rings) {
  std::vector<Points> points;
  for (const oracle::Ring& ring : rings) points.push_back(points_of(ring));
  return points;
}

// With its centroid as C.
inline oracle::Problem problem_of(const PolygonWithHoles& object) {
  oracle::Problem problem;
  problem.vertices = ring_of(object.outline().vertices());
  for (const Polygon& hole : object.holes()) problem.holes.push_back(ring_of(hole.vertices()));
  return problem;
}

inline Document document_of(const oracle::Problem& problem) {
  Document d;
  d.vertices = points_of(problem.vertices);
  d.holes = points_of(problem.holes);
  if (problem.centre_of_mass)
    d.centre_of_mass = Vec2((*problem.centre_of_mass)[0], (*problem.centre_of_mass)[1]);
  d.settings.teams = static_cast<std::uint32_t>(problem.teams);
  d.settings.min_ratio = problem.min_ratio;
  d.settings.weight = problem.weight;
  d.settings.method = problem.metric == oracle::Metric::area     ? Method::area
                      : problem.metric == oracle::Metric::circle ? Method::circle
                                                                 : Method::distance;
  return d;
}

}  // namespace evenlift::testing
