// The object: a simple polygon and the holes in it, valid by construction. Functions that measure
// the material (the area, the centroid, the coverage) take one of these. Functions about where
// robots stand and push (chords, candidates, contacts) take its outline, and cannot see the holes.
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
  // A polygon without holes.
  explicit PolygonWithHoles(Polygon outline) : outline_(std::move(outline)) {}

  // Checks the holes: at most max_holes simple polygons in either orientation, each strictly inside
  // the outline, apart from it and from each other, none in another, with at most max_vertices
  // vertices in all. All decisions are exact. The error names the holes and edges at fault.
  // O(n log n) for all rings at once, and O(k^2) for k holes.
  static Result<PolygonWithHoles> create(Polygon outline, const std::vector<Points>& holes);

  const Polygon& outline() const { return outline_; }
  // The outline, for functions that take a polygon.
  operator const Polygon&() const { return outline_; }
  const std::vector<Polygon>& holes() const { return holes_; }

  // The area without that of the holes, rounded to the nearest double, above 0.
  double area() const { return holes_.empty() ? outline_.area() : area_; }
  // The centroid of that area, rounded to the nearest doubles.
  const Vec2& centroid() const { return holes_.empty() ? outline_.centroid() : centroid_; }
  // Whether the outline is convex and there are no holes.
  bool convex() const { return holes_.empty() && outline_.convex(); }

  // The boundary as one closed ring, in the orientation of the outline: the outline, and then each
  // hole the other way round. A path leads from the outline's first vertex to a hole near it, from
  // each hole to another near it, and from the last hole back along the same lines. So signed areas
  // of the ring, and of what clipping leaves of it, are those of the object.
  const Points& boundary() const { return holes_.empty() ? outline_.vertices() : boundary_; }

  // Whether a point is strictly inside a hole, and in which; exact. O(n).
  std::optional<std::size_t> hole_around(const Vec2& point) const;

  // The vertices of each hole, as given.
  std::vector<Points> rings_of_holes() const;

 private:
  Polygon outline_;
  std::vector<Polygon> holes_;
  Points boundary_;  // empty without holes
  double area_ = 0;
  Vec2 centroid_ = Vec2::Zero();
};

// The object of a document: its polygon with its holes. The errors are those of Polygon::create()
// and PolygonWithHoles::create(). O(n log n).
Result<PolygonWithHoles> object_of(const Document& document);

// Whether a point is strictly inside a polygon; exact. O(n).
bool is_inside(const Polygon& polygon, const Vec2& point);

}  // namespace evenlift
