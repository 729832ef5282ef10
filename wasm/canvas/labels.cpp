#include "canvas/labels.h"

#include <algorithm>
#include <cmath>

#include "evenlift/plane.h"

namespace evenlift::view {
namespace {

bool overlap(const Rect& a, const Rect& b) {
  return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
}

Rect around(const Vec2& middle, const Vec2& size) {
  return {middle.x() - size.x() / 2, middle.y() - size.y() / 2, middle.x() + size.x() / 2,
          middle.y() + size.y() / 2};
}

Vec2 turned(const Vec2& v, double degrees) {
  const double a = degrees * 3.14159265358979 / 180, c = std::cos(a), s = std::sin(a);
  return {v.x() * c - v.y() * s, v.x() * s + v.y() * c};
}

// The middle of a box of `size` that lies in direction `u` and just clears a disc of radius
// `reach`.
Vec2 beside(const Vec2& robot, const Vec2& u, const Vec2& size, double reach) {
  const double x = std::abs(u.x()) * size.x() / 2, y = std::abs(u.y()) * size.y() / 2;
  return robot + u * (reach + x + y);
}

bool inside_convex(const Points& hull, const Vec2& p) {
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Vec2 &a = hull[i], &b = hull[i + 1 == hull.size() ? 0 : i + 1];
    if (cross(b - a, p - a) < 0) return false;
  }
  return true;
}

double away(const Vec2& a, const Vec2& b, const Vec2& p) {
  return length(p - nearest_on_segment(a, b, p));
}

// The room about p: its distance to what the number must not cover; 0 outside of the object or
// base.
double clearance(const Placement& placement, const Vec2& p) {
  if (!inside_convex(placement.lifting_base, p) || !inside(placement.vertices, p)) return 0;
  double room = length(p - placement.centre_of_mass);
  for (std::size_t i = 0; i < placement.lifting_base.size(); ++i) {
    const std::size_t next = i + 1 == placement.lifting_base.size() ? 0 : i + 1;
    room = std::min(room, away(placement.lifting_base[i], placement.lifting_base[next], p));
  }
  for (const Team& team : placement.teams) {
    room = std::min(room, away(team.chord.r1.position, team.chord.r2.position, p));
  }
  const Points& vertices = placement.vertices;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    room = std::min(room, away(vertices[i], vertices[i + 1 == vertices.size() ? 0 : i + 1], p));
  }
  return room;
}

}  // namespace

std::vector<std::optional<Rect>> place_labels(const std::vector<LabelRequest>& requests,
                                              const Rect& window, const Rect& covered,
                                              double reach) {
  std::vector<std::optional<Rect>> places(requests.size());
  const Vec2 robot_size(2 * reach, 2 * reach);
  constexpr double turns[] = {0, 40, -40, 80, -80, 120, -120, 180};
  for (std::size_t i = 0; i < requests.size(); ++i) {
    const LabelRequest& request = requests[i];
    if (!window.contains(request.robot)) continue;
    for (double turn : turns) {
      const Rect box = around(
          beside(request.robot, turned(request.outward, turn), request.size, reach), request.size);
      bool free = box.left > window.left && box.right < window.right && box.top > window.top &&
                  box.bottom < window.bottom && !overlap(box, covered);
      for (std::size_t j = 0; j < requests.size() && free; ++j) {
        free = j == i || !overlap(box, around(requests[j].robot, robot_size));
        if (free && j < i && places[j]) free = !overlap(box, *places[j]);
      }
      if (!free) continue;
      places[i] = box;
      break;
    }
  }
  return places;
}

CoveragePlace place_coverage(const Placement& placement, const Vec2& before) {
  // With more than this there is no room for a number anyway, and the search would take long.
  if (placement.lifting_base.size() < 3 || placement.teams.size() > 40 ||
      placement.vertices.size() > 400)
    return {};
  const Box box = bounding_box(placement.lifting_base);
  CoveragePlace best{before, clearance(placement, before)};
  double to_beat = best.room * 1.3;
  constexpr int steps = 28;
  for (int i = 1; i < steps; ++i) {
    for (int j = 1; j < steps; ++j) {
      const Vec2 p(box.low.x() + box.size().x() * i / steps,
                   box.low.y() + box.size().y() * j / steps);
      const double room = clearance(placement, p);
      if (room > to_beat) {
        to_beat = room;
        best = {p, room};
      }
    }
  }
  return best;
}

}  // namespace evenlift::view
