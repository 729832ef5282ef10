#include "marks/marks.h"

#include <algorithm>
#include <numeric>
#include <optional>

#include "evenlift/plane.h"
#include "evenlift/wording.h"
#include "tools/picture_marks.h"
#include "ui/theme.h"

namespace evenlift::view {
namespace {

bool contains(const Rect& box, const Vec2& at, double more) {
  return Rect{box.left - more, box.top - more, box.right + more, box.bottom + more}.contains(at);
}

Vec2 middle_of(const Points& points) {
  return std::accumulate(points.begin(), points.end(), Vec2(0, 0)) /
         static_cast<double>(points.size());
}

bool is_in_hole(const CanvasView& view, const Vec2& world) {
  return std::any_of(view.scene.holes.begin(), view.scene.holes.end(),
                     [&](const Points& ring) { return inside(ring, world); });
}

Vec2 centre_on_screen(const CanvasView& view) {
  return view.camera.to_screen(view.placement->centre_of_mass);
}

bool is_area(PictureMark mark) { return mark > PictureMark::coverage; }

// The convex region that contains the area.
const Points& region_of(const Placement& placement, PictureMark mark) {
  return mark == PictureMark::clockwise          ? placement.closure.clockwise.clipped
         : mark == PictureMark::counterclockwise ? placement.closure.counterclockwise.clipped
                                                 : placement.lifting_base;
}

// Of an area; `world` is a place in the polygon's coordinates.
bool is_in_area(const CanvasView& view, PictureMark mark, const Vec2& world) {
  const bool within = inside(view.placement->vertices(), world);
  return inside(region_of(*view.placement, mark), world) &&
         (mark != PictureMark::base || (within && !is_in_hole(view, world))) &&
         (mark != PictureMark::base_beyond || !within);
}

bool is_at(const CanvasView& view, PictureMark mark, const Vec2& at) {
  constexpr double robot = 16, disc = 12, arrow = 8;
  if (is_area(mark)) return is_in_area(view, mark, view.camera.to_world(at));
  const Vec2 centre = centre_on_screen(view);
  if (mark == PictureMark::centre) return length(centre - at) <= disc;
  if (mark == PictureMark::triangle)
    return contains({centre.x - 9, centre.y + 11, centre.x + 9, centre.y + 26}, at, 3);
  if (mark == PictureMark::slide) {
    const Segment slide = slide_arrow(view);
    return length(nearest_on_segment(slide.from, slide.to, at) - at) <= arrow;
  }
  if (mark == PictureMark::coverage) {
    const std::optional<Rect> box = coverage_box(view);
    return box && contains(*box, at, 2);
  }
  const std::vector<LiftingPoint> robots = lifting_points(view.placement->teams);
  return std::any_of(robots.begin(), robots.end(), [&](const LiftingPoint& each) {
    return length(view.camera.to_screen(each.position) - at) <= robot;
  });
}

// A visible place of the area, in pixels: in the middle of what is visible of its region or, if that
// is another area, towards one of its sides.
std::optional<Vec2> place_in_area(const CanvasView& view, PictureMark mark) {
  const Rect window = view.uncovered();
  Points seen;
  for (const Vec2& corner : region_of(*view.placement, mark))
    seen.push_back(view.camera.to_screen(corner));
  if (seen.size() < 3) return std::nullopt;
  seen = clip(std::move(seen), {Vec2(window.left, window.top), Vec2(window.right, window.bottom)});
  if (seen.empty()) return std::nullopt;
  const Vec2 middle = middle_of(seen);
  for (const double share : {0.0, 0.9, 0.6, 0.3})
    for (std::size_t i = 0; i < seen.size(); ++i) {
      const Vec2 side = (seen[i] + seen[(i + 1) % seen.size()]) / 2,
                 at = middle + share * (side - middle);
      if (is_at(view, mark, at)) return at;
    }
  return std::nullopt;
}

// Where a key explains the mark, in pixels; nothing if it has no place.
std::optional<Vec2> place_of_mark(const CanvasView& view, PictureMark mark) {
  if (is_area(mark)) return place_in_area(view, mark);
  if (mark == PictureMark::centre) return centre_on_screen(view);
  if (mark == PictureMark::triangle) return centre_on_screen(view) + Vec2(0, 20);
  if (mark == PictureMark::slide) return slide_arrow(view).to;
  if (mark == PictureMark::coverage) {
    const std::optional<Rect> box = coverage_box(view);
    return box ? std::optional(box->middle()) : std::nullopt;
  }
  return view.camera.to_screen(view.placement->teams.front().robots.front().point.position);
}

// Below the place or, for a finger, above it.
void draw_words(ImDrawList& list, const CanvasView& view, const Vec2& at,
                const std::string& words) {
  constexpr float widest = 300, pad = 10;
  const Rect window = view.uncovered();
  const float room = std::min(widest, static_cast<float>(window.width()) - 2 * pad - 16);
  const ImVec2 text = text_size(Face::label, words, room);
  const double width = static_cast<double>(text.x) + 2 * pad,
               height = static_cast<double>(text.y) + 2 * pad;
  const double left = std::clamp(at.x - width / 2, window.left + 8,
                                 std::max(window.left + 8, window.right - width - 8));
  const bool above = view.state.session.screen.touch || at.y + 22 + height > window.bottom;
  const double top = std::max(window.top + 4, above ? at.y - height - 40 : at.y + 22);
  const ImVec2 low = vec(left, top), high = vec(left + width, top + height);
  list.AddRectFilled(low, high, view.theme.panel.packed(), 8);
  list.AddRect(low, high, view.theme.quiet.packed(), 8, 0, 1);
  draw_text(list, Face::label, ImVec2(low.x + pad, low.y + pad), view.theme.text, words, room);
}

const Rect& first_window(const CanvasView& view) {
  return view.state.work.second_method ? view.layout.first : view.window;
}

}  // namespace

// Parts of the drawing, such as a vertex or a chord, are above areas.
std::optional<PictureMark> rested_mark(const CanvasView& view) {
  const AppState& state = view.state;
  const Vec2 at(ImGui::GetIO().MousePos.x, ImGui::GetIO().MousePos.y);
  if (view.second || !view.current() || !state.session.screen.asking ||
      ImGui::GetIO().WantCaptureMouse || state.derived().explanation || state.work.edit_open ||
      state.view.tool != Tool::parts || walkthrough_is_open(state) || state.view.explained ||
      !first_window(view).contains(at))
    return std::nullopt;
  const Pick::Kind over = state.view.hover.kind;
  const bool on_part =
      over != Pick::Kind::none && over != Pick::Kind::object && over != Pick::Kind::ground;
  const std::vector<PictureMark> marks = marks_in_picture(state);
  const auto found = std::find_if(marks.begin(), marks.end(), [&](PictureMark mark) {
    return !(on_part && mark >= PictureMark::coverage) && is_at(view, mark, at);
  });
  return found == marks.end() ? std::nullopt : std::optional(*found);
}

void draw_explained(ImDrawList& list, const CanvasView& first) {
  const AppState& state = first.state;
  CanvasView view = first;
  view.window = first_window(first);
  if (const std::optional<PictureMark> mark = explained_mark(state)) {
    const std::optional<Vec2> at = place_of_mark(view, *mark);
    if (at) list.AddCircle(vec(at->x, at->y), 14, view.theme.accent_on_object.packed(), 32, 2);
    return draw_words(list, view, at.value_or(view.uncovered().middle()),
                      mark_in_words(state, *mark));
  }
  const Vec2 pointer(ImGui::GetIO().MousePos.x, ImGui::GetIO().MousePos.y);
  if (const auto mark = rested_mark(view))
    draw_words(list, view, pointer, mark_in_words(state, *mark));
}

}  // namespace evenlift::view
