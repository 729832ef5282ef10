#include "marks/load_labels.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "evenlift/output/picture.h"
#include "evenlift/output/words.h"
#include "marks/boxed_text.h"
#include "marks/stands.h"
#include "tools/handles.h"
#include "tools/pick.h"
#include "tools/transform.h"
#include "ui/controls.h"
#include "ui/vec.h"

namespace evenlift::view {
namespace {

Rect free_window(const CanvasView& view) {
  const Rect uncovered = view.uncovered();
  return {uncovered.left + 4, uncovered.top + view.layout.caption + 4, uncovered.right - 4,
          uncovered.bottom - 4};
}

// In pixels; nothing if the text is hidden or has no room.
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
  const RobotSize size = robot_size(pairs_of(view.placement->teams));
  Occupied occupied = occupied_by_unlabelled(view, mark_reach(size));
  return cargo_labels(view, occupied);
}

Occupied occupied_by_marks(const CanvasView& view, double reach) {
  Occupied occupied = occupied_by_unlabelled(view, reach);
  for (const CargoLabel& label : labels_of_cargo(view)) occupied.box(label.box);
  return occupied;
}

std::vector<LoadLabel> load_labels(const CanvasView& view, const RobotSize& size,
                                   const Report& report, Occupied& occupied) {
  if (report.greatest == 0) return {};
  const Placement& placement = *view.placement;
  const Vec2 middle = view.camera.to_screen(placement.centre_of_mass);
  const bool few = pairs_of(placement.teams) <= 8;
  const std::vector<PlacedRobot> bodies = drawn_bodies(view);
  std::vector<LabelRequest> requests;
  std::vector<std::string> texts;
  std::vector<bool> over;
  std::size_t number = 0;
  for (const Team& team : placement.teams) {
    for (const Robot& robot : team.robots) {
      const LoadRange& load = report.loads[number++];
      const bool failed = view.failure() && view.failure()->robot + 1 == number;
      const Vec2 lifts = view.camera.to_screen(robot.point.position);
      if (failed || !view.window.contains(lifts)) continue;
      const bool body = !bodies.empty();
      const Vec2 at = body ? view.camera.to_screen(bodies[number - 1].stand) : lifts;
      const Vec2 away = at - middle;
      texts.push_back(load_in_words(report.model, load, report.greatest, shown(view.state).units));
      over.push_back(view.overloads(number - 1, load.greatest));
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

std::vector<LoadLabel> planned_load_labels(const CanvasView& view, const RobotSize& size) {
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

}  // namespace evenlift::view
