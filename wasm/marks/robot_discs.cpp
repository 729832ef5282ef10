#include "marks/robot_discs.h"

#include <algorithm>
#include <string>

#include "evenlift/output/picture.h"
#include "ui/vec.h"

namespace evenlift::view {

std::size_t pairs_of(const std::vector<Team>& teams) { return (count_robots(teams) + 1) / 2; }

RobotSize robot_size(std::size_t teams) {
  if (teams <= 8) return {10.5f, 13.5f, true};
  if (teams <= 16) return {9, 11.5f, true};
  if (teams <= most_labelled) return {8.5f, 10.5f, true};
  return {4, 5.5f, false};
}

float mark_radius(const std::vector<Team>& teams) {
  return robot_size(pairs_of(teams)).ring + 1.5f;
}

namespace {

constexpr float body_beyond_ring = 5;
constexpr double tally_from_ring = 2.5, tally_length = 7;

}  // namespace

double mark_reach(const RobotSize& size) {
  return static_cast<double>(size.ring) + (size.numbered ? tally_from_ring + tally_length : 2);
}

void draw_small_body(const Painter& painter, const Theme& theme, const RobotSize& size,
                     const Vec2& world) {
  const ImVec2 at = painter.at(world);
  const float radius = size.ring + (size.numbered ? body_beyond_ring : 3);
  painter.list().AddCircleFilled(at, radius, theme.robot.at(0.22f).packed(), 48);
  painter.list().AddCircle(at, radius, theme.robot_ring.at(0.7f).packed(), 48, 1);
}

std::size_t robots_of(const std::vector<Team>& all, std::size_t teams) {
  return all.empty() ? 0 : teams * all.front().robots.size();
}

std::vector<RobotSize> robot_sizes(const CanvasView& view, const std::vector<Team>& all,
                                   std::size_t teams) {
  std::vector<RobotSize> sizes(robots_of(all, teams), robot_size(pairs_of(all)));
  if (pairs_of(all) > most_labelled) return sizes;
  Points robots;
  for (std::size_t i = 0; i < teams; ++i)
    for (const Robot& robot : all[i].robots)
      robots.push_back(view.camera.to_screen(robot.point.position));
  for (std::size_t i = 0; i < robots.size(); ++i) {
    double nearest = 1e9;
    for (std::size_t j = 0; j < robots.size(); ++j)
      if (j != i) nearest = std::min(nearest, length(robots[i] - robots[j]));
    if (nearest < 17)
      sizes[i] = {5.5f, 7, false};
    else if (nearest < 27 && sizes[i].disc > 8.5f)
      sizes[i] = {8.5f, 10.5f, true};
  }
  return sizes;
}

void draw_robot(const Painter& painter, const Theme& theme, const RobotSize& size,
                const Vec2& world, const RobotLook& look) {
  ImDrawList& list = painter.list();
  const ImVec2 at = painter.at(world);
  const float pi = 3.14159265f, start = -pi / 2;
  if (look.failed) {
    list.AddCircleFilled(at, size.ring, theme.object.packed(), 36);
    list.AddCircle(at, size.disc, theme.robot.packed(), 32, 2);
  } else {
    list.AddCircleFilled(at, size.ring + 1.5f, theme.robot_track.packed(), 36);
    list.PathArcTo(at, size.ring, start, start + 2 * pi * static_cast<float>(look.share), 40);
    list.PathStroke((look.over ? theme.amber : theme.robot_ring).packed(), 0,
                    look.over ? 3.0f : 2.0f);
    list.AddCircleFilled(at, size.disc - 1, (look.beneath ? theme.object : theme.robot).packed(),
                         32);
    if (look.beneath) list.AddCircle(at, size.disc - 2, theme.robot.packed(), 32, 1.5f);
  }
  if (look.marked) list.AddCircle(at, size.ring + 4, theme.accent_on_object.packed(), 40, 3);
  if (!size.numbered) return;
  const Vec2 on_screen(look.outward.x, -look.outward.y);
  const Vec2 middle(static_cast<double>(at.x), static_cast<double>(at.y));
  const double rim = static_cast<double>(size.ring) + tally_from_ring;
  for (const auto& [line, five] : tally(look.team, middle, on_screen, rim)) {
    const ImVec2 from = vec(line.from.x, line.from.y), to = vec(line.to.x, line.to.y);
    list.AddLine(from, to, theme.robot_ring.packed(), five ? 5.5f : 4.0f);
    list.AddLine(from, to, theme.robot.packed(), five ? 3.5f : 2.0f);
  }
  const std::string number = std::to_string(look.number);
  const ImVec2 text = text_size(Face::tiny, number);
  draw_text(list, Face::tiny, ImVec2(at.x - text.x / 2, at.y - text.y / 2),
            look.failed || look.beneath ? theme.robot : theme.robot_text, number);
}

void draw_swarm(const Painter& painter, const CanvasView& view, std::size_t teams) {
  constexpr double spot = 3;  // pixels
  const Rect& window = view.window;
  const auto across = static_cast<std::size_t>(window.width() / spot) + 1,
             down = static_cast<std::size_t>(window.height() / spot) + 1;
  std::vector<bool> taken(across * down);
  const auto draw = [&](const Vec2& robot, Colour colour) {
    const Vec2 at = view.camera.to_screen(robot);
    if (!window.contains(at)) return;
    const auto column = static_cast<std::size_t>((at.x - window.left) / spot),
               row = static_cast<std::size_t>((at.y - window.top) / spot);
    if (taken[row * across + column]) return;
    taken[row * across + column] = true;
    painter.list().AddRectFilled(vec(at.x - 2, at.y - 2), vec(at.x + 2, at.y + 2), colour.packed());
  };
  // Overloaded robots come first, so that none hides them.
  for (const bool over : {true, false}) {
    std::size_t number = 0;
    for (std::size_t i = 0; i < teams; ++i) {
      for (const Robot& robot : view.placement->teams[i].robots) {
        const std::size_t now = number++;
        if (view.overloads(now, view.report().loads[now].greatest) != over) continue;
        draw(robot.point.position, over ? view.theme.amber_on_object : view.theme.robot);
      }
    }
  }
}

}  // namespace evenlift::view
