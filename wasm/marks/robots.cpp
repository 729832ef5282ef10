#include "marks/marks.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "evenlift/output/markup.h"
#include "evenlift/output/picture.h"
#include "evenlift/output/words.h"
#include "tools/pick.h"
#include "tools/transform.h"
#include "ui/controls.h"
#include "ui/theme.h"

namespace evenlift::view {

void draw_word(ImDrawList& list, const Vec2& spot, const Rect& window, const Theme& theme,
               Colour colour, const std::string& text) {
  const ImVec2 size = text_size(Face::strong_label, text);
  const double width = static_cast<double>(size.x) + 16, height = static_cast<double>(size.y) + 10;
  const double left =
      std::clamp(spot.x + 14, window.left + 4, std::max(window.left + 4, window.right - width - 4));
  double top = spot.y - height - 10;
  if (top < window.top + 4) top = std::max(spot.y + 18, window.top + 4);
  const ImVec2 low = vec(left, top), high = vec(left + width, top + height);
  list.AddRectFilled(low, high, theme.panel.at(0.95f).packed(), 6);
  list.AddRect(low, high, colour.at(0.5f).packed(), 6, 0, 1);
  draw_text(list, Face::strong_label, ImVec2(low.x + 8, low.y + 5), colour, text);
}

namespace {

Rect box_at(const Vec2& from, const Vec2& to, const Vec2& size, double share) {
  const Vec2 low = from + (to - from) * share - size / 2;
  return {low.x, low.y, low.x + size.x, low.y + size.y};
}

}  // namespace

std::optional<Rect> clear_box_on_line(const Vec2& from, const Vec2& to, const Vec2& size,
                                      const SharesOfLine& shares, std::vector<Rect>& before) {
  for (const double share : shares) {
    const Rect box = box_at(from, to, size, share);
    const auto covers = [&](const Rect& other) { return box.overlaps(other); };
    if (std::any_of(before.begin(), before.end(), covers)) continue;
    before.push_back(box);
    return box;
  }
  return std::nullopt;
}

Rect box_on_line(const Vec2& from, const Vec2& to, const Vec2& size, const SharesOfLine& shares,
                 std::vector<Rect>& before) {
  if (const auto box = clear_box_on_line(from, to, size, shares, before)) return *box;
  before.push_back(box_at(from, to, size, shares[0]));
  return before.back();
}

std::string capitalised(std::string text) {
  if (!text.empty() && text[0] >= 'a' && text[0] <= 'z')
    text[0] = static_cast<char>(text[0] - 'a' + 'A');
  return text;
}

std::size_t pairs_of(const std::vector<Team>& teams) { return (count_robots(teams) + 1) / 2; }

DiscSize robot_size(std::size_t teams) {
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

double mark_reach(const DiscSize& size) {
  return static_cast<double>(size.ring) + (size.numbered ? tally_from_ring + tally_length : 2);
}

void draw_small_body(const Painter& painter, const Theme& theme, const DiscSize& size,
                     const Vec2& world) {
  const ImVec2 at = painter.at(world);
  const float radius = size.ring + (size.numbered ? body_beyond_ring : 3);
  painter.list().AddCircleFilled(at, radius, theme.robot.at(0.22f).packed(), 48);
  painter.list().AddCircle(at, radius, theme.robot_ring.at(0.7f).packed(), 48, 1);
}

std::size_t robots_of(const std::vector<Team>& all, std::size_t teams) {
  return all.empty() ? 0 : teams * all.front().robots.size();
}

std::vector<DiscSize> robot_sizes(const CanvasView& view, const std::vector<Team>& all,
                                  std::size_t teams) {
  std::vector<DiscSize> sizes(robots_of(all, teams), robot_size(pairs_of(all)));
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

void draw_robot(const Painter& painter, const Theme& theme, const DiscSize& size, const Vec2& world,
                const RobotLook& look) {
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

namespace {

Rect free_window(const CanvasView& view) {
  const Rect uncovered = view.uncovered();
  return {uncovered.left + 4, uncovered.top + view.layout.caption + 4, uncovered.right - 4,
          uncovered.bottom - 4};
}

Rect about(const Vec2& middle, double reach) {
  return {middle.x - reach, middle.y - reach, middle.x + reach, middle.y + reach};
}

// Of a sized robot, in pixels.
double body_radius(const CanvasView& view) {
  return view.placement->stands->robot().radius * view.camera.scale;
}

// Of the hovered team or candidate. Balanced robots have no chords, and a failed robot leaves its
// partner alone.
std::optional<Chord> pointed_chord(const CanvasView& view) {
  const Pick at = marked_part(view.state);
  const Placement& placement = *view.placement;
  if (is_one_team(placement.settings.method) || view.failure() || at.second != view.second ||
      view.state.view.held.kind != Pick::Kind::none)
    return std::nullopt;
  return chord_of_part(placement, at);
}

}  // namespace

std::optional<Rect> coverage_box(const CanvasView& view) {
  const CoveragePlace& place = view.scene.coverage;
  const bool wanted = shown(view.state).overlays.lifting_base && view.placement->loads;
  if (!wanted || place.room * view.camera.scale < 24) return std::nullopt;
  const Vec2 at = view.camera.to_screen(place.at);
  const ImVec2 text = text_size(Face::verdict, percentage(view.placement->coverage));
  const Rect box{at.x - text.x / 2, at.y - text.y / 2, at.x + text.x / 2, at.y + text.y / 2};
  const Rect window = free_window(view);
  const bool seen =
      window.contains({box.left, box.top}) && window.contains({box.right, box.bottom});
  return seen ? std::optional(box) : std::nullopt;
}

void draw_coverage(const Painter& painter, const CanvasView& view) {
  if (const std::optional<Rect> box = coverage_box(view))
    draw_text(painter.list(), Face::verdict, vec(box->left, box->top), view.theme.hull_text,
              percentage(view.placement->coverage));
}

namespace {

// The edges, and the vertices if they have grips.
void occupy_by_ring(const CanvasView& view, const Points& ring, bool grips, Occupied& occupied) {
  Vec2 last = view.camera.to_screen(ring.back());
  for (const Vec2& vertex : ring) {
    const Vec2 at = view.camera.to_screen(vertex);
    occupied.line(last, at);
    if (grips) occupied.box(about(at, 6));
    last = at;
  }
}

// All marks but the labels of cargo.
Occupied occupied_by_unlabelled(const CanvasView& view, double reach) {
  const Placement& placement = *view.placement;
  Occupied occupied(free_window(view));
  occupied.box(view.layout.tools);
  if (view.layout.wide && !view.state.view.presenting && view.state.session.screen.foot == 0 &&
      view.state.session.screen.window_foot == 0)  // the hint is beside the tools (canvas/hint.cpp)
    occupied.box({view.layout.tools.right, view.layout.tools.top, view.layout.free.right,
                  view.layout.tools.bottom});
  // Temporary cards over the drawing, at their places of the last frame.
  for (const Control& control : controls())
    if (control.card == "tool bar" || control.card == "notice") occupied.box(control.window);
  for (const Team& team : placement.teams) {
    for (const Robot& robot : team.robots)
      occupied.box(about(view.camera.to_screen(robot.point.position), reach));
    for (const Segment& line : joining_lines(team, placement.centre_of_mass))
      occupied.line(view.camera.to_screen(line.from), view.camera.to_screen(line.to));
  }
  for (const PlacedRobot& robot : drawn_bodies(view))
    occupied.disc(view.camera.to_screen(robot.stand), body_radius(view));
  occupied.box(about(view.camera.to_screen(centre_of_mass(view.state)), 12));
  occupy_by_cargo(view, occupied);
  const Points& vertices = placement.vertices();
  const bool grips = placement.object.boundary().size() <= 40 && !view.state.session.screen.embed;
  occupy_by_ring(view, vertices, grips, occupied);
  for (const Points& hole : view.scene.holes) occupy_by_ring(view, hole, grips, occupied);
  const Points& base = placement.lifting_base;
  for (std::size_t i = 0; i < base.size(); ++i)
    occupied.line(view.camera.to_screen(base[i]),
                  view.camera.to_screen(base[i + 1 == base.size() ? 0 : i + 1]));
  if (const std::optional<Rect> coverage = coverage_box(view)) occupied.box(*coverage);
  const Document& document = view.state.work.document();
  if (view.state.view.selected && *view.state.view.selected < count_handles(document))
    occupied.box(about(view.camera.to_screen(place_of(document, *view.state.view.selected)), 14));
  if (view.state.view.tool == Tool::transform) {
    constexpr double reach_of_grip = 10;
    const Rect frame = transform_frame(view.state);
    for (const FrameGrip grip : corner_grips)
      occupied.box(about(grip_place(view.state, frame, grip), reach_of_grip));
    occupied.box(about(grip_place(view.state, frame, FrameGrip::turn), reach_of_grip));
  }
  return occupied;
}

}  // namespace

std::vector<CargoLabel> labels_of_cargo(const CanvasView& view) {
  if (cargo_discs(view).empty()) return {};
  const DiscSize size = robot_size(pairs_of(view.placement->teams));
  Occupied occupied = occupied_by_unlabelled(view, mark_reach(size));
  return cargo_labels(view, occupied);
}

Occupied occupied_by_marks(const CanvasView& view, double reach) {
  Occupied occupied = occupied_by_unlabelled(view, reach);
  for (const CargoLabel& label : labels_of_cargo(view)) occupied.box(label.box);
  return occupied;
}

std::vector<LoadLabel> load_labels(const CanvasView& view, const DiscSize& size,
                                   const Report& report, Occupied& occupied) {
  const Placement& placement = *view.placement;
  const bool carried = report.greatest > 0;
  if (!carried && placement.settings.support_names.empty()) return {};
  const Vec2 middle = view.camera.to_screen(placement.centre_of_mass);
  const bool few = pairs_of(placement.teams) <= 8;
  const std::vector<PlacedRobot> bodies = drawn_bodies(view);
  std::vector<LabelRequest> requests;
  std::vector<std::string> texts;
  std::vector<bool> over;
  std::size_t number = 0;
  for (const Team& team : placement.teams) {
    for (const Robot& robot : team.robots) {
      const std::string_view name = placement.name_of(number);
      const LoadRange load = carried ? report.loads[number] : LoadRange{};
      ++number;
      const bool failed = view.failure() && view.failure()->robot + 1 == number;
      const Vec2 lifts = view.camera.to_screen(robot.point.position);
      if (failed || !view.window.contains(lifts) || (!carried && name.empty())) continue;
      const bool body = !bodies.empty();
      const Vec2 at = body ? view.camera.to_screen(bodies[number - 1].stand) : lifts;
      const Vec2 away = at - middle;
      texts.push_back(robot_label(name, carried ? load_in_words(report.model, load, report.greatest,
                                                                shown(view.state).units)
                                                : std::string()));
      over.push_back(carried && view.overloads(number - 1, load.greatest));
      const ImVec2 text = text_size(Face::strong_label, texts.back());
      requests.push_back({at, away / std::max(length(away), 1e-9), Vec2(text.x + 12, text.y + 6),
                          body ? body_radius(view) + 4 : 0});
    }
  }
  // Among few lines, a label may cross one; among many, only labels that fit appear.
  const auto places = place_labels(requests, occupied, mark_reach(size) + 2, few ? 60 : 8);
  std::vector<LoadLabel> labels;
  for (std::size_t i = 0; i < places.size(); ++i)
    if (places[i]) labels.push_back({*places[i], std::move(texts[i]), over[i]});
  return labels;
}

std::vector<LoadLabel> planned_load_labels(const CanvasView& view, const DiscSize& size) {
  const Placement& placement = *view.placement;
  Report report;
  report.loads = loads_by(LoadModel::plan, placement, std::nullopt);
  report.greatest = placement.loads->max;
  Occupied occupied = occupied_by_marks(view, mark_reach(size));
  return load_labels(view, size, report, occupied);
}

void draw_loads(const Painter& painter, const CanvasView& view,
                const std::vector<LoadLabel>& labels) {
  for (const auto& [box, text, over] : labels) {
    painter.list().AddRectFilled(vec(box.left, box.top), vec(box.right, box.bottom),
                                 view.theme.panel.at(0.88f).packed(), 6);
    draw_text(painter.list(), Face::strong_label, vec(box.left + 6, box.top + 3),
              over ? view.theme.amber : view.theme.text, text);
  }
}

void draw_ratio(const Painter& painter, const CanvasView& view) {
  const std::optional<Chord> chord = pointed_chord(view);
  if (!chord) return;
  // In the middle of the longer arm.
  const Vec2 &c = view.placement->centre_of_mass,
             &end = (chord->arm1 > chord->arm2 ? chord->r1 : chord->r2).position,
             arm = view.camera.to_screen(end) - view.camera.to_screen(c);
  if (length(arm) < 90) return;
  constexpr SharesOfLine about_middle = {0.5, 0.6, 0.4, 0.7, 0.3, 0.8};
  const std::string text = ratio_in_words(chord->ratio);
  const ImVec2 size = text_size(Face::strong_label, text);
  std::vector<Rect> covered;
  if (const std::optional<Rect> coverage = coverage_box(view)) covered.push_back(*coverage);
  for (const Control& control : controls())
    if (control.card == "why here") covered.push_back(control.window);
  const auto place = clear_box_on_line(view.camera.to_screen(c), view.camera.to_screen(end),
                                       Vec2(size.x + 10, size.y + 4), about_middle, covered);
  if (!place) return;
  const ImVec2 low = vec(place->left, place->top);
  painter.list().AddRectFilled(low, vec(place->right, place->bottom),
                               view.theme.panel.at(0.9f).packed(), 5);
  draw_text(painter.list(), Face::strong_label, ImVec2(low.x + 5, low.y + 2), view.theme.text,
            text);
}

void draw_robots(const Painter& painter, const CanvasView& view) {
  const Placement& placement = *view.placement;
  if (placement.teams.empty()) return;
  if (placement.teams.size() > most_single_robots)
    return draw_swarm(painter, view, placement.teams.size());
  const Report& report = view.report();
  const std::vector<DiscSize> sizes = robot_sizes(view, placement.teams, placement.teams.size());
  const bool at_rest = view.scene.progress >= 1;
  if (pairs_of(placement.teams) <= most_labelled && at_rest) {
    const DiscSize size = robot_size(pairs_of(placement.teams));
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
    DiscSize size = sizes[robot];
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
                 {placement.number_of(number), paired ? i + 1 : 0, at - placement.centre_of_mass,
                  report.greatest > 0 ? load / report.greatest : 0, view.overloads(number, load),
                  view.failure() && view.failure()->robot == number, is_marked(number),
                  robot.point.edge == beneath});
      ++number;
    }
  }
}

}  // namespace evenlift::view
