// Explains why no balanced robot stands at a place.
#include <algorithm>

#include "evenlift/plane.h"
#include "evenlift/why_not.h"
#include "trace/balanced_steps.h"
#include "trace/margin_of.h"

namespace evenlift {
namespace {

LiftingPoint nearest_on_boundary(const Polygon& polygon, const Vec2& at) {
  LiftingPoint nearest{polygon.vertex(0), 0};
  for (std::uint32_t edge = 0; edge < polygon.size(); ++edge) {
    const Vec2 p = nearest_on_segment(polygon.edge_start(edge), polygon.edge_end(edge), at);
    if (length(p - at) < length(nearest.position - at)) nearest = {p, edge};
  }
  return nearest;
}

bool has_robot(const std::vector<LiftingPoint>& robots, const Vec2& place) {
  return std::any_of(robots.begin(), robots.end(),
                     [&](const LiftingPoint& robot) { return robot.position == place; });
}

// Searches backwards for the move that put a robot at `place`.
void find_arrival(const Trace& trace, const BalancedSet& set, const Vec2& place,
                  WhyNoRobot& answer) {
  const BalancedHistory& history = trace.history;
  answer.why = WhyNoRobot::Why::stands_from_start;
  bool reached = false;
  for (std::size_t move = history.moves.size(); move-- > 0;) {
    reached = reached || &history.moves[move].set == &set;
    const std::vector<LiftingPoint>& before =
        move == 0 ? history.start.back().robots : history.moves[move - 1].set.robots;
    if (!reached || has_robot(before, place)) continue;
    answer.why = WhyNoRobot::Why::stands;
    answer.move = move;
    return;
  }
}

// Separates robots that stay from those that come, with the one at `place` first. A robot that
// comes to another's place stays.
void part_by_place(const std::vector<LiftingPoint>& before, const Vec2& place, BalancedSet& set) {
  for (const LiftingPoint& robot : set.robots)
    (has_robot(before, robot.position) ? set.kept : set.came).push_back(robot);
  std::stable_partition(set.came.begin(), set.came.end(),
                        [&](const LiftingPoint& robot) { return robot.position == place; });
}

SetComparison compare(const Trace& trace, const std::vector<LiftingPoint>& robots,
                      const std::vector<LiftingPoint>& now) {
  const BalancedProblem& problem = *trace.problem;
  SetComparison comparison;
  comparison.keys = balanced_keys(problem, robots);
  comparison.keys_now = balanced_keys(problem, now);
  comparison.margin = margin_of(trace, robots);
  comparison.margin_now = margin_of(trace, now);
  comparison.decided_by = decided_by(problem, robots, now).value_or(BalancedKey::places);
  comparison.better = is_better(problem, robots, now);
  return comparison;
}

}  // namespace

WhyNoRobot why_no_robot(const Trace& trace, std::uint32_t k, const Vec2& at, double reach) {
  WhyNoRobot answer;
  answer.place = nearest_on_boundary(trace.polygon(), at);
  const BalancedSet* set = balanced_set_at(trace, trace.step(k));
  if (!set || set->robots.size() < 3)
    set = balanced_set_at(trace, {StepKind::result, Chapter::grasp});
  if (!set || set->robots.size() < 3) return answer;
  const StepDetail detail = look_at(trace, k);
  const std::vector<LiftingPoint>& robots = set->robots;
  for (std::uint32_t i = 0; i < robots.size(); ++i) {
    if (length(robots[i].position - at) > reach) continue;
    const bool shown = detail.balanced && detail.balanced->robots.size() == robots.size();
    answer.robot = shown ? detail.balanced->numbers[i] : i;
    find_arrival(trace, *set, robots[i].position, answer);
    return answer;
  }
  const auto best = best_with_robot_at(*trace.problem, robots, answer.place);
  answer.why = best ? WhyNoRobot::Why::other_set : WhyNoRobot::Why::no_completion;
  if (!best) return answer;
  answer.set.robots = best->set.robots;
  part_by_place(robots, best->set.came.front().position, answer.set);
  answer.comparison = compare(trace, best->set.robots, robots);
  return answer;
}

SetComparison compare_even_chord(const Trace& trace, const StepDetail& detail,
                                 std::uint32_t choice) {
  const BalancedDetail& balanced = *detail.balanced;
  std::vector<LiftingPoint> robots = balanced.rest;
  robots.push_back(balanced.chords[choice].r1);
  robots.push_back(balanced.chords[choice].r2);
  return compare(trace, robots, balanced.robots);
}

}  // namespace evenlift
