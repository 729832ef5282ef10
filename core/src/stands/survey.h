// What edges lose to bodies, arms, hands, no-go parts and corners.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "evenlift/document.h"
#include "evenlift/plane.h"
#include "evenlift/polygon_with_holes.h"
#include "evenlift/stands.h"
#include "polygon/corners.h"

namespace evenlift {

// --- The open ranges where the robot's body, arm or hand would meet another edge (docs/stands.md,
// Where an edge can be used, conditions 1 to 3).

// Another edge in the frame of the robot's edge: x runs along the robot's edge from its first
// vertex, y away from the object.
struct SeenObstacle {
  Vec2 p, q;
};

// The range in which the robot's body, arm or hand would meet the other edge; nullopt if it meets
// the edge nowhere. `near` is tau L. O(1).
std::optional<Stretch> lost_to_body(const SeenObstacle& other, const RobotSize& robot, double near);
std::optional<Stretch> lost_to_arm(const SeenObstacle& other, const RobotSize& robot);
std::optional<Stretch> lost_to_hand(const SeenObstacle& other, const RobotSize& robot, double near);
// The range in which the hand would reach onto a no-go part of the other edge. The part counts only
// where y is at most 0 and at least -1/10 of the hand's width, give or take `near`. O(1).
std::optional<Stretch> lost_to_mark(const SeenObstacle& other, const EdgePart& part,
                                    const RobotSize& robot, double near);
// The range in which the other edge separates the contact from the hand. O(1).
std::optional<Stretch> parted_from_hand(const SeenObstacle& other, const RobotSize& robot,
                                        double near);

// --- The ranges of an edge that are lost, since no robot can use them, and the reasons.

// The number of values of WhyUnusable without the last, `narrow`.
inline constexpr std::size_t reasons_to_lose = static_cast<std::size_t>(WhyUnusable::narrow);

class Losses {
 public:
  // Adds an open range that is lost for this reason. It may reach beyond the edge. O(1).
  void add(WhyUnusable why, const Stretch& lost) {
    lost_[static_cast<std::size_t>(why)].push_back(lost);
  }

  // The parts of an edge of this length, in order. `why` is the first of the part's reasons in the
  // order of WhyUnusable, or nullopt if the part is usable; neighbouring parts have different
  // values. O(k log k) for k ranges.
  struct Part {
    Stretch part;
    std::optional<WhyUnusable> why;
  };
  std::vector<Part> parts(double length);

 private:
  std::array<std::vector<Stretch>, reasons_to_lose> lost_;
};

// --- Finds the edges near an edge, by a tree of boxes.

// A rectangle: the points `start` + x `along` + y `outward`, with x and y in these ranges.
struct Surrounding {
  Vec2 start, along, outward;
  double x_low, x_high, y_low, y_high;
};

class NearEdges {
 public:
  // Edges that are neighbours in the list should be near each other. O(n).
  explicit NearEdges(std::vector<LineEnds> edges) : edges_(std::move(edges)), tree_(edges_) {}

  const LineEnds& edge(std::uint32_t i) const { return edges_[i]; }

  // Visits the edges whose boxes meet the rectangle, and perhaps a few others, in ascending order.
  // O(log n) for each edge that meets the rectangle, if the edges do not wind much.
  template <class Visit>
  void for_each(const Surrounding& around, Visit&& visit) const {
    descend(around, 0, visit);
  }

 private:
  template <class Visit>
  void descend(const Surrounding& around, std::uint32_t index, Visit& visit) const {
    const EdgeTree::Node& node = tree_.node(index);
    if (!meets(around, node.box)) return;
    if (node.is_leaf()) {
      for (std::uint32_t edge = node.begin; edge < node.end; ++edge)
        if (meets(around, bounding_box({edges_[edge].start, edges_[edge].end}))) visit(edge);
      return;
    }
    descend(around, node.left, visit);
    descend(around, node.right, visit);
  }

  static bool meets(const Surrounding& around, const Box& box);

  std::vector<LineEnds> edges_;
  EdgeTree tree_;
};

// --- Finds the ranges that edges lose to no-go parts, corners and other edges, including holes' edges.

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
