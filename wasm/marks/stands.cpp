#include "marks/marks.h"

#include <algorithm>
#include <string>
#include <vector>

#include "evenlift/output/words.h"
#include "evenlift/stability.h"
#include "walkthrough/walkthrough.h"

namespace evenlift::view {

void draw_unusable(const Painter& painter, const Placement& placement, const Theme& theme) {
  const Polygon& polygon = placement.polygon();
  for (const UnusablePart& part : placement.stands->unusable()) {
    const Vec2 &a = polygon.edge_start(part.edge), &b = polygon.edge_end(part.edge);
    const Vec2 along = (b - a) / length(b - a);
    const bool marked = part.why == WhyUnusable::no_go;
    painter.line(a + part.part.from * along, a + part.part.to * along,
                 marked ? theme.amber : theme.quiet, marked ? 6.0f : 4.0f);
  }
}

namespace {

bool has_few_bodies(const Placement& placement) {
  constexpr std::size_t most = 400;
  return draws_sizes(placement) && count_robots(placement.teams) <= most;
}

// The robot's mark would hide a smaller body.
bool is_drawn(const CanvasView& view) {
  const double radius = view.placement->stands->robot().radius * view.camera.scale;
  return radius >= static_cast<double>(mark_radius(view.placement->teams));
}

// The hand beneath the object, the arm, and the body.
void draw_body(const Painter& painter, const CanvasView& view, const PlacedRobot& robot,
               const evenlift::RobotSize& size) {
  const Theme& theme = view.theme;
  const Vec2 inward = robot.contact - robot.stand;
  const double way = length(inward);
  // In the dark theme a robot is as dark as the background, so its disc's ring also surrounds its
  // body.
  if (way > 0 && size.reach > 0) {
    painter.line(robot.stand, robot.contact, theme.robot_ring, 4);
    painter.line(robot.stand, robot.contact, theme.robot, 2);
  }
  if (way > 0 && (size.width > 0 || size.depth > 0)) {
    const Vec2 aside = left_normal(inward) * (size.width / 2 / way);
    const Points hand{robot.contact - aside, robot.contact + aside, robot.at + aside,
                      robot.at - aside};
    painter.fill_convex(hand, theme.robot.at(0.35f));
    painter.outline(hand, theme.robot_ring, 1.5f);
  }
  // An arm that extends beyond the mark leads to a body, however small.
  const bool reaches =
      size.reach > 0 &&
      way * view.camera.scale > static_cast<double>(mark_radius(view.placement->teams));
  if (!is_drawn(view) && !reaches) return;
  const auto radius = static_cast<float>(size.radius * view.camera.scale);
  ImDrawList& list = painter.list();
  list.AddCircleFilled(painter.at(robot.stand), radius, theme.robot.at(0.22f).packed(), 64);
  list.AddCircle(painter.at(robot.stand), radius, theme.robot_ring.packed(), 64, 1.5f);
}

}  // namespace

bool draws_sizes(const Placement& placement) {
  return placement.stands && placement.stands->has_body();
}

std::vector<PlacedRobot> drawn_bodies(const CanvasView& view) {
  if (!has_few_bodies(*view.placement) || !is_drawn(view)) return {};
  return placed_robots(*view.placement);
}

void draw_stands(const Painter& painter, const CanvasView& view) {
  if (!view.placement->stands) return;
  draw_unusable(painter, *view.placement, view.theme);
  if (!has_few_bodies(*view.placement)) return;
  for (const PlacedRobot& robot : placed_robots(*view.placement))
    draw_body(painter, view, robot, view.placement->stands->robot());
}

std::optional<WhyUnusable> why_unusable(const AppState& state, const Pick& at) {
  if (at.kind != Pick::Kind::edge || state.derived().refusal || !state.derived().placement ||
      !state.derived().placement->stands)
    return std::nullopt;
  const Stands& stands = *state.derived().placement->stands;
  if (at.index >= state.derived().placement->polygon().size()) return std::nullopt;
  const auto edge = static_cast<std::uint32_t>(at.index);
  return stands.why_not(edge, stands.along({at.at, edge}));
}

void draw_why_unusable(const Painter& painter, const CanvasView& view) {
  const AppState& state = view.state;
  if (state.view.held.kind != Pick::Kind::none || view.second) return;
  const auto why = why_unusable(state, state.view.hover);
  if (!why) return;
  draw_word(painter.list(), state.view.camera.to_screen(state.view.hover.at), view.uncovered(),
            view.theme, view.theme.text,
            capitalised(unusable_in_words(*why, settings(state).robot, shown(state).units)));
}

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
  const DiscSize size = robot_size((balanced.robots.size() + 1) / 2);
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
  const DiscSize size = robot_size((balanced.robots.size() + 1) / 2);
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
  const DiscSize size = robot_size((robots.size() + 1) / 2);
  for (std::size_t i = std::min<std::size_t>(known, robots.size()); i-- > 0;)
    draw_robot(
        painter, view.theme, size, robots[i].point.position,
        {.number = view.placement->number_of(i), .beneath = robots[i].point.edge == beneath});
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
  const std::vector<DiscSize> sizes = robot_sizes(view, teams, known.teams);
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
