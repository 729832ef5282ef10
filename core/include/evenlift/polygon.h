// A simple polygon, valid by construction.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "evenlift/result.h"
#include "evenlift/vec.h"

namespace evenlift {

enum class Turn : std::int8_t { reflex = -1, straight = 0, convex = 1 };

// A simple polygon without holes: n >= 3 distinct vertices in either orientation. Straight vertices
// (180 degrees) are allowed. Edge i runs from vertex i to vertex i + 1 (cyclic). Immutable.
class Polygon {
 public:
  // Creates a polygon. It is an error if there are too few or too many vertices, if vertices have
  // bad coordinates, are repeated or span no area, if edges cross, touch or overlap, or if the
  // diagonal of the bounding box is below min_diagonal. All decisions are exact, up to the rounding
  // of that diagonal. If one or two vertices or two edges are at fault, the error names them.
  // O(n log n).
  static Result<Polygon> create(Points vertices);

  std::size_t size() const { return vertices_.size(); }
  const Points& vertices() const { return vertices_; }
  const Vec2& vertex(std::size_t i) const { return vertices_[i]; }
  std::size_t next(std::size_t i) const { return i + 1 == vertices_.size() ? 0 : i + 1; }
  std::size_t previous(std::size_t i) const { return i == 0 ? vertices_.size() - 1 : i - 1; }
  const Vec2& edge_start(std::size_t edge) const { return vertices_[edge]; }
  const Vec2& edge_end(std::size_t edge) const { return vertices_[next(edge)]; }

  bool counter_clockwise() const { return counter_clockwise_; }  // in the given order; exact
  bool convex() const { return convex_; }  // no interior angle exceeds 180 degrees; exact
  // L, the greatest distance between two points of the polygon. Unlike the diagonal of the bounding
  // box, it does not change when the object turns.
  double diameter() const { return diameter_; }
  // The diagonal of the bounding box: at least min_diagonal, at most sqrt(2) L.
  double diagonal() const { return diagonal_; }
  // The area, rounded to the nearest double, but above 0 however thin the polygon is.
  double area() const { return area_; }
  // The centroid of the area, rounded to the nearest doubles.
  const Vec2& centroid() const { return centroid_; }

  // Whether the interior angle at vertex i is below 180 degrees (convex), equal (straight) or above
  // (reflex). The vertex counts as straight if its turn is below 90 degrees and the sine of the
  // turn is at most tau; otherwise the decision is exact. O(1).
  Turn turn(std::size_t i) const;

  // Whether vertex i turns by more than 15 degrees, within tau: at a corner if it is convex, into a
  // notch if it is reflex. The vertices of a finely flattened curve are neither. O(1).
  bool is_corner(std::size_t i) const { return turn(i) == Turn::convex && turns_sharply(i); }
  bool is_notch(std::size_t i) const { return turn(i) == Turn::reflex && turns_sharply(i); }

  // The corners of the convex hull, counter-clockwise from the lowest of the leftmost, without
  // straight vertices. Exact. O(1).
  const Points& hull() const { return hull_; }

 private:
  Polygon() = default;
  bool turns_sharply(std::size_t i) const;
  double turn_side(std::size_t i) const;  // exact sign: positive at a convex vertex

  Points vertices_;
  Points hull_;
  Vec2 centroid_;
  double diameter_ = 0;
  double diagonal_ = 0;
  double area_ = 0;
  bool counter_clockwise_ = true;
  bool convex_ = false;
};

// Whether the vertices, which must be those of a valid polygon, run counter-clockwise. Exact. O(n).
bool is_counter_clockwise(const Points& vertices);

// The centre of mass of a polygon without cargo: the given one, or else the centroid. It is an
// error if a coordinate is not finite, if its absolute value exceeds max_coordinate, or if that
// value is below min_coordinate but not 0. It is also an error if the point is not strictly inside
// the polygon's convex hull; this decision is exact. O(h) for h corners of the hull.
Result<Vec2> check_centre_of_mass(const Polygon& polygon, const std::optional<Vec2>& given);

// R, the greatest distance of a vertex from C. O(n).
double farthest_vertex(const Polygon& polygon, const Vec2& centre);

}  // namespace evenlift
