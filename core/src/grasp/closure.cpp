#include "evenlift/closure.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "evenlift/hull.h"
#include "evenlift/predicates.h"
#include "evenlift/tolerance.h"
#include "exact/sorted_indices.h"
#include "grasp/grasp.h"
#include "polygon/corners.h"
#include "polygon/half_planes.h"

namespace evenlift {
namespace {

using Touch = Grasp::Touch;

// Whether a touch's edge has a direction in [0, 180) degrees. Comparing coordinates is exact.
bool points_up(const Touch& touch) {
  return touch.to.y > touch.from.y || (touch.to.y == touch.from.y && touch.to.x > touch.from.x);
}

double turn_of(const Touch& a, const Touch& b) {
  return cross_of_differences(a.from, a.to, b.from, b.to);
}

bool same_direction(const Touch& a, const Touch& b) {
  return points_up(a) == points_up(b) && turn_of(a, b) == 0;
}

Touch touch_of(const Polygon& polygon, const Contact& contact) {
  Vec2 from = polygon.edge_start(contact.edge), to = polygon.edge_end(contact.edge);
  if (!polygon.counter_clockwise()) std::swap(from, to);
  return {from, to, contact.position, contact.edge};
}

struct PlacedTouch {
  Touch touch;
  double place = 0;  // along the direction of its edge
  std::size_t contact = 0;
};

// The first and the last contact along each edge, in the order of the contacts. They are few even
// for many robots, so what follows costs little.
std::vector<PlacedTouch> extremes_of_edges(const Polygon& polygon, const Grasp& grasp,
                                           const std::vector<Contact>& contacts) {
  struct Extremes {
    PlacedTouch first, last;
  };
  std::map<std::uint32_t, Extremes> of_edge;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const std::uint32_t edge = contacts[i].edge;
    PlacedTouch placed{touch_of(polygon, contacts[i]), 0, i};
    placed.place = along(grasp, placed.touch) / length(placed.touch.direction());
    const auto [found, is_new] = of_edge.try_emplace(edge, Extremes{placed, placed});
    auto& [first, last] = found->second;
    if (placed.place < first.place) first = placed;
    if (placed.place >= last.place) last = placed;
  }
  std::vector<PlacedTouch> extremes;
  for (const auto& [edge, ends] : of_edge) {
    extremes.push_back(ends.first);
    if (ends.last.contact != ends.first.contact) extremes.push_back(ends.last);
  }
  sort_items(extremes,
             [](const PlacedTouch& a, const PlacedTouch& b) { return a.contact < b.contact; });
  return extremes;
}

// Keeps the first and the last of the touches whose edges have the same direction, decided exactly.
std::vector<Touch> extremes_of_directions(const std::vector<PlacedTouch>& touches) {
  const auto order = sorted_indices(touches.size(), [&](std::uint32_t i, std::uint32_t j) {
    const Touch &a = touches[i].touch, &b = touches[j].touch;
    if (points_up(a) != points_up(b)) return points_up(a);
    if (const double turn = turn_of(a, b); turn != 0) return turn > 0;
    return touches[i].place < touches[j].place;
  });
  std::vector<std::uint32_t> kept;
  for (std::size_t k = 0; k < order.size(); ++k) {
    const auto like = [&](std::size_t other) {
      return same_direction(touches[order[other]].touch, touches[order[k]].touch);
    };
    if (k == 0 || !like(k - 1) || k + 1 == order.size() || !like(k + 1)) kept.push_back(order[k]);
  }
  std::sort(kept.begin(), kept.end());
  std::vector<Touch> extremes;
  extremes.reserve(kept.size());
  for (const std::uint32_t i : kept) extremes.push_back(touches[i].touch);
  return extremes;
}

}  // namespace

std::vector<Grasp::Touch> touches_of(const Polygon& polygon, const std::vector<Contact>& contacts) {
  std::vector<Touch> touches;
  touches.reserve(contacts.size());
  for (const Contact& contact : contacts) touches.push_back(touch_of(polygon, contact));
  return touches;
}

double along(const Grasp& grasp, const Grasp::Touch& touch) {
  return dot_of_differences(touch.from, touch.to, grasp.centre, touch.position);
}

Grasp make_grasp(const Polygon& polygon, const Vec2& centre, double radius,
                 const std::vector<Contact>& contacts) {
  Grasp grasp{
      centre, polygon.diagonal(), polygon.diameter(), near_distance(polygon.diameter()), radius,
      {}};
  grasp.touches = extremes_of_directions(extremes_of_edges(polygon, grasp, contacts));
  return grasp;
}

std::vector<Wrench> wrenches(const Grasp& grasp) {
  std::vector<Wrench> all;
  for (const Grasp::Touch& touch : grasp.touches) {
    const Vec2 n = touch.inward();
    all.emplace_back(n.x, n.y, cross(touch.position - grasp.centre, n) / grasp.radius);
  }
  std::vector<Wrench> ordered;
  for (const std::uint32_t i : sorted_indices(all.size(), [&](std::uint32_t a, std::uint32_t b) {
         if (grasp.touches[a].edge != grasp.touches[b].edge)
           return grasp.touches[a].edge < grasp.touches[b].edge;
         return all[a].z < all[b].z;
       }))
    ordered.push_back(all[i]);
  return ordered;
}

namespace {

// Half the side of the square about C to which regions are clipped, in diagonals of the bounding
// box.
constexpr double square_half_side = 100;

enum class Sense { counterclockwise, clockwise };

// Reuleaux's half-planes of one sense, relative to C and widened by `offset`. Free centres of
// counter-clockwise rotation are on or left of every contact's normal line, those of clockwise
// rotation on or right of it. If d is the direction of the edge, left of the line at p means
// d . (q - p) <= 0.
std::vector<HalfPlane> rotation_centres(const Grasp& grasp, Sense sense, double offset) {
  std::vector<HalfPlane> planes;
  planes.reserve(grasp.touches.size());
  for (const Grasp::Touch& touch : grasp.touches) {
    const double bound = along(grasp, touch);
    const double widening = offset * length(touch.direction());
    if (sense == Sense::counterclockwise) {
      planes.push_back({touch.from, touch.to, bound + widening});
    } else {
      planes.push_back({touch.to, touch.from, widening - bound});
    }
  }
  return planes;
}

// The largest distance along an axis at which a rotation centre counts; beyond it, a rotation is a
// translation within tolerance. If a translation is free, some contacts may be on edges drawn
// parallel, which rounding turns by some 1e-14. Their normal lines meet beyond L / sqrt(tau), about
// 3e4 L, if at all; that is not a property of the shape.
double farthest_centre(const Grasp& grasp, bool translation_free) {
  return grasp.diameter / (translation_free ? std::sqrt(tau) : tau);
}

constexpr int axes = 4;
HalfPlane within_reach(int axis, double reach) {
  const Vec2 directions[axes] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}};
  return {Vec2{}, directions[axis], reach};
}

// The half-planes are widened by `offset`.
bool some_centre_is_free(const Grasp& grasp, Sense sense, double offset, double reach) {
  std::vector<HalfPlane> planes = rotation_centres(grasp, sense, offset);
  for (int axis = 0; axis < axes; ++axis) planes.push_back(within_reach(axis, reach));
  return have_common_point(planes);
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

// The part of the line through `point` along `direction` that lies in all half-planes and within
// `reach` of C along both axes: its two ends, or no points.
Points clip_line(const std::vector<HalfPlane>& planes, double reach, const Vec2& point,
                 const Vec2& direction) {
  const Vec2 unit = direction / length(direction);
  double low = -4 * reach, high = 4 * reach;
  const auto keep = [&](const Vec2& normal, double bound) {
    const double slope = dot(normal, unit), slack = bound - dot(normal, point);
    if (std::fabs(slope) <= tau * length(normal)) return;
    if (slope > 0) {
      high = std::min(high, slack / slope);
    } else {
      low = std::max(low, slack / slope);
    }
  };
  for (const HalfPlane& plane : planes) keep(plane.normal(), plane.bound);
  for (const Vec2& axis : {Vec2(1, 0), Vec2(-1, 0), Vec2(0, 1), Vec2(0, -1)}) keep(axis, reach);
  if (low > high) return {};
  return {point + low * unit, point + high * unit};
}

// Two half-planes with opposite normals and the same line, within tolerance.
std::optional<std::pair<std::size_t, std::size_t>> coinciding_lines(
    const std::vector<HalfPlane>& planes, double near) {
  for (std::size_t i = 0; i < planes.size(); ++i) {
    const Vec2 ni = planes[i].normal();
    for (std::size_t j = i + 1; j < planes.size(); ++j) {
      const Vec2 nj = planes[j].normal();
      if (!directions_agree(ni, -nj)) continue;
      // Both are widened by `near`, so lines that coincide leave a strip of twice that width.
      const double width = planes[i].bound / length(ni) + planes[j].bound / length(nj);
      if (width >= 0 && width <= 4 * near) return std::pair(i, j);
    }
  }
  return std::nullopt;
}

// The region at the smallest widening at which it exists, by bisection to far below the tolerance.
// It must be bounded, and vanish when narrowed by `near`.
Points sharpest_region(const Grasp& grasp, Sense sense) {
  double empty = -grasp.near, full = grasp.near;
  for (int i = 0; i < 40; ++i) {
    const double middle = 0.5 * (empty + full);
    (have_common_point(rotation_centres(grasp, sense, middle)) ? full : empty) = middle;
  }
  return bounded_intersection(rotation_centres(grasp, sense, full));
}

// A region without area, relative to C and within `reach` of it along both axes: a point, the two
// ends of a segment, or no points.
Points degenerate_region(const Grasp& grasp, Sense sense, double reach) {
  const auto planes = rotation_centres(grasp, sense, grasp.near);
  if (const auto pair = coinciding_lines(planes, grasp.near)) {
    const HalfPlane &a = planes[pair->first], &b = planes[pair->second];
    const Vec2 normal = a.normal() / length(a.normal());
    const double middle = 0.5 * (a.bound / length(a.normal()) - b.bound / length(b.normal()));
    Points ends = clip_line(planes, reach, middle * normal, left_normal(normal));
    if (ends.empty() || length(ends[1] - ends[0]) > 4 * grasp.near) return ends;
    return {0.5 * (ends[0] + ends[1])};
  }
  const Points corners = sharpest_region(grasp, sense);
  if (corners.empty()) return {};
  Vec2 point;
  for (const Vec2& corner : corners) point += corner / static_cast<double>(corners.size());
  if (max_norm(point) > reach) return {};
  return {point};
}

FreeRegion free_region(const Grasp& grasp, Sense sense, double reach) {
  FreeRegion region;
  region.exists = some_centre_is_free(grasp, sense, grasp.near, reach);
  if (!region.exists) return region;
  region.has_area = some_centre_is_free(grasp, sense, -grasp.near, reach);
  region.clipped = region.has_area
                       ? clip_square(grasp, rotation_centres(grasp, sense, grasp.near))
                       : degenerate_region(grasp, sense, square_half_side * grasp.diagonal);
  for (Vec2& corner : region.clipped) corner += grasp.centre;
  return region;
}

// A free translation makes no obtuse angle with any inward normal. So one exists if and only if the
// normals leave a gap of at least 180 degrees, within tolerance.
std::optional<Vec2> free_translation(const Grasp& grasp) {
  if (grasp.touches.empty()) return Vec2(1, 0);
  std::vector<HalfPlane> directions;
  for (const Grasp::Touch& touch : grasp.touches) directions.push_back({touch.from, touch.to, 0});
  const NormalGap gap = widest_gap(directions, tau);
  if (gap.compare_to_half_turn < 0) return std::nullopt;
  // The middle of the fan of normals, which spans at most 180 degrees, within tolerance, from
  // `after` counter-clockwise to `before`. Either half of the sum may vanish, but not both.
  const Vec2 first = grasp.touches[gap.after].inward(), last = grasp.touches[gap.before].inward();
  const Vec2 middle = (first + last) + (left_normal(first) - left_normal(last));
  return Vec2(middle / length(middle));
}

// Whether the contacts whose normals pass through c (relative to C) prevent the rotation about c to
// second order: some non-negative weights balance the normals n and give a positive sum of the
// signed distances d of c along them. By Farkas' lemma this is true if and only if no q satisfies
// n . q <= -d for all. Keeping q within L / tau lets forces balance within tolerance, since nearly
// opposite normals would meet farther out.
bool resists_at(const Grasp& grasp, const std::vector<Grasp::Touch>& touches, const Vec2& c) {
  std::vector<HalfPlane> planes;
  for (int axis = 0; axis < axes; ++axis)
    planes.push_back(within_reach(axis, farthest_centre(grasp, false)));
  for (const Grasp::Touch& touch : touches) {
    const Vec2 to_c = c - (touch.position - grasp.centre);
    const double size = length(touch.direction());
    if (std::fabs(dot(touch.direction(), to_c)) > grasp.near * size) continue;
    const double distance = cross(touch.direction(), to_c) / size;
    const Vec2 from(-touch.from.y, touch.from.x), to(-touch.to.y, touch.to.x);
    planes.push_back({from, to, (grasp.near - distance) * size});
  }
  return !have_common_point(planes);
}

// Whether the curvature of every motion that is free to first order drives the object into a robot.
// Robots on one normal line, which are alike to first order, differ in this, so all touches count.
bool immobile_to_second_order(const Grasp& grasp, const std::vector<Grasp::Touch>& touches,
                              const Closure& closure) {
  if (closure.form_closure || closure.translation_free) return false;
  for (const auto& [region, sense] :
       {std::pair(&closure.clockwise, Sense::clockwise),
        std::pair(&closure.counterclockwise, Sense::counterclockwise)}) {
    if (!region->exists) continue;
    if (region->has_area) return false;
    // The region is bounded, since no translation is free, so any large finite reach will do.
    const Points region_at_rest = degenerate_region(grasp, sense, farthest_centre(grasp, false));
    if (region_at_rest.empty()) return false;
    if (!resists_at(grasp, touches, 0.5 * (region_at_rest.front() + region_at_rest.back())))
      return false;
  }
  return true;
}

bool nothing_is_free(const Grasp& grasp) {
  if (free_translation(grasp)) return false;
  const double reach = farthest_centre(grasp, false);
  return !some_centre_is_free(grasp, Sense::clockwise, grasp.near, reach) &&
         !some_centre_is_free(grasp, Sense::counterclockwise, grasp.near, reach);
}

std::optional<double> margin_of(const Grasp& grasp) {
  if (grasp.touches.empty()) return std::nullopt;
  return wrench_margin(wrenches(grasp));
}

}  // namespace

Hold analyse_hold(const Polygon& polygon, const Vec2& centre,
                  const std::vector<Contact>& contacts) {
  const Grasp grasp = make_grasp(polygon, centre, farthest_vertex(polygon, centre), contacts);
  return {nothing_is_free(grasp), margin_of(grasp)};
}

Hold analyse_hold(const Polygon& polygon, const Vec2& centre,
                  const std::vector<LiftingPoint>& points) {
  return analyse_hold(polygon, centre, contacts(polygon, points));
}

bool in_form_closure(const Polygon& polygon, const Vec2& centre,
                     const std::vector<Contact>& contacts) {
  return nothing_is_free(make_grasp(polygon, centre, farthest_vertex(polygon, centre), contacts));
}

bool in_form_closure(const Polygon& polygon, const Vec2& centre,
                     const std::vector<LiftingPoint>& points) {
  return in_form_closure(polygon, centre, contacts(polygon, points));
}

bool no_region_has_area(const Polygon& polygon, const Vec2& centre,
                        const std::vector<LiftingPoint>& points) {
  const Grasp grasp =
      make_grasp(polygon, centre, farthest_vertex(polygon, centre), contacts(polygon, points));
  const double reach = farthest_centre(grasp, free_translation(grasp).has_value());
  return !some_centre_is_free(grasp, Sense::clockwise, -grasp.near, reach) &&
         !some_centre_is_free(grasp, Sense::counterclockwise, -grasp.near, reach);
}

FreeRegions free_regions(const Polygon& polygon, const Vec2& centre,
                         const std::vector<Contact>& contacts) {
  const Grasp grasp = make_grasp(polygon, centre, farthest_vertex(polygon, centre), contacts);
  const double reach = farthest_centre(grasp, free_translation(grasp).has_value());
  return {free_region(grasp, Sense::clockwise, reach),
          free_region(grasp, Sense::counterclockwise, reach)};
}

Closure analyse_closure(const Polygon& polygon, const Vec2& centre,
                        const std::vector<LiftingPoint>& points) {
  const std::vector<Contact> touching = contacts(polygon, points);
  const Grasp grasp = make_grasp(polygon, centre, farthest_vertex(polygon, centre), touching);
  Closure closure;
  closure.translation = free_translation(grasp);
  closure.translation_free = closure.translation.has_value();
  const double reach = farthest_centre(grasp, closure.translation_free);
  closure.clockwise = free_region(grasp, Sense::clockwise, reach);
  closure.counterclockwise = free_region(grasp, Sense::counterclockwise, reach);
  closure.form_closure =
      !closure.translation_free && !closure.clockwise.exists && !closure.counterclockwise.exists;
  closure.second_order = immobile_to_second_order(grasp, touches_of(polygon, touching), closure);
  closure.margin = margin_of(grasp);
  if (closure.form_closure) closure.clearance = analyse_clearance(polygon, centre, touching);
  return closure;
}

}  // namespace evenlift
