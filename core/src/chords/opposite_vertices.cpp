#include "chords/opposite_vertices.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "evenlift/tolerance.h"
#include "evenlift/wording.h"

namespace evenlift {
namespace {

// A vertex relative to C.
struct Seen {
  Vec2 position;
  double arm;  // its distance from C
  std::uint32_t vertex;
};

class Finder {
 public:
  Finder(const Polygon& polygon, const Vec2& centre, const RadialView& view, std::uint64_t most)
      : near_(near_distance(polygon.diameter())), most_(most) {
    for (const std::uint32_t vertex : view.order()) {
      const Vec2 position = polygon.vertex(vertex) - centre;
      const double arm = length(position);
      if (arm > near_) seen_.push_back({position, arm, vertex});
    }
  }

  std::optional<std::vector<OppositeVertices>> run() {
    const std::size_t m = seen_.size();
    for (std::size_t i = 0; i < m; ++i) {
      // Both ways round from i, unless the first way has visited all vertices.
      std::size_t steps = 1;
      while (steps < m && look(i, (i + steps) % m)) ++steps;
      if (steps < m)
        for (steps = 1; look(i, (i + m - steps) % m);) ++steps;
      if (found_.size() > most_) return std::nullopt;
    }
    return std::move(found_);
  }

 private:
  // Notes i and j if they are opposite and i is nearer to C. Returns false if there are too many or
  // if no vertex beyond j that is farther from C than i can be opposite to i: C is within tau L of
  // the line of two vertices with arms a <= b only if the sine of the angle between their lines
  // through C is at most tau L (a + b) / (a b) <= 2 tau L / a.
  bool look(std::size_t i, std::size_t j) {
    const Seen &a = seen_[i], &b = seen_[j];
    const double side = std::fabs(cross(a.position, b.position));
    constexpr double rounding_factor = 1 + 1e-6;  // the order is exact, this test is not
    if (side > rounding_factor * 2 * near_ * b.arm) return false;
    const bool is_nearer = a.arm != b.arm ? a.arm < b.arm : i < j;
    if (is_nearer && are_opposite(a.position, b.position, near_))
      found_.push_back({std::min(a.vertex, b.vertex), std::max(a.vertex, b.vertex)});
    return found_.size() <= most_;
  }

  double near_;
  std::uint64_t most_;
  std::vector<Seen> seen_;  // by direction modulo 180 degrees
  std::vector<OppositeVertices> found_;
};

}  // namespace

bool are_opposite(const Vec2& v, const Vec2& w, double near) {
  return length(v) > near && length(w) > near && dot(v, w) < 0 &&
         std::fabs(cross(v, w)) <= near * length(v - w);
}

std::optional<std::vector<OppositeVertices>> find_opposite_vertices(const Polygon& polygon,
                                                                    const Vec2& centre,
                                                                    const RadialView& view,
                                                                    std::uint64_t most) {
  return Finder(polygon, centre, view, most).run();
}

InputError too_many_opposite_vertices() {
  return {
      ErrorCode::too_many_edge_pairs,
      say("the polygon has more than {most} edge pairs and opposite vertices about its centre of "
          "mass",
          {std::to_string(max_edge_pairs)}),
      {}};
}

}  // namespace evenlift
