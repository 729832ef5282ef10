#include "evenlift/polygon.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "evenlift/document.h"
#include "evenlift/hull.h"
#include "evenlift/plane.h"
#include "evenlift/predicates.h"
#include "evenlift/tolerance.h"
#include "exact/sorted_indices.h"
#include "polygon/coordinates.h"
#include "polygon/moments.h"
#include "polygon/ring_sweep.h"

namespace evenlift {
namespace {

InputError at_vertex(ErrorCode code, std::string message, std::size_t i) {
  return {code, std::move(message), {Place::Kind::vertex, i, i, {}}};
}

std::optional<InputError> check_coordinates(const Points& vertices) {
  if (vertices.size() < 3) {
    return InputError{ErrorCode::too_few_vertices, "a polygon needs at least 3 vertices", {}};
  }
  if (vertices.size() > max_vertices) {
    return InputError{ErrorCode::too_many_vertices, "more than 1048576 vertices", {}};
  }
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const Vec2& v = vertices[i];
    if (!std::isfinite(v.x) || !std::isfinite(v.y)) {
      return at_vertex(ErrorCode::bad_coordinate, "a coordinate is not a finite number", i);
    }
    if (std::fabs(v.x) > max_coordinate || std::fabs(v.y) > max_coordinate) {
      return at_vertex(ErrorCode::bad_coordinate, "a coordinate exceeds 1e9 in size", i);
    }
  }
  return std::nullopt;
}

std::optional<InputError> check_repetition(const Points& vertices, const SortedIndices& order) {
  std::optional<Place> first;
  for (std::size_t k = 1; k < order.size(); ++k) {
    if (vertices[order[k - 1]] != vertices[order[k]]) continue;
    const Place place{Place::Kind::vertex, order[k - 1], order[k], {}};
    if (!first || place.other < first->other) first = place;
  }
  if (!first) return std::nullopt;
  return InputError{ErrorCode::repeated_vertex, "two vertices are at the same place", *first};
}

bool all_on_one_line(const Points& vertices) {
  return std::all_of(vertices.begin() + 2, vertices.end(),
                     [&](const Vec2& v) { return orient(vertices[0], vertices[1], v) == 0; });
}

}  // namespace

// The lowest of the leftmost vertices is a corner of the convex hull and never straight: its turn
// is the polygon's.
bool is_counter_clockwise(const Points& vertices) {
  std::size_t lowest = 0;
  for (std::size_t i = 1; i < vertices.size(); ++i) {
    const Vec2 &v = vertices[i], &best = vertices[lowest];
    if (v.x < best.x || (v.x == best.x && v.y < best.y)) lowest = i;
  }
  const std::size_t n = vertices.size();
  return orient(vertices[(lowest + n - 1) % n], vertices[lowest], vertices[(lowest + 1) % n]) > 0;
}

Result<Polygon> Polygon::create(Points vertices) {
  if (auto error = check_coordinates(vertices)) return *error;
  const SortedIndices order = lexicographic_order(vertices);
  if (auto error = check_repetition(vertices, order)) return *error;
  if (all_on_one_line(vertices)) {
    return InputError{
        ErrorCode::no_area, "the polygon has no area: all its vertices are on one line", {}};
  }
  const Rings ring{vertices, {vertices.size()}, {}};
  if (const auto crossing = sweep(ring, order).crossing) {
    return InputError{ErrorCode::edges_cross,
                      "the edges cross, touch or overlap",
                      {Place::Kind::edge, crossing->first, crossing->second, {}}};
  }

  const Box box = bounding_box(vertices);
  if (box.diagonal() < min_diagonal) {
    return InputError{ErrorCode::object_too_small,
                      "the object is too small: its bounding box's diagonal is below 1e-9",
                      {}};
  }
  const auto tiny = std::find_if(vertices.begin(), vertices.end(),
                                 [](const Vec2& v) { return is_too_near_to_0(v); });
  if (tiny != vertices.end()) {
    return at_vertex(ErrorCode::bad_coordinate, "a coordinate is below 1e-100 in size but not 0",
                     static_cast<std::size_t>(tiny - vertices.begin()));
  }

  Polygon polygon;
  const Moments m = moments(vertices, box.low);
  polygon.diagonal_ = box.diagonal();
  polygon.area_ = m.area;
  polygon.centroid_ = m.centroid;
  polygon.counter_clockwise_ = is_counter_clockwise(vertices);
  polygon.hull_ = convex_hull(vertices);
  polygon.diameter_ = evenlift::diameter(polygon.hull_);
  polygon.vertices_ = std::move(vertices);
  polygon.convex_ = true;
  for (std::size_t i = 0; i < polygon.size() && polygon.convex_; ++i) {
    polygon.convex_ = polygon.turn_side(i) >= 0;
  }
  return polygon;
}

Turn Polygon::turn(std::size_t i) const {
  const Vec2 before = vertices_[i] - vertices_[previous(i)],
             after = vertices_[next(i)] - vertices_[i];
  if (directions_agree(before, after)) return Turn::straight;
  return turn_side(i) > 0 ? Turn::convex : Turn::reflex;
}

bool Polygon::turns_sharply(std::size_t i) const {
  constexpr double cosine_of_15_degrees = 0.96592582628906828675;
  const Vec2 before = vertices_[i] - vertices_[previous(i)],
             after = vertices_[next(i)] - vertices_[i];
  return dot(before, after) < (cosine_of_15_degrees - tau) * length(before) * length(after);
}

double Polygon::turn_side(std::size_t i) const {
  const double side = orient(vertices_[previous(i)], vertices_[i], vertices_[next(i)]);
  return counter_clockwise_ ? side : -side;
}

double farthest_vertex(const Polygon& polygon, const Vec2& centre) {
  double squared = 0;
  for (const Vec2& v : polygon.vertices()) squared = std::max(squared, squared_length(v - centre));
  return std::sqrt(squared);
}

}  // namespace evenlift
