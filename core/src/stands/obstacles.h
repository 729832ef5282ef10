// The open ranges where the robot's body, arm or hand would meet another edge (docs/stands.md,
// Where an edge can be used, conditions 1 to 3).
#pragma once

#include <array>
#include <optional>

#include "evenlift/stands.h"

namespace evenlift {

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

}  // namespace evenlift
