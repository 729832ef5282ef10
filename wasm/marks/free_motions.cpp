#include "marks/free_motions.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>

#include "evenlift/plane.h"
#include "ui/vec.h"

namespace evenlift::view {
namespace {

// An arrow's meaning, in direction `along` from the point.
void draw_name(const Painter& painter, const CanvasView& view, const Vec2& at, const Vec2& along,
               Colour colour, const std::string& name, Occupied& occupied) {
  const ImVec2 text = text_size(Face::strong_label, name);
  const auto place = place_labels({{at, along, Vec2(text.x + 12, text.y + 6)}}, occupied, 4, 60)[0];
  if (!place) return;
  ImDrawList& list = painter.list();
  list.AddRectFilled(vec(place->left, place->top), vec(place->right, place->bottom),
                     view.theme.panel.at(0.88f).packed(), 6);
  draw_text(list, Face::strong_label, vec(place->left + 6, place->top + 3), colour, name);
}

// A load may cross a chord, but must not hide an arrow.
void keep_clear(const Segment& arrow, Occupied& occupied) {
  for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0})
    occupied.disc(arrow.from + share * (arrow.to - arrow.from), 6);
}

// From the window's middle to the nearest point of a convex region, in pixels; nothing if part of
// it is visible.
std::optional<Vec2> way_out_of_sight(const CanvasView& view, const Rect& window,
                                     const Points& region) {
  Points seen;
  for (const Vec2& corner : region) seen.push_back(view.camera.to_screen(corner));
  const Vec2 middle = window.middle();
  Vec2 way = seen.front() - middle;
  for (std::size_t i = 0, j = seen.size() - 1; i < seen.size(); j = i++) {
    const Vec2 other = nearest_on_segment(seen[j], seen[i], middle) - middle;
    if (length(other) < length(way)) way = other;
  }
  const Box box{Vec2(window.left, window.top), Vec2(window.right, window.bottom)};
  return clip(std::move(seen), box).empty() ? std::optional(way) : std::nullopt;
}

// Also clear of the view tools, which are at the foot or, on a phone, at the right.
Rect without_tools(const CanvasView& view) {
  Rect window = view.uncovered();
  const Rect& tools = view.layout.tools;
  if (view.layout.wide)
    window.bottom = std::min(window.bottom, tools.top);
  else
    window.right = std::min(window.right, tools.left);
  return window;
}

// An arrow at the window's edge to a region beyond it, if there is room.
std::optional<Segment> arrow_to_region(const CanvasView& view, const Rect& window,
                                       const Points& region) {
  constexpr double from_edge = 22, arrow = 44;
  const std::optional<Vec2> way =
      region.empty() ? std::nullopt : way_out_of_sight(view, window, region);
  const Vec2 room(window.width() / 2 - from_edge, window.height() / 2 - from_edge);
  if (!way || !(room.x > arrow) || !(room.y > arrow)) return std::nullopt;
  // To the edge of the available area, on the way to the region.
  const double share = std::min(room.x / std::max(std::abs(way->x), 1e-9),
                                room.y / std::max(std::abs(way->y), 1e-9));
  const Vec2 head = window.middle() + share * *way;
  return Segment{head - arrow * *way / length(*way), head};
}

void draw_far_region(const Painter& painter, const CanvasView& view, const Points& region,
                     Colour colour, const std::string& name, Occupied* occupied) {
  std::optional<Segment> arrow = arrow_to_region(view, view.uncovered(), region);
  const Rect& tools = view.layout.tools;
  if (arrow && (tools.contains(arrow->to) || tools.contains(arrow->from)))
    arrow = arrow_to_region(view, without_tools(view), region);
  if (!arrow) return;
  painter.arrow(arrow->from, arrow->to, view.theme.ground, 7);
  painter.arrow(arrow->from, arrow->to, colour, 3);
  if (!occupied) return;
  occupied->line(arrow->from, arrow->to);
  const Vec2 back = (arrow->from - arrow->to) / length(arrow->to - arrow->from);
  draw_name(painter, view, arrow->from, back, colour, name, *occupied);
  keep_clear(*arrow, *occupied);
}

}  // namespace

void draw_slide(const Painter& painter, const CanvasView& view, Occupied* occupied) {
  const Closure& closure = view.placement->closure;
  if (!closure.translation_free || !closure.translation || view.placement->teams.empty()) return;
  const Vec2 from = view.camera.to_screen(view.placement->centre_of_mass);
  const Vec2 along(closure.translation->x, -closure.translation->y);
  const Vec2 tail = from + along * 16, head = from + along * 62;
  painter.arrow(tail, head, view.theme.object, 7);
  painter.arrow(tail, head, view.theme.amber_on_object, 3);
  if (!occupied) return;
  occupied->line(tail, head);
  draw_name(painter, view, head, along, view.theme.amber, "slides", *occupied);
  keep_clear({tail, head}, *occupied);
}

void draw_far_regions(const Painter& painter, const CanvasView& view, Occupied* occupied) {
  const Closure& closure = view.placement->closure;
  if (!closure.margin || view.placement->teams.empty()) return;
  const Overlays& overlays = shown(view.state).overlays;
  if (overlays.clockwise)
    draw_far_region(painter, view, closure.clockwise.clipped, view.theme.clockwise_line,
                    "turns clockwise, far out", occupied);
  if (overlays.counterclockwise)
    draw_far_region(painter, view, closure.counterclockwise.clipped, view.theme.counter_line,
                    "turns counter-clockwise, far out", occupied);
}

}  // namespace evenlift::view
