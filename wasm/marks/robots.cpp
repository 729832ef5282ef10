#include "marks/robots.h"

#include <optional>
#include <vector>

#include "marks/free_motions.h"
#include "marks/load_labels.h"
#include "marks/robot_discs.h"
#include "marks/stands.h"
#include "tools/pick.h"

namespace evenlift::view {

void draw_robots(const Painter& painter, const CanvasView& view) {
  const Placement& placement = *view.placement;
  if (placement.teams.empty()) return;
  if (placement.teams.size() > most_single_robots)
    return draw_swarm(painter, view, placement.teams.size());
  const Report& report = view.report();
  const std::vector<RobotSize> sizes = robot_sizes(view, placement.teams, placement.teams.size());
  const bool at_rest = view.scene.progress >= 1;
  if (pairs_of(placement.teams) <= most_labelled && at_rest) {
    const RobotSize size = robot_size(pairs_of(placement.teams));
    Occupied occupied = occupied_by_marks(view, mark_reach(size));
    draw_slide(painter, view, &occupied);
    draw_far_regions(painter, view, &occupied);
    draw_loads(painter, view, load_labels(view, size, report, occupied));
  } else {
    draw_slide(painter, view, nullptr);
    draw_far_regions(painter, view, nullptr);
  }
  const std::optional<Explanation>& card = view.state.derived().explanation;
  const Pick pointed = marked_part(view.state);
  const auto is_marked = [&](std::size_t robot) {
    if (card && !view.second && card->robot == robot) return true;
    const auto [team, end] = find_robot(placement.teams, robot);
    return pointed.kind == Pick::Kind::robot && pointed.second == view.second &&
           pointed.index == team && pointed.end == static_cast<int>(end);
  };
  const bool paired = !is_one_team(placement.settings.method);
  const auto grown = [&](std::size_t robot, const Vec2& at) {
    RobotSize size = sizes[robot];
    if (at_rest || stood_there(view.scene, at)) return size;
    size.disc *= view.scene.progress;
    size.ring *= view.scene.progress;
    return size;
  };
  const std::vector<LiftingPoint> points = lifting_points(placement.teams);
  for (std::size_t robot = 0; robot < points.size() && !draws_sizes(placement); ++robot)
    draw_small_body(painter, view.theme, grown(robot, points[robot].position),
                    points[robot].position);
  for (std::size_t i = placement.teams.size(); i-- > 0;) {
    std::size_t number = robots_of(placement.teams, i);
    for (const Robot& robot : placement.teams[i].robots) {
      const Vec2& at = robot.point.position;
      const double load = report.loads[number].greatest;
      draw_robot(painter, view.theme, grown(number, at), at,
                 {number + 1, paired ? i + 1 : 0, at - placement.centre_of_mass,
                  report.greatest > 0 ? load / report.greatest : 0, view.overloads(number, load),
                  view.failure() && view.failure()->robot == number, is_marked(number),
                  robot.point.edge == beneath});
      ++number;
    }
  }
}

}  // namespace evenlift::view
