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

// With few significant digits: the nearest such number, or the least that is not less.
enum class Rounding : std::uint8_t { nearest, up };
std::string rounded(double distance, std::uint64_t below, Rounding rounding) {
  Decimal decimal = shortest_decimal(distance);
  std::uint64_t unit = 1;
  for (; decimal.digits / unit >= below; ++decimal.exponent) unit *= 10;
  decimal.digits = (decimal.digits + (rounding == Rounding::up ? unit - 1 : unit / 2)) / unit;
  const std::string text = std::to_string(decimal.digits) + "e" + std::to_string(decimal.exponent);
  return shortest(read_number(text).value_or(distance));
}

std::string in_brief(double distance) { return rounded(distance, 1000, Rounding::nearest); }

// A snap distance of one digit that is at least this.
std::string enough_for(double distance) { return rounded(distance, 10, Rounding::up); }

InputError error_at(std::size_t number, std::string why) {
  return bad_setting(std::string(name(Setting::supports)) + "[" + std::to_string(number) + "]",
                     std::move(why));
}

// A support within this many snap distances of the outline may be meant to stand at the edge.
constexpr double nearly = 10;

std::string why_refused(const PolygonWithHoles& object, const SupportPlacer& placer,
                        const Vec2& support) {
  const std::string at = "(" + shortest(support.x) + ", " + shortest(support.y) + ")";
  if (const auto hole = object.hole_around(support))
    return say("{point} is in hole {hole}", {at, *hole + 1});
  const double outside = placer.distance(support);
  if (outside > nearly * placer.snap())
    return say("{point} is {distance} outside the object", {at, in_brief(outside)});
  return say("{point} is {distance} outside the object; --snap {snap} puts it at the edge",
             {at, in_brief(outside), enough_for(outside)});
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

std::optional<std::uint32_t> SupportPlacer::notch_near(const Vec2& point) const {
  const Polygon& outline = object_.outline();
  std::optional<std::uint32_t> nearest;
  double least = snap_;
  for (std::uint32_t i = 0; i < outline.size(); ++i) {
    const double distance = length(outline.vertex(i) - point);
    if (distance > least || (nearest && distance == least) || !outline.is_notch(i)) continue;
    least = distance;
    nearest = i;
  }
  return nearest;
}

std::optional<LiftingPoint> SupportPlacer::place(const Vec2& support) const {
  const Polygon& outline = object_.outline();
  const double least = distance(support);
  if (least > snap_)
    return is_inside(outline, support) && !object_.hole_around(support)
               ? std::optional(LiftingPoint{support, beneath})
               : std::nullopt;
  const bool is_exact = least <= rounding_of(support);
  if (const auto notch = is_exact ? std::nullopt : notch_near(support))
    return LiftingPoint{outline.vertex(*notch),
                        std::min(*notch, static_cast<std::uint32_t>(outline.previous(*notch)))};
  const double near = near_distance(outline.diameter());
  for (std::uint32_t i = 0; i < outline.size(); ++i) {
    const Vec2 at = nearest_on_segment(outline.edge_start(i), outline.edge_end(i), support);
    if (length(support - at) > least + near) continue;
    return LiftingPoint{or_vertex(outline, i, is_exact ? support : at), i};
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

std::vector<std::string> snap_notes(const PolygonWithHoles& object, const Settings& settings) {
  const SupportPlacer placer(object, settings);
  constexpr double worth_telling = 1e-6;
  double most = 0, least_beneath = std::numeric_limits<double>::infinity();
  std::size_t moved = 0, nearest = 0;
  for (std::size_t i = 0; i < settings.supports.size(); ++i) {
    const auto place = placer.place(settings.supports[i]);
    if (!place) continue;
    if (place->edge == beneath) {
      const double distance = placer.distance(settings.supports[i]);
      if (distance < least_beneath) nearest = i;
      least_beneath = std::min(least_beneath, distance);
      continue;
    }
    const double way = length(place->position - settings.supports[i]);
    if (way <= worth_telling * object.outline().diameter()) continue;
    ++moved;
    most = std::max(most, way);
  }
  std::vector<std::string> notes;
  if (moved > 0)
    notes.push_back(say(moved == 1
                            ? "{number} support was put at the edge, {distance} away"
                            : "{number} supports were put at the edge, at most {distance} away",
                        {moved, in_brief(most)}));
  if (least_beneath <= nearly * placer.snap())
    notes.push_back(
        say("robot {robot} is beneath the object, {distance} from the edge; --snap "
            "{snap} puts it at the edge",
            {nearest + 1, in_brief(least_beneath), enough_for(least_beneath)}));
  return notes;
}

}  // namespace evenlift
