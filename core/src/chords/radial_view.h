// The polygon as C sees it: its vertices and edges in the exact order of their directions, and a
// line through C that sweeps over the edges.
//
// Vertices are sorted by direction modulo 180 degrees; vertices with equal directions form a group.
// Position k < direction_count() is the direction of group k in [0, 180) degrees (forward), and
// position k + direction_count() is the opposite direction (backward). An edge that is not radial
// subtends less than 180 degrees at C. So it covers the positions from its first() to its last()
// end, and the sweep compares only integers.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "evenlift/chords.h"
#include "evenlift/polygon.h"

namespace evenlift {

// Whether the direction from C to v is in [0, 180) degrees. O(1).
bool is_forward(const Vec2& centre, const Vec2& v);

class RadialView {
 public:
  // Sorts the vertices by direction. O(n log n).
  RadialView(const Polygon& polygon, const Vec2& centre);

  std::uint32_t direction_count() const { return direction_count_; }
  bool radial(std::uint32_t edge) const { return arms_[edge].radial; }

  // The edge's ends, counter-clockwise as C sees them.
  std::uint32_t first(std::uint32_t edge) const { return arms_[edge].first; }
  std::uint32_t last(std::uint32_t edge) const { return arms_[edge].last; }
  // Twice the area of the triangle of C and the edge: orient(centre, first, last), which is above 0
  // unless the edge is radial.
  double doubled_area(std::uint32_t edge) const { return arms_[edge].doubled_area; }

  // The vertices other than C, sorted by group. A group may contain forward and backward vertices.
  const std::vector<std::uint32_t>& order() const { return order_; }
  std::uint32_t group_begin(std::uint32_t group) const { return group_begins_[group]; }
  std::uint32_t position(std::uint32_t vertex) const { return positions_[vertex]; }
  bool forward(std::uint32_t vertex) const { return positions_[vertex] < direction_count_; }

  // The number of steps counter-clockwise from position `from` to position `to`.
  std::uint32_t steps(std::uint32_t from, std::uint32_t to) const {
    return to >= from ? to - from : to + 2 * direction_count_ - from;
  }

 private:
  struct Arms {
    std::uint32_t first = 0, last = 0;
    double doubled_area = 0;
    bool radial = false;
  };
  void sort_vertices(const Polygon& polygon, const Vec2& centre);

  std::uint32_t direction_count_ = 0;
  std::vector<Arms> arms_;  // by edge
  std::vector<std::uint32_t> order_;
  std::vector<std::uint32_t> group_begins_;  // where groups begin in order_, and order_.size()
  std::vector<std::uint32_t> positions_;     // by vertex
};

// The non-radial edges that a line through C meets, forward and backward, while the line turns from
// 0 to 180 degrees. At each group, the edges that end there leave first, and then the edges that
// begin there enter.
class RadialSweep {
 public:
  RadialSweep(const Polygon& polygon, const RadialView& view);

  const std::vector<std::uint32_t>& ahead() const { return active_[0]; }   // met forward
  const std::vector<std::uint32_t>& behind() const { return active_[1]; }  // met backward

  // Removes the edges that end at the group. Amortized O(1) for each vertex of the group.
  void leave(std::uint32_t group);

  // Adds the edges that begin at the group. Calls visit(edge, is_ahead) just before each is added.
  template <class Visit>
  void enter(std::uint32_t group, Visit&& visit) {
    for_each_edge_at(group, [&](std::uint32_t edge, std::uint32_t vertex) {
      if (view_.first(edge) != vertex) return;
      visit(edge, view_.forward(vertex));
      add(edge, view_.forward(vertex) ? 0 : 1);
    });
  }

 private:
  template <class Visit>
  void for_each_edge_at(std::uint32_t group, Visit&& visit) {
    for (std::uint32_t k = view_.group_begin(group); k < view_.group_begin(group + 1); ++k) {
      const std::uint32_t vertex = view_.order()[k];
      const auto before = static_cast<std::uint32_t>(polygon_.previous(vertex));
      if (!view_.radial(before)) visit(before, vertex);
      if (!view_.radial(vertex)) visit(vertex, vertex);
    }
  }
  void add(std::uint32_t edge, int side);
  void remove(std::uint32_t edge, int side);

  const Polygon& polygon_;
  const RadialView& view_;
  std::vector<std::uint32_t> active_[2];
  std::vector<std::uint32_t> slots_;  // by edge: its index in the list that contains it
};

// The number of edge pairs. O(n).
std::uint64_t count_edge_pairs(const Polygon& polygon, const RadialView& view);

// The error if `number` exceeds max_edge_pairs. `what` is, for example, "edge pairs".
std::optional<InputError> check_number(std::uint64_t number, const char* what);

// Calls visit(const EdgePair&) for each of the K edge pairs, in the order in which their ranges
// begin. O(n + K).
template <class Visit>
void for_each_edge_pair(const Polygon& polygon, const RadialView& view, Visit&& visit) {
  RadialSweep sweep(polygon, view);
  for (std::uint32_t group = 0; group < view.direction_count(); ++group) {
    const auto pair_up = [&](std::uint32_t a, std::uint32_t b) {
      const std::uint32_t here = group, opposite = group + view.direction_count();
      const std::uint32_t steps_a = view.steps(here, view.position(view.last(a)));
      const std::uint32_t steps_b = view.steps(opposite, view.position(view.last(b)));
      EdgePair pair;
      pair.a = a;
      pair.b = b;
      if (view.position(view.first(a)) == here) pair.begin_a = view.first(a);
      if (view.position(view.first(b)) == opposite) pair.begin_b = view.first(b);
      if (steps_a <= steps_b) pair.end_a = view.last(a);
      if (steps_b <= steps_a) pair.end_b = view.last(b);
      visit(pair);
    };
    sweep.leave(group);
    sweep.enter(group, [&](std::uint32_t edge, bool is_ahead) {
      if (is_ahead) {
        for (const std::uint32_t other : sweep.behind()) pair_up(edge, other);
      } else {
        for (const std::uint32_t other : sweep.ahead()) pair_up(other, edge);
      }
    });
  }
}

// --- Finds the vertices that are opposite each other across C (algorithm.md, Opposite vertices).

// Returns the result of opposite_vertices() (chords.h), or nothing if there are more than `most`
// pairs. The cost is that of opposite_vertices() with O(n) in place of O(n log n), since `view` has
// already sorted the vertices.
std::optional<std::vector<OppositeVertices>> find_opposite_vertices(const Polygon& polygon,
                                                                    const Vec2& centre,
                                                                    const RadialView& view,
                                                                    std::uint64_t most);

// Whether two vertices are opposite. `v` and `w` are their offsets from C; `near` is tau L. O(1).
bool are_opposite(const Vec2& v, const Vec2& w, double near);

// The error if there are too many edge pairs and opposite vertices together.
InputError too_many_opposite_vertices();

// --- The arithmetic of chords from a vertex through C, both for vertex-chords and for the ends of
// sections. An edge's section in an edge pair is the part of the edge where the pair's chords end
// (docs/algorithm.md, Edge pairs).

// The point C + factor (C - w), where the ray from C away from vertex w meets the line of an edge.
struct Across {
  double factor = 0;  // > 0, with a relative error of about 2^-45; exactly 1 if C bisects the chord
  int compare_to_one = 0;  // -1, 0, 1: the factor is below, equal to or above 1; exact
};

// Looks from w across C to the edge b c. The ray from C away from w must meet this edge, which must
// be counter-clockwise about C and not radial. `doubled_area` must be orient(centre, b, c). O(1).
Across look_across(const Vec2& centre, const Vec2& w, const Vec2& b, const Vec2& c,
                   double doubled_area);

// Estimates the factor of look_across() by a few multiplications, with a relative error below
// 2^-33. Returns nothing if plain doubles are not that accurate. O(1).
std::optional<double> estimate_across(const Vec2& centre, const Vec2& w, const Vec2& b,
                                      const Vec2& c, double doubled_area);

// The chord from vertex w, on `edge_w`, through C to the point `across` on `edge_hit`. That point
// is the vertex `hit`, unless `hit` is inside_edge.
Chord chord_from_vertex(const Polygon& polygon, const Vec2& centre, std::uint32_t w,
                        std::uint32_t edge_w, const Across& across, std::uint32_t edge_hit,
                        std::uint32_t hit);

// The chord with these ends, in the order that Chord requires. `direction` points from `behind` to
// `ahead`.
Chord order_ends(const LiftingPoint& ahead, double arm_ahead, const LiftingPoint& behind,
                 double arm_behind, const Vec2& direction);

// Whether a direction points from r1 to r2, that is, to the right, or upward if the direction
// counts as vertical.
bool points_right(const Vec2& direction);

// The shorter of two positive lengths divided by the longer.
double load_ratio(double arm1, double arm2);

// Whether the ends of two chords agree within the distance `near`, in either order.
bool same_chord(const Chord& a, const Chord& b, double near);

// --- Finds the boundary points on each of many rays from C.

class RayCaster {
 public:
  // Stores the polygon relative to C. O(n).
  RayCaster(const Polygon& polygon, const Vec2& centre);

  struct Hit {
    double distance = 0;  // from C
    LiftingPoint point;
  };
  // The boundary points on the ray from C in direction u, nearest first, each listed once. A radial
  // edge contributes those of its end vertices that are in this direction; any other edge
  // contributes at most one point. A vertex whose direction agrees with u within tau counts, even
  // if the boundary only touches the ray there. O(n + k log k) for k points.
  std::vector<Hit> hits(const Vec2& u) const;

  // The farthest point where the ray meets one of `edges`. There must be at least one edge; the ray
  // must meet each edge, and no edge may be radial. If the ray misses an edge only through
  // rounding, it counts as meeting the edge's end. O(number of edges).
  Hit farthest(const Vec2& u, const std::vector<std::uint32_t>& edges) const;

  // The point where the ray meets `edge`, under the same conditions. O(1).
  Hit hit_on(const Vec2& u, std::uint32_t edge) const;

 private:
  struct Edge {
    Vec2 start, end;          // relative to C; counter-clockwise about C unless radial
    double doubled_area = 0;  // cross(start, end), computed before these were rounded
    bool radial = false;
  };
  bool meets_vertex(const Vec2& u, std::uint32_t vertex) const;
  std::uint32_t before(std::uint32_t vertex) const;  // the edge that ends at it

  Vec2 centre_;
  std::vector<Edge> edges_;
  Points vertices_;  // relative to C
};

}  // namespace evenlift
