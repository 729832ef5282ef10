// Finds the ranges that edges lose to no-go parts, corners and other edges, including holes' edges.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "evenlift/document.h"
#include "evenlift/polygon_with_holes.h"
#include "polygon/corners.h"
#include "stands/losses.h"
#include "stands/near_edges.h"
#include "stands/obstacles.h"

namespace evenlift {

EdgeFrame frame_of(const Polygon& polygon, std::uint32_t edge);

class Surveyor {
 public:
  // The object must outlive the surveyor. O(n), and O(p log p) for p no-go parts.
  Surveyor(const PolygonWithHoles& object, const RobotSize& robot,
           const std::vector<EdgePart>& no_go);

  // The ranges that an edge loses. O(log n) for each edge near enough to obstruct a robot.
  Losses survey(std::uint32_t edge, const EdgeFrame& frame) const;

 private:
  std::span<const EdgePart> marked_on(std::uint32_t edge) const;
  void add_no_go(std::uint32_t edge, double size, Losses& losses) const;
  void add_corners(std::uint32_t edge, const EdgeFrame& frame, Losses& losses) const;
  void add_obstacles(std::uint32_t edge, const EdgeFrame& frame, Losses& losses) const;
  void add_holes(const Surrounding& around, const EdgeFrame& frame, Losses& losses) const;
  SeenObstacle seen_from(std::uint32_t edge, const EdgeFrame& frame, std::uint32_t other) const;
  void add_obstacle(const SeenObstacle& obstacle, Losses& losses) const;

  const Polygon& polygon_;
  RobotSize robot_;
  double near_;
  NearEdges edges_, holes_;
  Corners corners_;
  std::vector<EdgePart> no_go_;  // by edge, then by place along it
};

}  // namespace evenlift
