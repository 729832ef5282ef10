#include "evenlift/loads.h"

#include <algorithm>

namespace evenlift {

Chord chord_of(const Team& team) {
  const Robot &r1 = team.robots[0], &r2 = team.robots[1];
  return {r1.point, r2.point, r1.arm, r2.arm, team.ratio};
}

std::size_t count_robots(const std::vector<Team>& teams) {
  return teams.empty() ? 0 : teams.size() * teams.front().robots.size();
}

RobotOfTeam find_robot(const std::vector<Team>& teams, std::size_t number) {
  const std::size_t size = teams.front().robots.size();
  return {number / size, number % size};
}

std::vector<LiftingPoint> lifting_points(const std::vector<Team>& teams) {
  std::vector<LiftingPoint> points;
  points.reserve(count_robots(teams));
  for (const Team& team : teams)
    for (const Robot& robot : team.robots) points.push_back(robot.point);
  return points;
}

std::vector<double> planned_loads(const std::vector<Team>& teams) {
  std::vector<double> loads;
  loads.reserve(count_robots(teams));
  for (const Team& team : teams)
    for (const Robot& robot : team.robots) loads.push_back(robot.load);
  return loads;
}

std::vector<Team> distribute_weight(const std::vector<Chord>& chords, double weight) {
  std::vector<Team> teams;
  teams.reserve(chords.size());
  const double share = weight / static_cast<double>(chords.size());
  for (const Chord& chord : chords) {
    const double whole = chord.arm1 + chord.arm2;
    teams.push_back({{{chord.r1, chord.arm1, share * (chord.arm2 / whole)},
                      {chord.r2, chord.arm2, share * (chord.arm1 / whole)}},
                     chord.ratio});
  }
  return teams;
}

Team share_evenly(const std::vector<LiftingPoint>& robots, const Vec2& centre, double weight) {
  Team team;
  const double load = weight / static_cast<double>(robots.size());
  for (const LiftingPoint& robot : robots)
    team.robots.push_back({robot, length(robot.position - centre), load});
  return team;
}

std::optional<LoadSummary> summarize_loads(const std::vector<Team>& teams) {
  if (teams.empty()) return std::nullopt;
  LoadSummary summary;
  summary.min = summary.max = teams.front().robots.front().load;
  double sum = 0;
  for (const Team& team : teams) {
    double low = team.robots.front().load, high = low, of_team = 0;
    for (const Robot& robot : team.robots) {
      low = std::min(low, robot.load);
      high = std::max(high, robot.load);
      of_team += robot.load;
    }
    summary.min = std::min(summary.min, low);
    summary.max = std::max(summary.max, high);
    summary.max_share = std::max(summary.max_share, high / of_team);
    sum += of_team;
  }
  summary.mean = sum / static_cast<double>(count_robots(teams));
  summary.spread = summary.max - summary.min;
  return summary;
}

}  // namespace evenlift
