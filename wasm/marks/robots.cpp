#include "marks/robots.h"

#include <optional>
#include <vector>

#include "marks/free_motions.h"
#include "marks/load_labels.h"
#include "marks/robot_discs.h"

namespace evenlift::view {

void draw_robots(const Painter& painter, const CanvasView& view) {
  const Placement& placement = *view.placement;
  if (placement.teams.empty()) return;
  if (placement.teams.size() > most_single_robots)
    return draw_swarm(painter, view, placement.teams.size());
  const Outlook& outlook = view.outlook();
  const std::vector<RobotSize> sizes = robot_sizes(view, placement.teams, placement.teams.size());
  const bool at_rest = view.scene.progress >= 1;
  if (pairs_of(placement.teams) <= most_labelled && at_rest) {
    const RobotSize size = robot_size(pairs_of(placement.teams));
    Occupied occupied = occupied_by_marks(view, static_cast<double>(size.ring) + 2);
    draw_slide(painter, view, &occupied);
    draw_far_regions(painter, view, &occupied);
    draw_loads(painter, view, load_labels(view, size, outlook, occupied));
  } else {
    draw_slide(painter, view, nullptr);
    draw_far_regions(painter, view, nullptr);
  }
  // The discs of a team's robots have the team's number. Balanced robots, which the code keeps as a
  // single team, have numbers of their own; so do all robots while one fails, since messages then
  // name single robots.
  const std::optional<Explanation>& card = view.state.derived().explanation;
  const auto is_explained = [&](std::size_t robot) {
    return card && !view.second && card->robot == robot;
  };
  const bool alone = is_one_team(placement.settings.method) || view.failure();
  for (std::size_t i = placement.teams.size(); i-- > 0;) {
    std::size_t number = robots_of(placement.teams, i);
    for (const Robot& robot : placement.teams[i].robots) {
      const Vec2& at = robot.point.position;
      RobotSize now = sizes[number];
      if (!at_rest && !stood_there(view.scene, at)) {
        now.disc *= view.scene.progress;
        now.ring *= view.scene.progress;
      }
      const double load = outlook.loads[number].greatest;
      draw_robot(painter, view.theme, now, at,
                 {alone ? number + 1 : i + 1, outlook.greatest > 0 ? load / outlook.greatest : 0,
                  view.overloads(number, load), view.failure() && view.failure()->robot == number,
                  is_explained(number), robot.point.edge == beneath});
      ++number;
    }
  }
}

}  // namespace evenlift::view
