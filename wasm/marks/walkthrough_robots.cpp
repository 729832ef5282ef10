#include "marks/walkthrough_robots.h"

#include <algorithm>
#include <string>
#include <vector>

#include "evenlift/stability.h"
#include "marks/load_labels.h"
#include "marks/robots.h"
#include "walkthrough/questions.h"

namespace evenlift::view {
namespace {

// A robot's former place: its disc, hollow and with its number.
void draw_left(const Painter& painter, const CanvasView& view, const Figure& figure) {
  const ImVec2 at = painter.at(figure.points[0]);
  painter.list().AddCircleFilled(at, 11, view.theme.object.packed(), 32);
  painter.list().AddCircle(at, 10, view.theme.amber_on_object.packed(), 32, 2);
  const std::string number = std::to_string(figure.item.value_or(0) + 1);
  const ImVec2 text = text_size(Face::tiny, number);
  draw_text(painter.list(), Face::tiny, ImVec2(at.x - text.x / 2, at.y - text.y / 2),
            view.theme.amber_on_object, number);
}

// The robots that stay while a question concerns the others, whose possible places have rings
// (canvas_walkthrough.cpp).
void draw_rest_of_question(const Painter& painter, const CanvasView& view) {
  const BalancedDetail& balanced = *view.state.view.walkthrough.ask->detail.balanced;
  const RobotSize size = robot_size((balanced.robots.size() + 1) / 2);
  const auto stays = [&](const Vec2& place) {
    if (balanced.stand && balanced.stand->position == place) return false;
    return std::any_of(balanced.rest.begin(), balanced.rest.end(),
                       [&](const LiftingPoint& robot) { return robot.position == place; });
  };
  for (std::size_t i = 0; i < balanced.robots.size(); ++i) {
    const Vec2& place = balanced.robots[i].position;
    if (stays(place))
      draw_robot(painter, view.theme, size, place,
                 {.number = balanced.numbers[i] + std::size_t{1}});
  }
}

void draw_balanced_of_walkthrough(const Painter& painter, const CanvasView& view) {
  const Walkthrough& walk = view.state.view.walkthrough;
  if (asks_of_other_robots(view.state)) return draw_rest_of_question(painter, view);
  if (!walk.detail.balanced) return;
  const BalancedDetail& balanced = *walk.detail.balanced;
  const RobotSize size = robot_size((balanced.robots.size() + 1) / 2);
  for (const Figure& figure : walk.figures)
    if (figure.kind == FigureKind::left) draw_left(painter, view, figure);
  for (std::size_t i = balanced.robots.size(); i-- > 0;)
    draw_robot(painter, view.theme, size, balanced.robots[i].position,
               {.number = balanced.numbers[i] + std::size_t{1}});
}

}  // namespace

std::vector<LoadLabel> loads_of_walkthrough(const CanvasView& view) {
  const Walkthrough& walk = view.state.view.walkthrough;
  const std::size_t teams = view.placement->teams.size();
  if (!walk.trace->balanced()) {
    const std::size_t shares = walk.known.shares;
    const bool told = shares > 0 && shares == teams && shares <= most_labelled;
    return told ? planned_load_labels(view, robot_size(teams)) : std::vector<LoadLabel>();
  }
  const Chapter chapter = walk.detail.step.chapter;
  if (asks_of_other_robots(view.state) || !walk.detail.balanced ||
      (chapter != Chapter::loads && chapter != Chapter::grasp))
    return {};
  // The document's robots may have been moved by hand.
  CanvasView found = view;
  found.placement = &walk.trace->placement;
  return planned_load_labels(found, robot_size((walk.detail.balanced->robots.size() + 1) / 2));
}

// As far as the steps have shown them.
void draw_supports_of_walkthrough(const Painter& painter, const CanvasView& view) {
  const std::vector<Robot>& robots = view.placement->teams[0].robots;
  const std::uint32_t known = view.state.view.walkthrough.known.robots;
  const RobotSize size = robot_size((robots.size() + 1) / 2);
  for (std::size_t i = std::min<std::size_t>(known, robots.size()); i-- > 0;)
    draw_robot(painter, view.theme, size, robots[i].point.position,
               {.number = i + 1, .beneath = robots[i].point.edge == beneath});
}

void draw_robots_of_walkthrough(const Painter& painter, const CanvasView& view) {
  const Placement& placement = *view.placement;
  if (view.state.view.walkthrough.trace->given())
    return draw_supports_of_walkthrough(painter, view);
  if (view.state.view.walkthrough.trace->balanced())
    return draw_balanced_of_walkthrough(painter, view);
  const Progress& known = view.state.view.walkthrough.known;
  if (known.teams > most_single_robots) return draw_swarm(painter, view, known.teams);
  const std::vector<Team>& teams = teams_at(*view.state.view.walkthrough.trace, known);
  const std::vector<RobotSize> sizes = robot_sizes(view, teams, known.teams);
  for (std::size_t i = known.teams; i-- > 0;) {
    std::size_t number = robots_of(teams, i);
    for (const Robot& robot : teams[i].robots) {
      const Vec2& at = robot.point.position;
      const double share = i < known.shares ? robot.load / placement.loads->max : 1;
      draw_robot(painter, view.theme, sizes[number], at,
                 {number + 1, i + 1, at - placement.centre_of_mass, share});
      ++number;
    }
  }
}

}  // namespace evenlift::view
