#include "evenlift/polygon_with_holes.h"

#include <algorithm>
#include <string>
#include <utility>

#include "evenlift/plane.h"
#include "evenlift/predicates.h"
#include "evenlift/wording.h"
#include "exact/sorted_indices.h"
#include "polygon/moments.h"
#include "polygon/ring_sweep.h"

namespace evenlift {
namespace {

// Ring 0 is the outline, ring k is hole k - 1.
InputError in_hole(std::size_t hole, InputError error) {
  if (error.place.kind == Place::Kind::nowhere) error.place.kind = Place::Kind::hole;
  error.place.ring = error.place.other_ring = hole + 1;
  return error;
}

Rings rings_of(const Polygon& outline, const std::vector<Polygon>& holes) {
  Rings rings;
  const auto add = [&](const Polygon& ring) {
    rings.vertices.insert(rings.vertices.end(), ring.vertices().begin(), ring.vertices().end());
    rings.ends.push_back(rings.vertices.size());
    rings.counter_clockwise.push_back(ring.counter_clockwise());
  };
  add(outline);
  for (const Polygon& hole : holes) add(hole);
  return rings;
}

// The vertex or edge of the later ring comes first.
Place place_of(const Rings& rings, Place::Kind kind, std::size_t a, std::size_t b) {
  const auto ring_of = [&](std::size_t i) {
    return static_cast<std::size_t>(std::upper_bound(rings.ends.begin(), rings.ends.end(), i) -
                                    rings.ends.begin());
  };
  if (ring_of(a) < ring_of(b)) std::swap(a, b);
  Place place{kind, a - rings.begin(ring_of(a)), b - rings.begin(ring_of(b)), {}};
  place.ring = ring_of(a);
  place.other_ring = ring_of(b);
  return place;
}

std::optional<InputError> check_apart(const Rings& rings, const SortedIndices& order) {
  for (std::size_t k = 1; k < order.size(); ++k)
    if (rings.vertices[order[k - 1]] == rings.vertices[order[k]])
      return InputError{ErrorCode::edges_cross, "a hole touches the outline or another hole",
                        place_of(rings, Place::Kind::vertex, order[k - 1], order[k])};
  return std::nullopt;
}

std::optional<InputError> check_inside(const RingSweep& swept) {
  for (std::size_t hole = 0; hole + 1 < swept.around.size(); ++hole) {
    const std::optional<std::size_t> around = swept.around[hole + 1];
    if (around == std::size_t{0}) continue;
    return in_hole(hole, {ErrorCode::hole_outside,
                          around ? say("the hole lies in hole {hole}", {*around})
                                 : "the hole lies outside the polygon",
                          {}});
  }
  return std::nullopt;
}

std::optional<InputError> check_rings(const Rings& rings) {
  if (rings.vertices.size() > max_vertices)
    return InputError{
        ErrorCode::too_many_vertices, "more than 1048576 vertices together with the holes", {}};
  const SortedIndices order = lexicographic_order(rings.vertices);
  if (auto error = check_apart(rings, order)) return error;
  const RingSweep swept = sweep(rings, order);
  if (swept.crossing)
    return InputError{
        ErrorCode::edges_cross, "the edges cross, touch or overlap",
        place_of(rings, Place::Kind::edge, swept.crossing->first, swept.crossing->second)};
  return check_inside(swept);
}

// Orders holes so that each is near the one before: the paths between them are short, and few cross
// an edge of H. O(k^2) for k holes.
std::vector<const Polygon*> chain_of(Vec2 at, const std::vector<Polygon>& holes) {
  std::vector<const Polygon*> chain;
  for (const Polygon& hole : holes) chain.push_back(&hole);
  const auto distance = [&](const Polygon* hole) {
    const Vec2 way = hole->vertex(0) - at;
    return dot(way, way);
  };
  for (auto next = chain.begin(); next != chain.end(); ++next) {
    std::iter_swap(next, std::min_element(next, chain.end(), [&](const auto* a, const auto* b) {
                     return distance(a) < distance(b);
                   }));
    at = (*next)->vertex(0);
  }
  return chain;
}

Points boundary_of(const Polygon& outline, const std::vector<Polygon>& holes) {
  Points ring = outline.vertices(), way;
  ring.push_back(Vec2(ring.front()));
  for (const Polygon* hole : chain_of(outline.vertex(0), holes)) {
    Points around = hole->vertices();
    if (hole->counter_clockwise() == outline.counter_clockwise())
      std::reverse(around.begin(), around.end());
    ring.insert(ring.end(), around.begin(), around.end());
    ring.push_back(around.front());
    way.push_back(around.front());
  }
  way.pop_back();
  ring.insert(ring.end(), way.rbegin(), way.rend());
  return ring;
}

}  // namespace

Result<PolygonWithHoles> PolygonWithHoles::create(Polygon outline,
                                                  const std::vector<Points>& holes) {
  PolygonWithHoles object(std::move(outline));
  if (holes.empty()) return object;
  if (holes.size() > max_holes)
    return InputError{ErrorCode::too_many_vertices, "more than 1000 holes", {}};
  for (std::size_t i = 0; i < holes.size(); ++i) {
    auto hole = Polygon::create(holes[i]);
    if (!hole) return in_hole(i, hole.error());
    object.holes_.push_back(*std::move(hole));
  }
  if (auto error = check_rings(rings_of(object.outline_, object.holes_))) return *std::move(error);

  object.boundary_ = boundary_of(object.outline_, object.holes_);
  const Moments m = moments(object.boundary_, bounding_box(object.outline_.vertices()).low);
  object.area_ = m.area;
  object.centroid_ = m.centroid;
  return object;
}

std::optional<std::size_t> PolygonWithHoles::hole_around(const Vec2& point) const {
  for (std::size_t i = 0; i < holes_.size(); ++i)
    if (is_inside(holes_[i], point)) return i;
  return std::nullopt;
}

std::vector<Points> PolygonWithHoles::rings_of_holes() const {
  std::vector<Points> rings;
  for (const Polygon& hole : holes_) rings.push_back(hole.vertices());
  return rings;
}

Result<PolygonWithHoles> object_of(const Document& document) {
  auto outline = Polygon::create(document.vertices);
  if (!outline) return outline.error();
  return PolygonWithHoles::create(*std::move(outline), document.holes);
}

// The ray to the right crosses the boundary an odd number of times.
bool is_inside(const Polygon& polygon, const Vec2& point) {
  bool odd = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 &a = polygon.edge_start(i), &b = polygon.edge_end(i);
    if (std::max(a.y, b.y) < point.y || std::min(a.y, b.y) > point.y) continue;
    const double side = orient(a, b, point);
    if (side == 0 && std::min(a.x, b.x) <= point.x && point.x <= std::max(a.x, b.x))
      return false;  // on the boundary
    if ((a.y > point.y) == (b.y > point.y)) continue;
    if (b.y > a.y ? side > 0 : side < 0) odd = !odd;
  }
  return odd;
}

}  // namespace evenlift
