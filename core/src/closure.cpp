#include "evenlift/closure.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "clip.h"
#include "evenlift/hull.h"
#include "evenlift/predicates.h"
#include "evenlift/tolerance.h"
#include "half_planes.h"
#include "wrench_margin.h"

namespace evenlift {
namespace {

// Half the side of the square about C that regions are clipped to, in units of L.
constexpr double square_half_side = 100;

enum class Sense { counterclockwise, clockwise };

// The object and its contacts, with each contact's edge directed so that the interior is on its left:
// the inward normal is the edge's direction turned by +90 degrees.
struct Grasp {
  struct Touch {
    Vec2 from, to;         // of the edge, as directed
    Vec2 position;
    std::uint32_t edge;
    Vec2 direction() const { return to - from; }
    Vec2 inward() const { return left_normal(to - from) / length(to - from); }
  };
  Vec2 centre;
  double diagonal = 0;
  double near = 0;
  std::vector<Touch> touches;
};

Grasp make_grasp(const Polygon& polygon, const Vec2& centre, const std::vector<LiftingPoint>& points) {
  Grasp grasp{centre, polygon.diagonal(), near_distance(polygon.diagonal()), {}};
  for (const Contact& contact : contacts(polygon, points)) {
    Vec2 from = polygon.edge_start(contact.edge), to = polygon.edge_end(contact.edge);
    if (!polygon.counter_clockwise()) std::swap(from, to);
    grasp.touches.push_back({from, to, contact.position, contact.edge});
  }
  return grasp;
}

// The free rotation centres of one sense, relative to C, widened by `offset`: those on or left of every
// normal line (counter-clockwise) or on or right of it. With d the edge's direction, which the normal line
// crosses at a right angle, left of the line at p is d . (q - p) <= 0.
std::vector<HalfPlane> rotation_centres(const Grasp& grasp, Sense sense, double offset) {
  std::vector<HalfPlane> planes;
  planes.reserve(grasp.touches.size());
  for (const Grasp::Touch& touch : grasp.touches) {
    const double along = dot_of_differences(touch.from, touch.to, grasp.centre, touch.position);
    const double widening = offset * length(touch.direction());
    if (sense == Sense::counterclockwise) {
      planes.push_back({touch.from, touch.to, along + widening});
    } else {
      planes.push_back({touch.to, touch.from, widening - along});
    }
  }
  return planes;
}

Points clip_square(const Grasp& grasp, const std::vector<HalfPlane>& planes) {
  const double side = square_half_side * grasp.diagonal;
  Points region{{-side, -side}, {side, -side}, {side, side}, {-side, side}};
  for (const HalfPlane& plane : planes) {
    const Vec2 normal = plane.normal();
    const Vec2 on_line = (plane.bound / dot(normal, normal)) * normal;
    region = clip_left(region, on_line, on_line + left_normal(normal));
  }
  return region;
}

// The part of the line through `point` along `direction` that lies in all half-planes and in the
// square: its ends, or nothing.
Points clip_line(const Grasp& grasp, const std::vector<HalfPlane>& planes, const Vec2& point, const Vec2& direction) {
  const Vec2 unit = direction / length(direction);
  const double side = square_half_side * grasp.diagonal;
  double low = -4 * side, high = 4 * side;
  const auto keep = [&](const Vec2& normal, double bound) {
    const double slope = dot(normal, unit), rest = bound - dot(normal, point);
    if (std::fabs(slope) <= tau * length(normal)) return;
    if (slope > 0) high = std::min(high, rest / slope);
    else low = std::max(low, rest / slope);
  };
  for (const HalfPlane& plane : planes) keep(plane.normal(), plane.bound);
  for (const Vec2& axis : {Vec2(1, 0), Vec2(-1, 0), Vec2(0, 1), Vec2(0, -1)}) keep(axis, side);
  if (low > high) return {};
  return {point + low * unit, point + high * unit};
}

// The least widening at which a bounded region that vanishes when narrowed by `near` exists, to far below
// the tolerance; and the region there.
Points sharpest_region(const Grasp& grasp, Sense sense) {
  double empty = -grasp.near, full = grasp.near;
  for (int i = 0; i < 40; ++i) {
    const double middle = 0.5 * (empty + full);
    (have_common_point(rotation_centres(grasp, sense, middle)) ? full : empty) = middle;
  }
  return bounded_intersection(rotation_centres(grasp, sense, full));
}

// The two corners farthest apart.
std::pair<Vec2, Vec2> longest_extent(const Points& corners) {
  std::pair<Vec2, Vec2> ends{corners.front(), corners.front()};
  for (const Vec2& a : corners) {
    for (const Vec2& b : corners) {
      if (length(b - a) > length(ends.second - ends.first)) ends = {a, b};
    }
  }
  return ends;
}

// One point or two ends of a region without area, relative to C; nothing beyond the square.
Points degenerate_region(const Grasp& grasp, Sense sense) {
  const auto planes = rotation_centres(grasp, sense, grasp.near);
  const NormalGap gap = widest_gap(planes);
  if (gap.excess == 0) {
    // Two opposite normals: along their line, as far as the others let it.
    const HalfPlane &a = planes[gap.before], &b = planes[gap.after];
    const Vec2 na = a.normal() / length(a.normal());
    const double middle = 0.5 * (a.bound / length(a.normal()) - b.bound / length(b.normal()));
    return clip_line(grasp, planes, middle * na, left_normal(na));
  }
  const Points corners = sharpest_region(grasp, sense);
  if (corners.empty()) return {};
  const auto [p, q] = longest_extent(corners);
  const double side = square_half_side * grasp.diagonal;
  if (length(q - p) > grasp.near) return clip_line(grasp, planes, 0.5 * (p + q), q - p);
  const Vec2 point = 0.5 * (p + q);
  if (point.cwiseAbs().maxCoeff() > side) return {};
  return {point};
}

FreeRegion free_region(const Grasp& grasp, Sense sense) {
  FreeRegion region;
  const auto planes = rotation_centres(grasp, sense, grasp.near);
  region.exists = have_common_point(planes);
  if (!region.exists) return region;
  region.has_area = have_common_point(rotation_centres(grasp, sense, -grasp.near));
  region.clipped = region.has_area ? clip_square(grasp, planes) : degenerate_region(grasp, sense);
  for (Vec2& corner : region.clipped) corner += grasp.centre;
  return region;
}

// A direction of free translation, if there is one: it makes no obtuse angle with any inward normal, so
// the normals leave a gap of at least 180 degrees.
std::optional<Vec2> free_translation(const Grasp& grasp) {
  if (grasp.touches.empty()) return Vec2(1, 0);
  std::vector<HalfPlane> directions;
  for (const Grasp::Touch& touch : grasp.touches) directions.push_back({touch.from, touch.to, 0});
  const NormalGap gap = widest_gap(directions);
  if (gap.excess < 0) return std::nullopt;
  // The middle of the fan of normals, which opens from `after` counter-clockwise to `before` by at most
  // 180 degrees. Either half of the sum may vanish, both cannot.
  const Vec2 first = grasp.touches[gap.after].inward(), last = grasp.touches[gap.before].inward();
  const Vec2 middle = (first + last) + (left_normal(first) - left_normal(last));
  return Vec2(middle / length(middle));
}

// Whether contacts whose normals pass through c (relative to C) resist the second-order motion: some
// balanced non-negative weights have a positive sum of signed distances to c. By Farkas' lemma that is so
// just if no q has n . q <= -d for all of them.
bool resists_at(const Grasp& grasp, const Vec2& c) {
  std::vector<HalfPlane> planes;
  for (const Grasp::Touch& touch : grasp.touches) {
    const Vec2 to_c = c - (touch.position - grasp.centre);
    const double size = length(touch.direction());
    if (std::fabs(dot(touch.direction(), to_c)) > grasp.near * size) continue;
    const double distance = cross(touch.direction(), to_c) / size;
    const Vec2 from(-touch.from.y(), touch.from.x()), to(-touch.to.y(), touch.to.x());
    planes.push_back({from, to, (grasp.near - distance) * size});
  }
  return !planes.empty() && !have_common_point(planes);
}

bool immobile_to_second_order(const Grasp& grasp, const Closure& closure) {
  if (closure.form_closure || closure.translation_free) return false;
  for (const auto& [region, sense] : {std::pair(&closure.clockwise, Sense::clockwise),
                                      std::pair(&closure.counterclockwise, Sense::counterclockwise)}) {
    if (!region->exists) continue;
    if (region->has_area) return false;
    const Points corners = sharpest_region(grasp, sense);
    if (corners.empty()) return false;
    const auto [p, q] = longest_extent(corners);
    if (!resists_at(grasp, 0.5 * (p + q))) return false;
  }
  return true;
}

// Wrenches of the contacts, torques in units of L / 2. Between the extreme contacts of one edge others
// add nothing to the hull.
std::vector<Wrench> extreme_wrenches(const Grasp& grasp) {
  std::map<std::uint32_t, std::pair<Wrench, Wrench>> by_edge;
  for (const Grasp::Touch& touch : grasp.touches) {
    const Vec2 n = touch.inward();
    const Wrench wrench(n.x(), n.y(), cross(touch.position - grasp.centre, n) / (0.5 * grasp.diagonal));
    const auto [at, is_new] = by_edge.try_emplace(touch.edge, wrench, wrench);
    if (wrench.z() < at->second.first.z()) at->second.first = wrench;
    if (wrench.z() > at->second.second.z()) at->second.second = wrench;
  }
  std::vector<Wrench> wrenches;
  for (const auto& [edge, extremes] : by_edge) {
    wrenches.push_back(extremes.first);
    if (extremes.second != extremes.first) wrenches.push_back(extremes.second);
  }
  return wrenches;
}

}  // namespace

Closure analyse_closure(const Polygon& polygon, const Vec2& centre, const std::vector<LiftingPoint>& points) {
  const Grasp grasp = make_grasp(polygon, centre, points);
  Closure closure;
  closure.translation = free_translation(grasp);
  closure.translation_free = closure.translation.has_value();
  closure.clockwise = free_region(grasp, Sense::clockwise);
  closure.counterclockwise = free_region(grasp, Sense::counterclockwise);
  closure.form_closure = !closure.translation_free && !closure.clockwise.exists && !closure.counterclockwise.exists;
  closure.second_order = immobile_to_second_order(grasp, closure);
  if (!grasp.touches.empty()) closure.margin = wrench_margin(extreme_wrenches(grasp));
  return closure;
}

}  // namespace evenlift
