#include "chords/radial_view.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "evenlift/predicates.h"
#include "evenlift/tolerance.h"
#include "exact/sorted_indices.h"

namespace evenlift {
namespace {

// A vertex's direction modulo 180 degrees, in [0, 4), about as the angle.
struct Turned {
  double key;
  std::uint32_t vertex;
};

// `u` in [0, 180) degrees.
double turn_key(const Vec2& u) {
  if (u.y() > std::fabs(u.x())) return 2 - u.x() / u.y();
  return u.x() > 0 ? u.y() / u.x() : 4 + u.y() / u.x();
}

// Keys of directions that are rounded once differ by less than 2^-49 from those of the true ones.
constexpr double surely_apart = 0x1p-46;

// Whether the direction from C to v is in [0, 180) degrees.
bool is_forward(const Vec2& centre, const Vec2& v) {
  return v.y() > centre.y() || (v.y() == centre.y() && v.x() > centre.x());
}

}  // namespace

RadialView::RadialView(const Polygon& polygon, const Vec2& centre) {
  sort_vertices(polygon, centre);
  const double near = near_distance(polygon.diagonal());
  arms_.resize(polygon.size());
  for (std::uint32_t edge = 0; edge < polygon.size(); ++edge) {
    const Vec2 &p = polygon.edge_start(edge), &q = polygon.edge_end(edge);
    const double side = orient(centre, p, q);
    const auto next = static_cast<std::uint32_t>(polygon.next(edge));
    arms_[edge].radial = std::fabs(side) <= near * length(q - p);
    arms_[edge].first = side > 0 ? edge : next;
    arms_[edge].last = side > 0 ? next : edge;
    arms_[edge].area = std::fabs(side);  // exchanging p and q changes the sign and no bit else
  }
}

void RadialView::sort_vertices(const Polygon& polygon, const Vec2& centre) {
  const auto n = static_cast<std::uint32_t>(polygon.size());
  std::vector<char> forward(n);
  std::vector<Turned> turned;
  turned.reserve(n);
  for (std::uint32_t v = 0; v < n; ++v) {
    forward[v] = is_forward(centre, polygon.vertex(v));
    if (polygon.vertex(v) == centre) continue;
    const Vec2 u = polygon.vertex(v) - centre;
    turned.push_back({turn_key(forward[v] ? u : Vec2(-u)), v});
  }
  // Twice the signed area between the forward directions of two vertices: exact sign, so the order
  // is a strict weak one.
  const auto turn = [&](std::uint32_t a, std::uint32_t b) {
    const double side = orient(centre, polygon.vertex(a), polygon.vertex(b));
    return forward[a] == forward[b] ? side : -side;
  };
  std::sort(turned.begin(), turned.end(), [](const Turned& a, const Turned& b) {
    return a.key != b.key ? a.key < b.key : a.vertex < b.vertex;
  });
  const auto may_tie = [&](std::size_t k) {
    return turned[k].key - turned[k - 1].key <= surely_apart;
  };
  for (std::size_t begin = 0, end; begin < turned.size(); begin = end) {
    end = begin + 1;
    while (end < turned.size() && may_tie(end)) ++end;
    if (end - begin == 1) continue;
    const std::vector<Turned> run(turned.begin() + static_cast<std::ptrdiff_t>(begin),
                                  turned.begin() + static_cast<std::ptrdiff_t>(end));
    const auto turns_before = [&](std::uint32_t i, std::uint32_t j) {
      const double side = turn(run[i].vertex, run[j].vertex);
      return side != 0 ? side > 0 : run[i].vertex < run[j].vertex;
    };
    std::size_t k = begin;
    for (const std::uint32_t i : sorted_indices(run.size(), turns_before)) turned[k++] = run[i];
  }

  order_.reserve(turned.size());
  positions_.assign(n, 0);
  for (std::uint32_t k = 0; k < turned.size(); ++k) {
    order_.push_back(turned[k].vertex);
    // Within a run that was sorted exactly keys may fall.
    const bool apart = k > 0 && turned[k].key - turned[k - 1].key > surely_apart;
    if (k == 0 || apart || turn(order_[k - 1], order_[k]) != 0) group_begins_.push_back(k);
    positions_[order_[k]] = static_cast<std::uint32_t>(group_begins_.size()) - 1;
  }
  turns_ = static_cast<std::uint32_t>(group_begins_.size());
  group_begins_.push_back(static_cast<std::uint32_t>(order_.size()));
  for (const std::uint32_t v : order_) {
    if (!forward[v]) positions_[v] += turns_;
  }
}

RadialSweep::RadialSweep(const Polygon& polygon, const RadialView& view)
    : polygon_(polygon), view_(view), slots_(polygon.size()) {
  // Before group 0 the line points forward into the interval after the last position, backward into
  // the one after the last group: the edges there are those that run past it.
  for (std::uint32_t edge = 0; edge < polygon.size(); ++edge) {
    if (view.radial(edge)) continue;
    const std::uint32_t from = view.position(view.first(edge));
    const std::uint32_t length = view.steps(from, view.position(view.last(edge)));
    const auto covers = [&](std::uint32_t interval) { return view.steps(from, interval) < length; };
    if (covers(2 * view.turns() - 1)) add(edge, 0);
    if (covers(view.turns() - 1)) add(edge, 1);
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
  for (std::uint32_t group = 0; group < view.turns(); ++group) {
    sweep.leave(group);
    sweep.enter(group, [&](std::uint32_t, bool is_ahead) {
      pairs += is_ahead ? sweep.behind().size() : sweep.ahead().size();
    });
  }
  return pairs;
}

std::optional<InputError> check_number(std::uint64_t number, const char* what) {
  if (number <= max_edge_pairs) return std::nullopt;
  return InputError{ErrorCode::too_many_edge_pairs,
                    "the polygon has " + std::to_string(number) + ' ' + what +
                        " about its centre of mass, more than " + std::to_string(max_edge_pairs),
                    {}};
}

}  // namespace evenlift
