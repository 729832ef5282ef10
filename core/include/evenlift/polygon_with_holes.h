// The object: a simple polygon and its holes, valid by construction. Functions that measure the
// material (area, centroid, coverage) take a PolygonWithHoles. Functions about where robots stand
// and push (chords, candidates, contacts) take its outline, and ignore the holes.
#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "evenlift/document.h"
#include "evenlift/polygon.h"
#include "evenlift/result.h"
#include "evenlift/vec.h"

namespace evenlift {

class PolygonWithHoles {
 public:
  explicit PolygonWithHoles(Polygon outline) : outline_(std::move(outline)) {}

  // Creates an object. The holes must be at most max_holes simple polygons in either orientation.
  // Each hole must be strictly inside the outline, and outside all other holes without touching
  // them. The outline and the holes must have at most max_vertices vertices in all. All decisions
  // are exact. The error names the hole, the vertices or the edges at fault, if any. O(n log n) for
  // all rings, and O(k^2) for k holes.
  static Result<PolygonWithHoles> create(Polygon outline, const std::vector<Points>& holes);

  const Polygon& outline() const { return outline_; }
  // Passes the outline to functions that take a Polygon.
  operator const Polygon&() const { return outline_; }
  const std::vector<Polygon>& holes() const { return holes_; }

  // The area without the holes, rounded to the nearest double, above 0.
  double area() const { return holes_.empty() ? outline_.area() : area_; }
  // The centroid of that area, rounded to the nearest doubles.
  const Vec2& centroid() const { return holes_.empty() ? outline_.centroid() : centroid_; }
  bool convex() const { return holes_.empty() && outline_.convex(); }

  // The boundary as one closed ring: the outline in its orientation, then each hole the other way
  // round. A path leads from the outline's first vertex to a hole near it, from each hole to
  // another near it, and back along the same lines. Since the path adds no area, the ring has the
  // signed area of the object, even after clipping.
  const Points& boundary() const { return holes_.empty() ? outline_.vertices() : boundary_; }

  // The number, from 0, of the hole with the point strictly inside it; empty if there is no such
  // hole. Exact. O(n).
  std::optional<std::size_t> hole_around(const Vec2& point) const;

  // The vertices of each hole, as given.
  std::vector<Points> rings_of_holes() const;

 private:
  Polygon outline_;
  std::vector<Polygon> holes_;
  Points boundary_;  // empty without holes
  double area_ = 0;
  Vec2 centroid_;
};

// The polygon of a document with its holes. The errors are those of Polygon::create() and
// PolygonWithHoles::create(). O(n log n).
Result<PolygonWithHoles> object_of(const Document& document);

// Whether the point is strictly inside the polygon; exact. O(n).
bool is_inside(const Polygon& polygon, const Vec2& point);

}  // namespace evenlift
