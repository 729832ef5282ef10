#include "evenlift/closure.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "evenlift/hull.h"
#include "evenlift/predicates.h"
#include "evenlift/tolerance.h"
#include "exact/sorted_indices.h"
#include "grasp/wrench_margin.h"
#include "polygon/clip.h"
#include "polygon/half_planes.h"

namespace evenlift {
namespace {

// Half the side of the square about C to which regions are clipped, in units of L.
constexpr double square_half_side = 100;

enum class Sense { counterclockwise, clockwise };

// The object and its contacts. Each contact's edge is directed so that the interior is on its left,
// so the inward normal is the edge's direction turned by +90 degrees.
struct Grasp {
  struct Touch {
    Vec2 from, to;  // the ends of the edge, as directed
    Vec2 position;
    std::uint32_t edge;
    Vec2 direction() const { return to - from; }
    Vec2 inward() const { return left_normal(to - from) / length(to - from); }
  };
  Vec2 centre;
  double diagonal = 0;
  double near = 0;
  double radius = 0;  // R: the largest distance of a vertex from C
  std::vector<Touch> touches;
};

// The position of a touch along its edge, from the foot of the perpendicular from C, times the
// edge's length.
double along(const Grasp& grasp, const Grasp::Touch& touch) {
  return dot_of_differences(touch.from, touch.to, grasp.centre, touch.position);
}

// Keeps only the first and the last of the touches on each edge, in their order. The wrenches and
// the normal lines of the others lie between theirs and add nothing.
void keep_extremes(Grasp& grasp) {
  const std::vector<Grasp::Touch>& touches = grasp.touches;
  std::vector<double> place(touches.size());
  for (std::size_t i = 0; i < touches.size(); ++i) place[i] = along(grasp, touches[i]);
  const auto order = sorted_indices(touches.size(), [&](std::uint32_t i, std::uint32_t j) {
    if (touches[i].edge != touches[j].edge) return touches[i].edge < touches[j].edge;
    return place[i] < place[j];
  });
  std::vector<std::uint32_t> kept;
  for (std::size_t k = 0; k < order.size(); ++k) {
    const std::uint32_t edge = touches[order[k]].edge;
    const bool is_first = k == 0 || touches[order[k - 1]].edge != edge;
    const bool is_last = k + 1 == order.size() || touches[order[k + 1]].edge != edge;
    if (is_first || is_last) kept.push_back(order[k]);
  }
  std::sort(kept.begin(), kept.end());
  std::vector<Grasp::Touch> extremes;
  extremes.reserve(kept.size());
  for (const std::uint32_t i : kept) extremes.push_back(touches[i]);
  grasp.touches = std::move(extremes);
}

Grasp make_grasp(const Polygon& polygon, const Vec2& centre, const std::vector<Contact>& contacts) {
  Grasp grasp{centre, polygon.diagonal(), near_distance(polygon.diagonal()), 0, {}};
  for (const Vec2& v : polygon.vertices())
    grasp.radius = std::max(grasp.radius, length(v - centre));
  for (const Contact& contact : contacts) {
    Vec2 from = polygon.edge_start(contact.edge), to = polygon.edge_end(contact.edge);
    if (!polygon.counter_clockwise()) std::swap(from, to);
    grasp.touches.push_back({from, to, contact.position, contact.edge});
  }
  keep_extremes(grasp);
  return grasp;
}

// Reuleaux's half-planes of one sense, relative to C and widened by `offset`. The free
// instantaneous centres of counter-clockwise rotation are those on or left of every contact's
// normal line, those of clockwise rotation on or right of it. With d the edge's direction, which is
// perpendicular to the normal line, left of the line at p means d . (q - p) <= 0.
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

// The largest distance along an axis at which a rotation centre still counts. A rotation about a
// point farther away is a translation within tolerance, and whether lines that were drawn parallel
// meet out there depends on rounding.
double farthest_centre(const Grasp& grasp) { return grasp.diagonal / tau; }

constexpr int axes = 4;
HalfPlane within_reach(int axis, double reach) {
  const Vec2 directions[axes] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}};
  return {Vec2::Zero(), directions[axis], reach};
}

// Whether some centre of rotation is free after the half-planes are widened by `offset`.
bool some_centre_is_free(const Grasp& grasp, Sense sense, double offset) {
  std::vector<HalfPlane> planes = rotation_centres(grasp, sense, offset);
  for (int axis = 0; axis < axes; ++axis)
    planes.push_back(within_reach(axis, farthest_centre(grasp)));
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
      // Both are widened by `near` already, so lines that coincide leave a strip of twice that
      // width.
      const double width = planes[i].bound / length(ni) + planes[j].bound / length(nj);
      if (width >= 0 && width <= 4 * near) return std::pair(i, j);
    }
  }
  return std::nullopt;
}

// The region at the least widening at which it exists, found by bisection to far below the
// tolerance. The region must be bounded and must vanish when it is narrowed by `near`.
Points sharpest_region(const Grasp& grasp, Sense sense) {
  double empty = -grasp.near, full = grasp.near;
  for (int i = 0; i < 40; ++i) {
    const double middle = 0.5 * (empty + full);
    (have_common_point(rotation_centres(grasp, sense, middle)) ? full : empty) = middle;
  }
  return bounded_intersection(rotation_centres(grasp, sense, full));
}

// A region without area, relative to C and within `reach` of it along both axes: one point, or the
// two ends of a segment, or no points.
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
  Vec2 point = Vec2::Zero();
  for (const Vec2& corner : corners) point += corner / static_cast<double>(corners.size());
  if (point.cwiseAbs().maxCoeff() > reach) return {};
  return {point};
}

FreeRegion free_region(const Grasp& grasp, Sense sense) {
  FreeRegion region;
  region.exists = some_centre_is_free(grasp, sense, grasp.near);
  if (!region.exists) return region;
  region.has_area = some_centre_is_free(grasp, sense, -grasp.near);
  region.clipped = region.has_area
                       ? clip_square(grasp, rotation_centres(grasp, sense, grasp.near))
                       : degenerate_region(grasp, sense, square_half_side * grasp.diagonal);
  for (Vec2& corner : region.clipped) corner += grasp.centre;
  return region;
}

// A direction of free translation, if there is one. It makes no obtuse angle with any inward
// normal, so it exists if and only if the normals leave a gap of at least 180 degrees, within
// tolerance.
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
// second order: whether some non-negative weights balance the normals n and give the signed
// distances d of c along them a positive sum. By Farkas' lemma that is so if and only if no q has n
// . q <= -d for all of them. Keeping q within L / tau lets forces balance within tolerance, since
// nearly opposite normals would meet farther out.
bool resists_at(const Grasp& grasp, const Vec2& c) {
  std::vector<HalfPlane> planes;
  for (int axis = 0; axis < axes; ++axis)
    planes.push_back(within_reach(axis, farthest_centre(grasp)));
  for (const Grasp::Touch& touch : grasp.touches) {
    const Vec2 to_c = c - (touch.position - grasp.centre);
    const double size = length(touch.direction());
    if (std::fabs(dot(touch.direction(), to_c)) > grasp.near * size) continue;
    const double distance = cross(touch.direction(), to_c) / size;
    const Vec2 from(-touch.from.y(), touch.from.x()), to(-touch.to.y(), touch.to.x());
    planes.push_back({from, to, (grasp.near - distance) * size});
  }
  return !have_common_point(planes);
}

// Second-order immobility (Rimon and Burdick): the curvature of every motion that is free to first
// order runs the object into a robot.
bool immobile_to_second_order(const Grasp& grasp, const Closure& closure) {
  if (closure.form_closure || closure.translation_free) return false;
  for (const auto& [region, sense] :
       {std::pair(&closure.clockwise, Sense::clockwise),
        std::pair(&closure.counterclockwise, Sense::counterclockwise)}) {
    if (!region->exists) continue;
    if (region->has_area) return false;
    // The region is bounded, since no translation is free. The reach is only a finite number that
    // is large enough.
    const Points region_at_rest = degenerate_region(grasp, sense, farthest_centre(grasp));
    if (region_at_rest.empty()) return false;
    if (!resists_at(grasp, 0.5 * (region_at_rest.front() + region_at_rest.back()))) return false;
  }
  return true;
}

// The wrenches of the contacts, with torques in units of R. They are sorted by edge and torque, so
// that the margin does not depend on the order of the robots.
std::vector<Wrench> wrenches(const Grasp& grasp) {
  std::vector<Wrench> all;
  for (const Grasp::Touch& touch : grasp.touches) {
    const Vec2 n = touch.inward();
    all.emplace_back(n.x(), n.y(), cross(touch.position - grasp.centre, n) / grasp.radius);
  }
  std::vector<Wrench> ordered;
  for (const std::uint32_t i : sorted_indices(all.size(), [&](std::uint32_t a, std::uint32_t b) {
         if (grasp.touches[a].edge != grasp.touches[b].edge)
           return grasp.touches[a].edge < grasp.touches[b].edge;
         return all[a].z() < all[b].z();
       }))
    ordered.push_back(all[i]);
  return ordered;
}

}  // namespace

bool in_form_closure(const Polygon& polygon, const Vec2& centre,
                     const std::vector<LiftingPoint>& points) {
  const Grasp grasp = make_grasp(polygon, centre, contacts(polygon, points));
  return !free_translation(grasp) && !some_centre_is_free(grasp, Sense::clockwise, grasp.near) &&
         !some_centre_is_free(grasp, Sense::counterclockwise, grasp.near);
}

bool no_region_has_area(const Polygon& polygon, const Vec2& centre,
                        const std::vector<LiftingPoint>& points) {
  const Grasp grasp = make_grasp(polygon, centre, contacts(polygon, points));
  return !some_centre_is_free(grasp, Sense::clockwise, -grasp.near) &&
         !some_centre_is_free(grasp, Sense::counterclockwise, -grasp.near);
}

FreeRegions free_regions(const Polygon& polygon, const Vec2& centre,
                         const std::vector<Contact>& contacts) {
  const Grasp grasp = make_grasp(polygon, centre, contacts);
  return {free_region(grasp, Sense::clockwise), free_region(grasp, Sense::counterclockwise)};
}

Closure analyse_closure(const Polygon& polygon, const Vec2& centre,
                        const std::vector<LiftingPoint>& points) {
  const Grasp grasp = make_grasp(polygon, centre, contacts(polygon, points));
  Closure closure;
  closure.translation = free_translation(grasp);
  closure.translation_free = closure.translation.has_value();
  closure.clockwise = free_region(grasp, Sense::clockwise);
  closure.counterclockwise = free_region(grasp, Sense::counterclockwise);
  closure.form_closure =
      !closure.translation_free && !closure.clockwise.exists && !closure.counterclockwise.exists;
  closure.second_order = immobile_to_second_order(grasp, closure);
  if (!grasp.touches.empty()) closure.margin = wrench_margin(wrenches(grasp));
  return closure;
}

}  // namespace evenlift
