#include "evenlift/supports.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "evenlift/hull.h"
#include "evenlift/numbers.h"
#include "evenlift/plane.h"
#include "evenlift/settings.h"
#include "evenlift/tolerance.h"
#include "evenlift/wording.h"
#include "numbers/number_text.h"
#include "polygon/coordinates.h"

namespace evenlift {
namespace {

// The edge's end within tau L of the point, or the point.
Vec2 or_vertex(const Polygon& polygon, std::uint32_t edge, const Vec2& point) {
  const double near = near_distance(polygon.diameter());
  for (const Vec2& end : {polygon.edge_start(edge), polygon.edge_end(edge)})
    if (length(point - end) <= near) return end;
  return point;
}

// A point this near the outline is on it but for rounding, and stays as given.
double rounding_of(const Vec2& point) { return 0x1p-50 * max_norm(point); }

// Rounds to three significant digits.
std::string in_brief(double distance) {
  constexpr std::uint64_t three_digits = 1000;
  Decimal decimal = shortest_decimal(distance);
  std::uint64_t unit = 1;
  for (; decimal.digits / unit >= three_digits; ++decimal.exponent) unit *= 10;
  decimal.digits = (decimal.digits + unit / 2) / unit;
  const std::string text = std::to_string(decimal.digits) + "e" + std::to_string(decimal.exponent);
  return shortest(read_number(text).value_or(distance));
}

InputError error_at(std::size_t number, std::string why) {
  return bad_setting(std::string(name(Setting::supports)) + "[" + std::to_string(number) + "]",
                     std::move(why));
}

std::string why_refused(const PolygonWithHoles& object, const SupportPlacer& placer,
                        const Vec2& support) {
  const std::string at = "(" + shortest(support.x) + ", " + shortest(support.y) + ")";
  if (const auto hole = object.hole_around(support))
    return say("{point} is in hole {hole}", {at, *hole + 1});
  return say("{point} is {distance} outside the object", {at, in_brief(placer.distance(support))});
}

}  // namespace

double snap_distance(const Polygon& polygon, const Settings& settings) {
  return settings.snap.value_or(usual_snap * polygon.diameter());
}

SupportPlacer::SupportPlacer(const PolygonWithHoles& object, const Settings& settings)
    : object_(object), snap_(snap_distance(object, settings)) {}

double SupportPlacer::distance(const Vec2& point) const {
  const Polygon& outline = object_.outline();
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < outline.size(); ++i)
    least = std::min(least, distance_to_segment(outline.edge_start(i), outline.edge_end(i), point));
  return least;
}

std::optional<LiftingPoint> SupportPlacer::place(const Vec2& support) const {
  const Polygon& outline = object_.outline();
  const double least = distance(support);
  if (least > snap_)
    return is_inside(outline, support) && !object_.hole_around(support)
               ? std::optional(LiftingPoint{support, beneath})
               : std::nullopt;
  const double near = near_distance(outline.diameter());
  for (std::uint32_t i = 0; i < outline.size(); ++i) {
    const Vec2 at = nearest_on_segment(outline.edge_start(i), outline.edge_end(i), support);
    if (length(support - at) > least + near) continue;
    return LiftingPoint{or_vertex(outline, i, least <= rounding_of(support) ? support : at), i};
  }
  return std::nullopt;  // never: some edge is nearest
}

Vec2 widest_addition(const Polygon& polygon, const Points& robots) {
  const double near = near_distance(polygon.diameter());
  const Points hull = convex_hull(robots, near);
  const double before = signed_area(hull);
  double most = tau * polygon.area(), farthest = -1;
  std::optional<Vec2> widest;
  Vec2 loneliest = polygon.vertex(0);
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    Points with = hull;
    with.push_back(polygon.vertex(i));
    const double gain = signed_area(convex_hull(std::move(with), near)) - before;
    if (gain > most) {
      most = gain;
      widest = polygon.vertex(i);
    }
    const Vec2 middle = (polygon.edge_start(i) + polygon.edge_end(i)) / 2;
    double least = std::numeric_limits<double>::infinity();
    for (const Vec2& robot : robots) least = std::min(least, length(robot - middle));
    if (least <= farthest + near) continue;
    farthest = least;
    loneliest = middle;
  }
  return widest.value_or(loneliest);
}

Result<std::vector<LiftingPoint>> place_supports(const PolygonWithHoles& object,
                                                 const Settings& settings) {
  const SupportPlacer placer(object, settings);
  std::vector<LiftingPoint> points;
  points.reserve(settings.supports.size());
  for (std::size_t i = 0; i < settings.supports.size(); ++i) {
    const Vec2& support = settings.supports[i];
    if (is_too_near_to_0(support))
      return error_at(i, "a coordinate is below 1e-100 in size but not 0");
    const auto point = placer.place(support);
    if (!point) return error_at(i, why_refused(object, placer, support));
    points.push_back(*point);
  }
  return points;
}

}  // namespace evenlift
