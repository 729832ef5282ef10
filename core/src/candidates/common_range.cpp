#include "candidates/common_range.h"

#include <cmath>

#include "evenlift/predicates.h"

namespace evenlift {
namespace {

// The ends of an edge, counter-clockwise as C sees them.
struct SeenEnds {
  std::uint32_t first, last;
};

// The open range of directions in which C sees edge `a` ahead and edge `b` behind, if any. C sees
// `a` and the mirror image of `b` at less than 180 degrees, so the signs of the turns between their
// ends decide everything.
std::optional<EdgePair> common_range(const Polygon& polygon, const Vec2& centre, std::uint32_t a,
                                     SeenEnds of_a, std::uint32_t b, SeenEnds of_b) {
  const Vec2 &p = polygon.vertex(of_a.first), &q = polygon.vertex(of_a.last);
  const Vec2 &r = polygon.vertex(of_b.first), &s = polygon.vertex(of_b.last);
  // Positive if the first point comes before the second; r and s are mirrored in C.
  const double p_r = -orient(centre, p, r), p_s = -orient(centre, p, s),
               r_q = -orient(centre, r, q), q_s = -orient(centre, q, s);
  const bool begins_at_p = p_r <= 0 && p_s > 0, begins_at_r = p_r >= 0 && r_q > 0;
  if (!begins_at_p && !begins_at_r) return std::nullopt;
  EdgePair pair;
  pair.a = a;
  pair.b = b;
  if (begins_at_p) pair.begin_a = of_a.first;
  if (begins_at_r) pair.begin_b = of_b.first;
  if (q_s >= 0) pair.end_a = of_a.last;
  if (q_s <= 0) pair.end_b = of_b.last;
  return pair;
}

// The edge as C sees it, unless it is radial.
std::optional<SeenEnds> ends_of(const Polygon& polygon, const Vec2& centre, std::uint32_t edge,
                                double near) {
  const Vec2 &p = polygon.edge_start(edge), &q = polygon.edge_end(edge);
  const double side = orient(centre, p, q);
  if (std::fabs(side) <= near * length(q - p)) return std::nullopt;
  const auto next = static_cast<std::uint32_t>(polygon.next(edge));
  return side > 0 ? SeenEnds{edge, next} : SeenEnds{next, edge};
}

}  // namespace

std::optional<EdgePair> pair_of_edges(const Polygon& polygon, const Vec2& centre, std::uint32_t a,
                                      std::uint32_t b, double near) {
  const auto of_a = ends_of(polygon, centre, a, near), of_b = ends_of(polygon, centre, b, near);
  if (!of_a || !of_b) return std::nullopt;
  return common_range(polygon, centre, a, *of_a, b, *of_b);
}

}  // namespace evenlift
