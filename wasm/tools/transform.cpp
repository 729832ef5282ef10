#include "tools/transform.h"

#include <algorithm>
#include <cmath>

#include "evenlift/plane.h"

namespace evenlift::view {
namespace {

// The polygon turns about its centroid, which stays in its place however often it turns.
Vec2 pivot(const Points& polygon) {
  Vec2 sum = Vec2::Zero();
  double twice = 0;
  const Vec2 origin = polygon.front();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 a = polygon[i] - origin, b = polygon[i + 1 == polygon.size() ? 0 : i + 1] - origin;
    twice += cross(a, b);
    sum += (a + b) * cross(a, b);
  }
  const Box box = bounding_box(polygon);
  if (twice == 0) return box.middle();
  return origin + sum / (3 * twice);
}

// The polygon as it was when it was taken hold of, with every point mapped.
template <class Map>
SetPolygon mapped(const PolygonGrip& grip, Map map) {
  SetPolygon polygon;
  polygon.vertices.reserve(grip.vertices.size());
  for (const Vec2& p : grip.vertices) polygon.vertices.push_back(map(p));
  if (grip.centre_of_mass) polygon.centre_of_mass = map(*grip.centre_of_mass);
  return polygon;
}

SetPolygon moved(const AppState& state, const PolygonGrip& grip, const Vec2& by) {
  return mapped(grip, [&](const Vec2& p) { return rounded_finely(state.camera, p + by); });
}

// `turn` is (cos, sin) of the angle, counter-clockwise.
SetPolygon turned(const AppState& state, const PolygonGrip& grip, const Vec2& turn) {
  const Vec2 about = pivot(grip.vertices);
  return mapped(grip, [&](const Vec2& p) {
    const Vec2 d = p - about;
    const Vec2 to(d.x() * turn.x() - d.y() * turn.y(), d.x() * turn.y() + d.y() * turn.x());
    return rounded_finely(state.camera, about + to);
  });
}

SetPolygon scaled(const AppState& state, const PolygonGrip& grip, const Vec2& about,
                  double factor) {
  return mapped(grip, [&](const Vec2& p) {
    return rounded_finely(state.camera, about + (p - about) * factor);
  });
}

PolygonGrip now(const AppState& state) {
  return {state.document.vertices, state.document.centre_of_mass};
}

Vec2 opposite_corner(const Box& box, FrameGrip grip) {
  const bool at_left = grip == FrameGrip::low_left || grip == FrameGrip::high_left;
  const bool below = grip == FrameGrip::low_left || grip == FrameGrip::low_right;
  return {at_left ? box.high.x() : box.low.x(), below ? box.high.y() : box.low.y()};
}

}  // namespace

Rect transform_frame(const AppState& state) {
  const Box box = bounding_box(state.document.vertices);
  const Vec2 a = state.camera.to_screen(box.low), b = state.camera.to_screen(box.high);
  constexpr double beyond = 30;
  return {a.x() - beyond, b.y() - beyond, b.x() + beyond, a.y() + beyond};
}

Vec2 grip_place(const Rect& frame, FrameGrip grip) {
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
      return {frame.middle().x(), frame.top - 28};
    case FrameGrip::inside:
      break;
  }
  return frame.middle();
}

std::optional<FrameGrip> grip_at(const AppState& state, const Vec2& screen) {
  const Rect frame = transform_frame(state);
  double reach = state.screen.touch ? 24.0 : 12.0;
  std::optional<FrameGrip> nearest;
  for (const FrameGrip grip : {FrameGrip::low_left, FrameGrip::low_right, FrameGrip::high_left,
                               FrameGrip::high_right, FrameGrip::turn}) {
    const double away = length(grip_place(frame, grip) - screen);
    if (away > reach) continue;
    reach = away;
    nearest = grip;
  }
  if (!nearest && frame.contains(screen)) nearest = FrameGrip::inside;
  return nearest;
}

SetPolygon dragged_polygon(const AppState& state, FrameGrip held, const Vec2& from,
                           const Vec2& to) {
  const PolygonGrip& grip = state.grip;
  const Box box = bounding_box(grip.vertices);
  SetPolygon polygon;
  if (held == FrameGrip::inside) {
    Vec2 by = state.camera.to_world(to) - state.camera.to_world(from);
    if (state.snap.grid) by = nearest_dot(state.camera, box.low + by) - box.low;
    polygon = moved(state, grip, by);
  } else if (held == FrameGrip::turn) {
    const Vec2 about = state.camera.to_screen(pivot(grip.vertices));
    const Vec2 a = from - about, b = to - about;
    const double lengths = length(a) * length(b);
    // On the screen y points down, so the sense is reversed.
    const Vec2 turn = lengths > 0 ? Vec2(Vec2(dot(a, b), -cross(a, b)) / lengths) : Vec2(1, 0);
    polygon = turned(state, grip, turn);
  } else {
    const Vec2 about = opposite_corner(box, held), corner = state.camera.to_screen(about);
    const Vec2 full_way = from - corner;
    const double share = dot(to - corner, full_way) / std::max(dot(full_way, full_way), 1e-9);
    polygon = scaled(state, grip, about, std::clamp(share, 0.02, 50.0));
  }
  polygon.live = true;
  return polygon;
}

SetPolygon moved_polygon(const AppState& state, int dots_x, int dots_y) {
  const double step = grid_step(state.camera);
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
