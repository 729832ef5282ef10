#include "tools/transform.h"

#include <algorithm>
#include <cmath>

#include "evenlift/angles.h"
#include "evenlift/plane.h"
#include "state/layout.h"
#include "tools/drawing.h"
#include "tools/pick.h"

namespace evenlift::view {
namespace {

// The centroid, which stays in place through any number of turns.
Vec2 pivot(const Points& polygon) {
  const std::optional<Vec2> centroid = centroid_of(polygon);
  return centroid ? *centroid : bounding_box(polygon).middle();
}

template <class Map>
SetPolygon mapped(const PolygonGrip& grip, Map map) {
  SetPolygon polygon{grip};
  PolygonGrip& shape = polygon.shape;
  for (Vec2& p : shape.vertices) p = map(p);
  for (Points& hole : shape.holes)
    for (Vec2& p : hole) p = map(p);
  for (Cargo& item : shape.cargo) item.at = map(item.at);
  for (Vec2& support : shape.supports) support = map(support);
  if (shape.centre_of_mass) shape.centre_of_mass = map(*shape.centre_of_mass);
  return polygon;
}

SetPolygon moved(const AppState& state, const PolygonGrip& grip, const Vec2& by) {
  return mapped(grip, [&](const Vec2& p) { return rounded_finely(state.view.camera, p + by); });
}

// `turn` is (cos, sin) of the angle, counter-clockwise.
SetPolygon turned(const AppState& state, const PolygonGrip& grip, const Vec2& turn) {
  const Vec2 about = pivot(grip.vertices);
  return mapped(grip, [&](const Vec2& p) {
    const Vec2 d = p - about;
    const Vec2 to(d.x * turn.x - d.y * turn.y, d.x * turn.y + d.y * turn.x);
    return rounded_finely(state.view.camera, about + to);
  });
}

SetPolygon scaled(const AppState& state, const PolygonGrip& grip, const Vec2& about,
                  double factor) {
  return mapped(grip, [&](const Vec2& p) {
    return rounded_finely(state.view.camera, about + (p - about) * factor);
  });
}

constexpr double gap_to_frame = 30;  // pixels from polygon to frame

Vec2 knob_place(const AppState& state, const Rect& frame) {
  constexpr double stalk = 28;
  const Layout places = layout(state);
  // On a wide screen, layout() keeps room for the knob above the picture, unless a caption is
  // there.
  const bool has_room = places.wide && places.caption == 0;
  const double top = places.first.top + places.caption - (has_room ? stalk : 0),
               x = frame.middle().x;
  if (frame.top - stalk >= top) return {x, frame.top - stalk};
  if (frame.bottom + stalk <= places.first.bottom) return {x, frame.bottom + stalk};
  return {x, std::max(top, frame.top) + stalk};
}

PolygonGrip now(const AppState& state) { return grip_of(state.work.document()); }

Vec2 opposite_corner(const Box& box, FrameGrip grip) {
  const bool at_left = grip == FrameGrip::low_left || grip == FrameGrip::high_left;
  const bool below = grip == FrameGrip::low_left || grip == FrameGrip::low_right;
  return {at_left ? box.high.x : box.low.x, below ? box.high.y : box.low.y};
}

}  // namespace

Rect transform_frame(const AppState& state) {
  const Box box = bounding_box(state.work.document().vertices);
  const Vec2 a = state.view.camera.to_screen(box.low), b = state.view.camera.to_screen(box.high);
  return {a.x - gap_to_frame, b.y - gap_to_frame, b.x + gap_to_frame, a.y + gap_to_frame};
}

Transformed since_grip(const AppState& state) {
  const Points &before = state.view.grip.vertices, &after = state.work.document().vertices;
  if (before.empty() || before.size() != after.size()) return {};
  const Vec2 a = pivot(before), b = pivot(after);
  std::size_t farthest = 0;
  for (std::size_t i = 0; i < before.size(); ++i)
    if (length(before[i] - a) > length(before[farthest] - a)) farthest = i;
  const Vec2 from = before[farthest] - a, to = after[farthest] - b;
  const Edge turn = edge_between({0, 0}, {dot(from, to), cross(from, to)});
  return {turn.degrees, length(to) / std::max(length(from), 1e-300)};
}

Points turned_frame(const AppState& state) {
  const Box box = bounding_box(state.view.grip.vertices);
  const Vec2 about = state.view.camera.to_screen(pivot(state.view.grip.vertices)),
             low = state.view.camera.to_screen(box.low),
             high = state.view.camera.to_screen(box.high);
  const double angle = since_grip(state).degrees * pi / 180, c = std::cos(angle),
               s = std::sin(angle);
  Points corners{{low.x - gap_to_frame, high.y - gap_to_frame},
                 {high.x + gap_to_frame, high.y - gap_to_frame},
                 {high.x + gap_to_frame, low.y + gap_to_frame},
                 {low.x - gap_to_frame, low.y + gap_to_frame}};
  for (Vec2& corner : corners) {
    const Vec2 d = corner - about;  // y points down, so the direction is reversed
    corner = about + Vec2(d.x * c + d.y * s, d.y * c - d.x * s);
  }
  return corners;
}

Vec2 grip_place(const AppState& state, const Rect& frame, FrameGrip grip) {
  switch (grip) {
    case FrameGrip::low_left:
      return {frame.left, frame.bottom};
    case FrameGrip::low_right:
      return {frame.right, frame.bottom};
    case FrameGrip::high_left:
      return {frame.left, frame.top};
    case FrameGrip::high_right:
      return {frame.right, frame.top};
    case FrameGrip::turn:
      return knob_place(state, frame);
    case FrameGrip::inside:
      break;
  }
  return frame.middle();
}

std::optional<FrameGrip> grip_at(const AppState& state, const Vec2& screen) {
  const Rect frame = transform_frame(state);
  double reach = state.session.screen.touch ? 24.0 : 12.0;
  std::optional<FrameGrip> nearest;
  for (const FrameGrip grip : {FrameGrip::low_left, FrameGrip::low_right, FrameGrip::high_left,
                               FrameGrip::high_right, FrameGrip::turn}) {
    const double away = length(grip_place(state, frame, grip) - screen);
    if (away > reach) continue;
    reach = away;
    nearest = grip;
  }
  if (!nearest && frame.contains(screen)) nearest = FrameGrip::inside;
  return nearest;
}

SetPolygon dragged_polygon(const AppState& state, FrameGrip held, const Vec2& from,
                           const Vec2& to) {
  const PolygonGrip& grip = state.view.grip;
  const Box box = bounding_box(grip.vertices);
  SetPolygon polygon;
  if (held == FrameGrip::inside) {
    Vec2 by = state.view.camera.to_world(to) - state.view.camera.to_world(from);
    if (state.view.snap.grid) by = nearest_dot(state.view.camera, box.low + by) - box.low;
    polygon = moved(state, grip, by);
  } else if (held == FrameGrip::turn) {
    const Vec2 about = state.view.camera.to_screen(pivot(grip.vertices));
    const Vec2 a = from - about, b = to - about;
    const double lengths = length(a) * length(b);
    // The direction is also reversed here.
    const Vec2 turn = lengths > 0 ? Vec2(Vec2(dot(a, b), -cross(a, b)) / lengths) : Vec2(1, 0);
    polygon = turned(state, grip, turn);
  } else {
    const Vec2 about = opposite_corner(box, held), corner = state.view.camera.to_screen(about);
    const Vec2 full_way = from - corner;
    const double share = dot(to - corner, full_way) / std::max(dot(full_way, full_way), 1e-9);
    polygon = scaled(state, grip, about, std::clamp(share, 0.02, 50.0));
  }
  polygon.live = true;
  return polygon;
}

SetPolygon moved_polygon(const AppState& state, int dots_x, int dots_y) {
  const double step = grid_step(state.view.camera);
  return moved(state, now(state), Vec2(step * dots_x, step * dots_y));
}

SetPolygon turned_polygon(const AppState& state, int steps) {
  // cos and sin of 15°
  const double c = (std::sqrt(6.0) + std::sqrt(2.0)) / 4, s = (std::sqrt(6.0) - std::sqrt(2.0)) / 4;
  return turned(state, now(state), Vec2(c, steps < 0 ? -s : s));
}

SetPolygon scaled_polygon(const AppState& state, double factor) {
  const PolygonGrip grip = now(state);
  return scaled(state, grip, pivot(grip.vertices), factor);
}

}  // namespace evenlift::view
