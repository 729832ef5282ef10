// What one edge takes away of another: the open stretches along it on which a robot would meet the
// other edge with its body, its arm or its hand (stands.h, conditions 1 to 3).
#pragma once

#include <array>
#include <optional>

#include "evenlift/stands.h"

namespace evenlift {

// Another edge, as the edge sees it on which the robot stands: x runs along that edge from its
// first vertex, y away from the object.
struct SeenObstacle {
  Vec2 p, q;
};

// The stretch that the body, the arm and the hand lose; `near` is tau L. O(1).
std::optional<Stretch> lost_to_body(const SeenObstacle& other, const RobotSize& robot, double near);
std::optional<Stretch> lost_to_arm(const SeenObstacle& other, const RobotSize& robot);
std::optional<Stretch> lost_to_hand(const SeenObstacle& other, const RobotSize& robot, double near);
// Where the hand would reach onto a marked part of the other edge: the part is beside the contact's
// edge, no farther beneath it than a tenth of the hand's width. O(1).
std::optional<Stretch> lost_to_mark(const SeenObstacle& other, const EdgePart& part,
                                    const RobotSize& robot, double near);
// Where the other edge parts the contact from the hand. O(1).
std::optional<Stretch> parted_from_hand(const SeenObstacle& other, const RobotSize& robot,
                                        double near);

}  // namespace evenlift
