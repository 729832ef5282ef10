#include "evenlift/supports.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "balanced/search.h"
#include "evenlift/hull.h"
#include "evenlift/numbers.h"
#include "evenlift/plane.h"
#include "evenlift/settings.h"
#include "evenlift/tolerance.h"
#include "evenlift/wording.h"
#include "exact/sorted_indices.h"
#include "numbers/number_text.h"
#include "polygon/corners.h"

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

std::string in_brief(double distance) {
  return as_read(rounded(distance, 1000, Rounding::nearest));
}

std::string in_brief(const Vec2& point) {
  const auto coordinate = [](double value) {
    constexpr std::uint64_t six_digits = 1000000;
    const std::string size = rounded(std::abs(value), six_digits, Rounding::nearest);
    return as_read(value < 0 ? "-" + size : size);
  };
  return say("({x}, {y})", {coordinate(point.x), coordinate(written_y(point.y))});
}

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
  const std::string at = in_brief(support);
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

Result<std::vector<std::optional<LiftingPoint>>> places_of_supports(const PolygonWithHoles& object,
                                                                    const Settings& settings) {
  const SupportPlacer placer(object, settings);
  std::vector<std::optional<LiftingPoint>> places;
  places.reserve(settings.supports.size());
  for (const Vec2& support : settings.supports) {
    if (is_too_near_to_0(support))
      return error_at(places.size(), "a coordinate is below 1e-100 in size but not 0");
    places.push_back(placer.place(support));
  }
  return places;
}

Result<std::vector<LiftingPoint>> place_supports(const PolygonWithHoles& object,
                                                 const Settings& settings) {
  const auto places = places_of_supports(object, settings);
  if (!places) return places.error();
  std::vector<LiftingPoint> points;
  points.reserve(places->size());
  for (const auto& place : *places) {
    if (!place) {
      const std::size_t i = points.size();
      return error_at(i,
                      why_refused(object, SupportPlacer(object, settings), settings.supports[i]));
    }
    points.push_back(*place);
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
    notes.push_back(say(
        "robot {robot} is beneath the object, {distance} from the edge; --snap "
        "{snap} puts it at the edge",
        {support_called(settings, nearest), in_brief(least_beneath), enough_for(least_beneath)}));
  return notes;
}

// --- Places for robots that the user will move.

namespace {

// Rounds to about a thousandth of a length, for short coordinates and links.
class ShortNumbers {
 public:
  explicit ShortNumbers(double length) {
    for (; length * up_ / down_ < 1e3; up_ *= 10) continue;
    for (; length * up_ / down_ >= 1e4; down_ *= 10) continue;
  }
  double operator()(double value) const { return std::round(value * up_ / down_) * down_ / up_; }

 private:
  double up_ = 1, down_ = 1;  // powers of ten; one of them is 1
};

// Places along the sides of a square, from its lower left corner; none if one is outside the
// object. `size` is half a side.
Points on_square(const SupportPlacer& placer, const ShortNumbers& rounded, const Vec2& middle,
                 double size, std::size_t robots) {
  Points supports;
  for (std::size_t i = 0; i < robots; ++i) {
    const double way = 4.0 * static_cast<double>(i) / static_cast<double>(robots);
    const double part = 2 * (way - std::floor(way)) - 1;
    const Vec2 leg = way < 1   ? Vec2(part, -1)
                     : way < 2 ? Vec2(1, part)
                     : way < 3 ? Vec2(-part, 1)
                               : Vec2(-1, -part);
    const Vec2 at = middle + size * leg;
    const Vec2 short_at(rounded(at.x), rounded(at.y));
    if (!placer.place(short_at)) return {};
    supports.push_back(short_at);
  }
  return supports;
}

// Offsets of the square's middle from C, in units of `size`: `wanted`, then others with C inside
// the square, the nearest to `wanted` first.
std::vector<Vec2> middles(const Vec2& wanted) {
  std::vector<Vec2> all = {wanted};
  for (int x = -3; x <= 3; ++x)
    for (int y = -3; y <= 3; ++y) all.push_back(Vec2(0.3 * x, 0.3 * y));
  sort_items(all,
             [&](const Vec2& a, const Vec2& b) { return length(a - wanted) < length(b - wanted); });
  return all;
}

}  // namespace

Points supports_to_place(const PolygonWithHoles& object, const Vec2& centre, std::size_t robots,
                         const Settings& settings) {
  const Polygon& polygon = object.outline();
  Vec2 corner = centre;
  for (const Vec2& vertex : polygon.vertices())
    if (length(vertex - centre) > length(corner - centre)) corner = vertex;
  const SupportPlacer placer(object, settings);
  const double diameter = polygon.diameter(), largest = 0.15 * diameter;
  const ShortNumbers rounded(diameter);
  const std::vector<Vec2> offsets = middles(0.8 / length(corner - centre) * (corner - centre));
  const auto fits = [&](const Vec2& offset, double size) {
    return on_square(placer, rounded, centre + size * offset, size, robots);
  };
  for (const double size : {largest, largest / 2})
    if (Points supports = fits(offsets[0], size); !supports.empty()) return supports;
  // On smaller squares robots hide each other, so the middle may be elsewhere.
  for (double size = largest; size > 1e-3 * diameter; size /= 2)
    for (const Vec2& offset : offsets)
      if (Points supports = fits(offset, size); !supports.empty()) return supports;
  return Points(robots, polygon.vertex(0));
}

namespace {

Misfit::Why why_misfit(WhyUnusable why, const RobotSize& robot) {
  switch (why) {
    case WhyUnusable::no_go:
    case WhyUnusable::near_no_go:
      return Misfit::Why::no_go;
    case WhyUnusable::arm:
      return Misfit::Why::arm;
    case WhyUnusable::hand:
      return Misfit::Why::hand;
    case WhyUnusable::hole:
      return Misfit::Why::hole;
    case WhyUnusable::corner:
      return robot.depth > 0 || robot.width > 0 ? Misfit::Why::hand : Misfit::Why::outside;
    case WhyUnusable::body:
    case WhyUnusable::narrow:
      break;
  }
  return Misfit::Why::outside;
}

}  // namespace

std::vector<Misfit> misfits(const Polygon& polygon, const Stands* stands,
                            const std::vector<LiftingPoint>& robots) {
  const double near = near_distance(polygon.diameter());
  std::vector<Misfit> found;
  for (std::uint32_t i = 0; i < robots.size(); ++i) {
    const LiftingPoint& robot = robots[i];
    if (stands && robot.edge != beneath)
      if (const auto why = stands->why_not(robot.edge, stands->along(robot)))
        found.push_back({i, why_misfit(*why, stands->robot()), 0});
    for (std::uint32_t other = 0; other < i; ++other)
      if (length(robot.position - robots[other].position) <= near ||
          (stands && stands->collide(robot, robots[other])))
        found.push_back({i, Misfit::Why::too_near, other});
  }
  return found;
}

std::string misfit_in_words(const Misfit& misfit) {
  switch (misfit.why) {
    case Misfit::Why::outside:
      return "outside";
    case Misfit::Why::arm:
      return "arm";
    case Misfit::Why::hand:
      return "hand";
    case Misfit::Why::hole:
      return "hole";
    case Misfit::Why::no_go:
      return "no-go";
    case Misfit::Why::too_near:
      break;
  }
  return "too near robot " + std::to_string(misfit.other + 1);
}

namespace {

using Robots = std::vector<LiftingPoint>;

Vec2 centroid_of(const Robots& robots) {
  Vec2 sum;
  for (const LiftingPoint& robot : robots) sum += robot.position;
  return sum / static_cast<double>(robots.size());
}

// The best move so far, by the sum of squared displacements.
class NearestEven {
 public:
  NearestEven(const balanced::Rules& rules, const Robots& robots)
      : rules_(rules), robots_(robots) {}

  // Tries all places of robots i < j, perhaps with a third at `place`.
  void try_two(std::size_t i, std::size_t j, std::optional<std::size_t> third = std::nullopt,
               const LiftingPoint& place = {}) {
    Robots all = robots_;
    if (third) all[*third] = place;
    const double before = third ? square(place, robots_[*third]) : 0;
    if (best_ && !(before < least_)) return;
    Robots others, staying;
    for (std::size_t k = 0; k < all.size(); ++k) {
      if (k == i || k == j) continue;
      others.push_back(all[k]);
      if (k != third) staying.push_back(all[k]);
    }
    if (third && rules_.collides(staying, staying.size(), place)) return;
    for (const Candidate& candidate : balanced::all_pairs_to_complete(rules_, others)) {
      const LiftingPoint &r1 = candidate.chord.r1, &r2 = candidate.chord.r2;
      for (const auto& ends : {std::array{r1, r2}, std::array{r2, r1}}) {
        const double way = before + square(ends[0], robots_[i]) + square(ends[1], robots_[j]);
        if (best_ && !(way < least_)) continue;
        if (rules_.collides(others, others.size(), r1) ||
            rules_.collides(others, others.size(), r2))
          continue;
        all[i] = ends[0];
        all[j] = ends[1];
        best_ = all;
        least_ = way;
      }
    }
  }

  const std::optional<Robots>& best() const { return best_; }

 private:
  static double square(const LiftingPoint& a, const LiftingPoint& b) {
    return squared_length(a.position - b.position);
  }

  const balanced::Rules& rules_;
  const Robots& robots_;
  std::optional<Robots> best_;
  double least_ = 0;
};

}  // namespace

std::optional<Robots> even_out(const BalancedProblem& problem, const Robots& robots) {
  const std::size_t m = robots.size();
  const double near = near_distance(problem.rules().polygon().diameter());
  if (m > 0 && length(centroid_of(robots) - problem.rules().centre()) <= near) return robots;
  NearestEven nearest(problem.rules(), robots);
  for (std::size_t i = 0; i < m; ++i)
    for (std::size_t j = i + 1; j < m; ++j) nearest.try_two(i, j);
  if (nearest.best() || m > most_evened_by_three) return nearest.best();
  for (std::size_t third = 0; third < m; ++third)
    for (const LiftingPoint& place : problem.rules().stands())
      for (std::size_t i = 0; i < m; ++i)
        for (std::size_t j = i + 1; j < m; ++j)
          if (i != third && j != third) nearest.try_two(i, j, third, place);
  return nearest.best();
}

}  // namespace evenlift
