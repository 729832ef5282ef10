// The loads of the robots (algorithm.md, Loads; thesis 5.3).
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "evenlift/chords.h"

namespace evenlift {

// A robot of a team.
struct Robot {
  LiftingPoint point;
  double arm = 0;   // distance from C; on a chord, not affected by the rounding of `point`
  double load = 0;  // in the unit of the weight
};

// Robots that carry a part of the weight together. A team has at least two robots, except that a
// given support may be alone. All teams of a placement have the same number of robots. The robots
// of a team of two stand at the ends of a chord, unless they are given supports.
struct Team {
  std::vector<Robot> robots;  // on a chord, r1 before r2
  // The least load divided by the greatest, 0 .. 1. It is 0 only with given supports or after a
  // failure, if a robot of the team carries nothing.
  double ratio = 1;
};

// Returns the chord of a team of two. O(1).
Chord chord_of(const Team& team);

// Robots are numbered from 0, team after team. find_robot() returns the team of the robot with this
// number, and the robot's index in the team. O(1).
struct RobotOfTeam {
  std::size_t team = 0, robot = 0;
};
std::size_t count_robots(const std::vector<Team>& teams);
RobotOfTeam find_robot(const std::vector<Team>& teams, std::size_t number);

// Returns the robots' lifting points in the order of their numbers. O(robots).
std::vector<LiftingPoint> lifting_points(const std::vector<Team>& teams);

// Returns the robots' loads in the order of their numbers. O(robots).
std::vector<double> planned_loads(const std::vector<Team>& teams);

struct LoadSummary {
  double min = 0, mean = 0, max = 0;  // over all robots
  double spread = 0;                  // max - min (figure 5.3)
  double max_share = 0;               // the greatest share of a team's load on one robot (fig. 5.5)
};

// Returns the teams with their loads. Each team carries an equal part of `weight` > 0. By the law
// of the lever, r1 carries |C r2| / (|C r1| + |C r2|) of its team's part. O(teams).
std::vector<Team> distribute_weight(const std::vector<Chord>& chords, double weight);

// Returns one team of these robots with equal planned loads. The robots' centroid must be C.
// O(robots).
Team share_evenly(const std::vector<LiftingPoint>& robots, const Vec2& centre, double weight);

// Summarizes the loads of all robots; returns nothing if there are no teams. O(robots).
std::optional<LoadSummary> summarize_loads(const std::vector<Team>& teams);

}  // namespace evenlift
