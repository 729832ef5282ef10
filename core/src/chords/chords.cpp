#include "evenlift/chords.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "chords/radial_view.h"
#include "evenlift/predicates.h"
#include "evenlift/tolerance.h"
#include "evenlift/wording.h"
#include "exact/pseudo_angle.h"
#include "exact/sorted_indices.h"

namespace evenlift {
namespace {

// Directions are rounded once, so differences of pseudo-angles have errors below 2^-48, and those
// above this threshold are certain.
constexpr double surely_apart = 0x1p-46;

class DirectionSort {
 public:
  DirectionSort(const Polygon& polygon, const Vec2& centre)
      : polygon_(polygon), centre_(centre), is_forward_(polygon.size()) {
    directions_.reserve(polygon.size());
    for (std::uint32_t v = 0; v < polygon.size(); ++v) {
      is_forward_[v] = is_forward(centre, polygon.vertex(v));
      if (polygon.vertex(v) == centre) continue;
      const Vec2 u = polygon.vertex(v) - centre;
      directions_.push_back({half_turn_pseudo_angle(is_forward_[v] ? u : Vec2(-u)), v});
    }
  }

  void run() {
    std::sort(directions_.begin(), directions_.end(), [](const Direction& a, const Direction& b) {
      return a.pseudo_angle != b.pseudo_angle ? a.pseudo_angle < b.pseudo_angle
                                              : a.vertex < b.vertex;
    });
    for (std::size_t begin = 0, end; begin < directions_.size(); begin = end) {
      end = begin + 1;
      while (end < directions_.size() && may_be_out_of_order(end)) ++end;
      if (end - begin > 1) sort_exactly(begin, end);
    }
  }

  std::uint32_t size() const { return static_cast<std::uint32_t>(directions_.size()); }
  std::uint32_t vertex(std::uint32_t k) const { return directions_[k].vertex; }
  bool forward(std::uint32_t vertex) const { return is_forward_[vertex] != 0; }

  // Whether direction k differs from the preceding one.
  bool begins_group(std::uint32_t k) const {
    if (k == 0) return true;
    // Pseudo-angles may decrease within a run that was sorted exactly.
    const bool surely =
        directions_[k].pseudo_angle - directions_[k - 1].pseudo_angle > surely_apart;
    return surely || turn(vertex(k - 1), vertex(k)) != 0;
  }

 private:
  struct Direction {
    double pseudo_angle;
    std::uint32_t vertex;
  };

  // A pseudo-angle in [0, 4) for a direction in [0, 180) degrees.
  static double half_turn_pseudo_angle(const Vec2& u) {
    const double angle = line_pseudo_angle(u);
    return u.x > 0 || u.y > std::fabs(u.x) ? angle : 4 + angle;
  }

  bool may_be_out_of_order(std::size_t k) const {
    return directions_[k].pseudo_angle - directions_[k - 1].pseudo_angle <= surely_apart;
  }

  // Positive if the forward direction of a comes before that of b, 0 if they are equal; exact.
  double turn(std::uint32_t a, std::uint32_t b) const {
    const double side = orient(centre_, polygon_.vertex(a), polygon_.vertex(b));
    return is_forward_[a] == is_forward_[b] ? side : -side;
  }

  void sort_exactly(std::size_t begin, std::size_t end) {
    const std::vector<Direction> run(directions_.begin() + static_cast<std::ptrdiff_t>(begin),
                                     directions_.begin() + static_cast<std::ptrdiff_t>(end));
    const auto comes_before = [&](std::uint32_t i, std::uint32_t j) {
      const double side = turn(run[i].vertex, run[j].vertex);
      return side != 0 ? side > 0 : run[i].vertex < run[j].vertex;
    };
    std::size_t k = begin;
    for (const std::uint32_t i : sorted_indices(run.size(), comes_before))
      directions_[k++] = run[i];
  }

  const Polygon& polygon_;
  const Vec2& centre_;
  std::vector<char> is_forward_;  // by vertex
  std::vector<Direction> directions_;
};

}  // namespace

bool is_forward(const Vec2& centre, const Vec2& v) {
  return v.y > centre.y || (v.y == centre.y && v.x > centre.x);
}

RadialView::RadialView(const Polygon& polygon, const Vec2& centre) {
  sort_vertices(polygon, centre);
  const double near = near_distance(polygon.diameter());
  arms_.resize(polygon.size());
  for (std::uint32_t edge = 0; edge < polygon.size(); ++edge) {
    const Vec2 &p = polygon.edge_start(edge), &q = polygon.edge_end(edge);
    const double side = orient(centre, p, q);
    const auto next = static_cast<std::uint32_t>(polygon.next(edge));
    arms_[edge].radial = std::fabs(side) <= near * length(q - p);
    arms_[edge].first = side > 0 ? edge : next;
    arms_[edge].last = side > 0 ? next : edge;
    arms_[edge].doubled_area = std::fabs(side);  // exchanging p and q changes the sign only
  }
}

void RadialView::sort_vertices(const Polygon& polygon, const Vec2& centre) {
  DirectionSort sorted(polygon, centre);
  sorted.run();
  order_.reserve(sorted.size());
  positions_.assign(polygon.size(), 0);
  for (std::uint32_t k = 0; k < sorted.size(); ++k) {
    order_.push_back(sorted.vertex(k));
    if (sorted.begins_group(k)) group_begins_.push_back(k);
    positions_[order_[k]] = static_cast<std::uint32_t>(group_begins_.size()) - 1;
  }
  direction_count_ = static_cast<std::uint32_t>(group_begins_.size());
  group_begins_.push_back(static_cast<std::uint32_t>(order_.size()));
  for (const std::uint32_t v : order_) {
    if (!sorted.forward(v)) positions_[v] += direction_count_;
  }
}

RadialSweep::RadialSweep(const Polygon& polygon, const RadialView& view)
    : polygon_(polygon), view_(view), slots_(polygon.size()) {
  // Just before group 0, the line points forward into the interval after the last position, and
  // backward into that after the last group. The sweep begins with the edges there.
  for (std::uint32_t edge = 0; edge < polygon.size(); ++edge) {
    if (view.radial(edge)) continue;
    const std::uint32_t from = view.position(view.first(edge));
    const std::uint32_t length = view.steps(from, view.position(view.last(edge)));
    const auto covers = [&](std::uint32_t interval) { return view.steps(from, interval) < length; };
    if (covers(2 * view.direction_count() - 1)) add(edge, 0);
    if (covers(view.direction_count() - 1)) add(edge, 1);
  }
}

void RadialSweep::leave(std::uint32_t group) {
  for_each_edge_at(group, [&](std::uint32_t edge, std::uint32_t vertex) {
    if (view_.last(edge) == vertex) remove(edge, view_.forward(vertex) ? 0 : 1);
  });
}

void RadialSweep::add(std::uint32_t edge, int side) {
  slots_[edge] = static_cast<std::uint32_t>(active_[side].size());
  active_[side].push_back(edge);
}

void RadialSweep::remove(std::uint32_t edge, int side) {
  std::vector<std::uint32_t>& list = active_[side];
  const std::uint32_t last = list.back();
  list[slots_[edge]] = last;
  slots_[last] = slots_[edge];
  list.pop_back();
}

std::uint64_t count_edge_pairs(const Polygon& polygon, const RadialView& view) {
  RadialSweep sweep(polygon, view);
  std::uint64_t pairs = 0;
  for (std::uint32_t group = 0; group < view.direction_count(); ++group) {
    sweep.leave(group);
    sweep.enter(group, [&](std::uint32_t, bool is_ahead) {
      pairs += is_ahead ? sweep.behind().size() : sweep.ahead().size();
    });
  }
  return pairs;
}

std::optional<InputError> check_number(std::uint64_t number, const char* what) {
  if (number <= max_edge_pairs) return std::nullopt;
  return InputError{
      ErrorCode::too_many_edge_pairs,
      say("the polygon has {number} {things} about its centre of mass, more than {most}",
          {std::to_string(number), what, std::to_string(max_edge_pairs)})};
}

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
          {std::to_string(max_edge_pairs)})};
}

namespace {

struct Group {
  std::vector<std::uint32_t> ahead, behind;
  void fill(const RadialView& view, std::uint32_t group) {
    ahead.clear();
    behind.clear();
    for (std::uint32_t k = view.group_begin(group); k < view.group_begin(group + 1); ++k) {
      const std::uint32_t vertex = view.order()[k];
      (view.forward(vertex) ? ahead : behind).push_back(vertex);
    }
  }
};

VertexChord chord_between(const Polygon& polygon, const Vec2& centre, std::uint32_t v,
                          std::uint32_t w) {
  const double arm_v = length(polygon.vertex(v) - centre),
               arm_w = length(polygon.vertex(w) - centre);
  const Across across{arm_w / arm_v, (arm_w > arm_v) - (arm_w < arm_v)};
  return {v, w, chord_from_vertex(polygon, centre, v, v, across, w, w)};
}

VertexChord chord_into(const Polygon& polygon, const Vec2& centre, const RadialView& view,
                       std::uint32_t v, std::uint32_t edge) {
  const Across across = look_across(centre, polygon.vertex(v), polygon.vertex(view.first(edge)),
                                    polygon.vertex(view.last(edge)), view.doubled_area(edge));
  return {v, inside_edge, chord_from_vertex(polygon, centre, v, v, across, edge, inside_edge)};
}

}  // namespace

Points positions(const std::vector<LiftingPoint>& points) {
  Points positions;
  positions.reserve(points.size());
  for (const LiftingPoint& point : points) positions.push_back(point.position);
  return positions;
}

std::vector<bool> radial_edges(const Polygon& polygon, const Vec2& centre) {
  const RadialView view(polygon, centre);
  std::vector<bool> radial(polygon.size());
  for (std::uint32_t edge = 0; edge < polygon.size(); ++edge) radial[edge] = view.radial(edge);
  return radial;
}

Result<std::vector<VertexChord>> vertex_chords(const Polygon& polygon, const Vec2& centre) {
  const RadialView view(polygon, centre);
  RadialSweep sweep(polygon, view);
  std::vector<VertexChord> chords;
  Group group;
  for (std::uint32_t direction = 0; direction < view.direction_count(); ++direction) {
    sweep.leave(direction);
    // Between leaving and entering, the line meets the active edges in their interior.
    group.fill(view, direction);
    const std::uint64_t number =
        chords.size() + group.ahead.size() * (sweep.behind().size() + group.behind.size()) +
        group.behind.size() * sweep.ahead().size();
    if (auto error = check_number(number, "vertex-chords or more")) return *error;
    for (const std::uint32_t v : group.ahead) {
      for (const std::uint32_t w : group.behind)
        chords.push_back(chord_between(polygon, centre, v, w));
      for (const std::uint32_t edge : sweep.behind())
        chords.push_back(chord_into(polygon, centre, view, v, edge));
    }
    for (const std::uint32_t v : group.behind) {
      for (const std::uint32_t edge : sweep.ahead())
        chords.push_back(chord_into(polygon, centre, view, v, edge));
    }
    sweep.enter(direction, [](std::uint32_t, bool) {});
  }
  return chords;
}

std::uint64_t count_edge_pairs(const Polygon& polygon, const Vec2& centre) {
  return count_edge_pairs(polygon, RadialView(polygon, centre));
}

Result<std::vector<EdgePair>> edge_pairs(const Polygon& polygon, const Vec2& centre) {
  const RadialView view(polygon, centre);
  const std::uint64_t number = count_edge_pairs(polygon, view);
  if (auto error = check_number(number, "edge pairs")) return *error;
  std::vector<EdgePair> pairs;
  pairs.reserve(static_cast<std::size_t>(number));
  for_each_edge_pair(polygon, view, [&](const EdgePair& pair) { pairs.push_back(pair); });
  return pairs;
}

Result<std::vector<OppositeVertices>> opposite_vertices(const Polygon& polygon,
                                                        const Vec2& centre) {
  const RadialView view(polygon, centre);
  const std::uint64_t pairs = count_edge_pairs(polygon, view);
  if (auto error = check_number(pairs, "edge pairs")) return *error;
  auto opposite = find_opposite_vertices(polygon, centre, view, max_edge_pairs - pairs);
  if (!opposite) return too_many_opposite_vertices();
  return *std::move(opposite);
}

}  // namespace evenlift
