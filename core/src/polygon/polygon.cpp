#include "evenlift/polygon.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "evenlift/document.h"
#include "evenlift/hull.h"
#include "evenlift/plane.h"
#include "evenlift/polygon_with_holes.h"
#include "evenlift/predicates.h"
#include "evenlift/tolerance.h"
#include "evenlift/wording.h"
#include "exact/sorted_indices.h"
#include "polygon/corners.h"
#include "polygon/half_planes.h"

namespace evenlift {
namespace {

using EdgeIndex = std::size_t;
using Pair = std::pair<EdgeIndex, EdgeIndex>;

int sign(double value) { return (value > 0) - (value < 0); }

// Ends are in sweep order.
struct Segment {
  Vec2 left, right;
};

// Whether two closed segments have a common point other than a shared end. Neighbours, which share
// one, do only if they overlap.
bool meet_improperly(const Segment& s, const Segment& t) {
  const int t_left = sign(orient(s.left, s.right, t.left)),
            t_right = sign(orient(s.left, s.right, t.right));
  const int s_left = sign(orient(t.left, t.right, s.left)),
            s_right = sign(orient(t.left, t.right, s.right));
  const bool neighbours =
      s.left == t.left || s.left == t.right || s.right == t.left || s.right == t.right;
  const bool parallel = t_left == 0 && t_right == 0;
  if (parallel) {
    // Collinear segments share more than an end if each begins before the other ends.
    return lexicographically_before(s.left, t.right) && lexicographically_before(t.left, s.right);
  }
  if (neighbours) return false;
  return t_left * t_right <= 0 && s_left * s_right <= 0;
}

class Sweep {
 public:
  explicit Sweep(const Rings& rings) : rings_(rings), active_(Below{this}) {
    const EdgeIndex n = rings.vertices.size();
    ring_of_.reserve(n);
    for (EdgeIndex ring = 0; ring < rings.size(); ++ring)
      ring_of_.insert(ring_of_.end(), rings.ends[ring] - rings.begin(ring), ring);
    segments_.reserve(n);
    for (EdgeIndex i = 0; i < n; ++i) {
      const Vec2& p = rings.vertices[i];
      const Vec2& q = rings.vertices[next(i)];
      segments_.push_back(lexicographically_before(p, q) ? Segment{p, q} : Segment{q, p});
    }
    where_.resize(n);
    sweep_.around.resize(rings.size());
    seen_.resize(rings.size());
  }

  RingSweep run(const SortedIndices& order) {
    for (const EdgeIndex v : order) {
      const EdgeIndex incident[] = {previous(v), v};
      for (const EdgeIndex edge : incident) {
        if (segments_[edge].right == rings_.vertices[v]) end(edge);
      }
      for (const EdgeIndex edge : incident) {
        if (segments_[edge].left == rings_.vertices[v]) begin(edge);
      }
      if (sweep_.crossing) break;
      if (!seen_[ring_of_[v]]) find_around(v);
    }
    return std::move(sweep_);
  }

 private:
  // The vertical order of two active segments where the later one begins. It never changes before
  // two segments meet, so the set stays sorted. `sweep_.crossing` stores two that meet there.
  struct Below {
    Sweep* sweep;
    bool operator()(EdgeIndex a, EdgeIndex b) const { return sweep->is_below(a, b); }
  };

  bool is_below(EdgeIndex a, EdgeIndex b) {
    if (a == b) return false;
    const Segment& s = segments_[a];
    const Segment& t = segments_[b];
    double side = 0;  // positive: t above s
    if (s.left == t.left) {
      side = orient(s.left, s.right, t.right);
    } else if (lexicographically_before(s.left, t.left)) {
      side = orient(s.left, s.right, t.left);
    } else {
      side = -orient(t.left, t.right, s.left);
    }
    if (side == 0) {
      note(a, b);
      return a < b;
    }
    return side > 0;
  }

  void note(EdgeIndex a, EdgeIndex b) {
    if (!sweep_.crossing) sweep_.crossing = std::minmax(a, b);
  }

  void check(EdgeIndex a, EdgeIndex b) {
    if (!sweep_.crossing && meet_improperly(segments_[a], segments_[b])) note(a, b);
  }

  void begin(EdgeIndex edge) {
    if (sweep_.crossing) return;
    const auto place = active_.insert(edge).first;
    where_[edge] = place;
    if (place != active_.begin()) check(*std::prev(place), edge);
    if (std::next(place) != active_.end()) check(edge, *std::next(place));
  }

  void end(EdgeIndex edge) {
    if (sweep_.crossing) return;
    const auto next = active_.erase(where_[edge]);
    if (next != active_.begin() && next != active_.end()) check(*std::prev(next), *next);
  }

  EdgeIndex next(EdgeIndex i) const {
    const EdgeIndex ring = ring_of_[i];
    return i + 1 == rings_.ends[ring] ? rings_.begin(ring) : i + 1;
  }
  EdgeIndex previous(EdgeIndex i) const {
    const EdgeIndex ring = ring_of_[i];
    return i == rings_.begin(ring) ? rings_.ends[ring] - 1 : i - 1;
  }

  // At a ring's first vertex in sweep order. The ring is inside the ring of the edge below if that
  // ring's inside is above the edge, else beside it.
  void find_around(EdgeIndex v) {
    const EdgeIndex ring = ring_of_[v];
    seen_[ring] = true;
    auto place = where_[v];
    if (place != active_.begin() && *std::prev(place) == previous(v)) --place;
    if (place == active_.begin()) return;
    const EdgeIndex below = *std::prev(place), other = ring_of_[below];
    const bool to_the_right = segments_[below].left == rings_.vertices[below];
    sweep_.around[ring] = to_the_right == rings_.counter_clockwise[other] ? std::optional(other)
                                                                          : sweep_.around[other];
  }

  const Rings& rings_;
  std::vector<EdgeIndex> ring_of_;  // by vertex
  std::vector<Segment> segments_;
  std::set<EdgeIndex, Below> active_;
  std::vector<std::set<EdgeIndex, Below>::iterator> where_;
  std::vector<bool> seen_;  // by ring
  RingSweep sweep_;
};

}  // namespace

RingSweep sweep(const Rings& rings, const SortedIndices& order) { return Sweep(rings).run(order); }

namespace {

InputError at_vertex(ErrorCode code, std::string message, std::size_t i) {
  return {code, std::move(message), {Place::Kind::vertex, i, i, {}}};
}

std::optional<InputError> check_coordinates(const Points& vertices) {
  if (vertices.size() < 3) {
    return InputError{ErrorCode::too_few_vertices, "a polygon needs at least 3 vertices"};
  }
  if (vertices.size() > max_vertices) {
    return InputError{ErrorCode::too_many_vertices, "more than 1048576 vertices"};
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
    return InputError{ErrorCode::no_area,
                      "the polygon has no area: all its vertices are on one line"};
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
                      "the object is too small: its bounding box's diagonal is below 1e-9"};
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
    return in_hole(hole,
                   {ErrorCode::hole_outside, around ? say("the hole lies in hole {hole}", {*around})
                                                    : "the hole lies outside the polygon"});
  }
  return std::nullopt;
}

std::optional<InputError> check_rings(const Rings& rings) {
  if (rings.vertices.size() > max_vertices)
    return InputError{ErrorCode::too_many_vertices,
                      "more than 1048576 vertices together with the holes"};
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
    return InputError{ErrorCode::too_many_vertices, "more than 1000 holes"};
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
