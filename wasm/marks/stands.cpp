#include "marks/stands.h"

#include "evenlift/output/words.h"
#include "marks/boxed_text.h"
#include "marks/robot_discs.h"

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

}  // namespace evenlift::view
