#include "polygon/ring_sweep.h"

#include <algorithm>
#include <set>
#include <vector>

#include "evenlift/predicates.h"

namespace evenlift {
namespace {

using Index = std::size_t;
using Pair = std::pair<Index, Index>;

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
    const Index n = rings.vertices.size();
    ring_of_.reserve(n);
    for (Index ring = 0; ring < rings.size(); ++ring)
      ring_of_.insert(ring_of_.end(), rings.ends[ring] - rings.begin(ring), ring);
    segments_.reserve(n);
    for (Index i = 0; i < n; ++i) {
      const Vec2& p = rings.vertices[i];
      const Vec2& q = rings.vertices[next(i)];
      segments_.push_back(lexicographically_before(p, q) ? Segment{p, q} : Segment{q, p});
    }
    where_.resize(n);
    sweep_.around.resize(rings.size());
    seen_.resize(rings.size());
  }

  RingSweep run(const SortedIndices& order) {
    for (const Index v : order) {
      const Index incident[] = {previous(v), v};
      for (const Index edge : incident) {
        if (segments_[edge].right == rings_.vertices[v]) end(edge);
      }
      for (const Index edge : incident) {
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
    bool operator()(Index a, Index b) const { return sweep->is_below(a, b); }
  };

  bool is_below(Index a, Index b) {
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

  void note(Index a, Index b) {
    if (!sweep_.crossing) sweep_.crossing = std::minmax(a, b);
  }

  void check(Index a, Index b) {
    if (!sweep_.crossing && meet_improperly(segments_[a], segments_[b])) note(a, b);
  }

  void begin(Index edge) {
    if (sweep_.crossing) return;
    const auto place = active_.insert(edge).first;
    where_[edge] = place;
    if (place != active_.begin()) check(*std::prev(place), edge);
    if (std::next(place) != active_.end()) check(edge, *std::next(place));
  }

  void end(Index edge) {
    if (sweep_.crossing) return;
    const auto next = active_.erase(where_[edge]);
    if (next != active_.begin() && next != active_.end()) check(*std::prev(next), *next);
  }

  Index next(Index i) const {
    const Index ring = ring_of_[i];
    return i + 1 == rings_.ends[ring] ? rings_.begin(ring) : i + 1;
  }
  Index previous(Index i) const {
    const Index ring = ring_of_[i];
    return i == rings_.begin(ring) ? rings_.ends[ring] - 1 : i - 1;
  }

  // At a ring's first vertex in sweep order. The ring is inside the ring of the edge below if that
  // ring's inside is above the edge, else beside it.
  void find_around(Index v) {
    const Index ring = ring_of_[v];
    seen_[ring] = true;
    auto place = where_[v];
    if (place != active_.begin() && *std::prev(place) == previous(v)) --place;
    if (place == active_.begin()) return;
    const Index below = *std::prev(place), other = ring_of_[below];
    const bool to_the_right = segments_[below].left == rings_.vertices[below];
    sweep_.around[ring] = to_the_right == rings_.counter_clockwise[other] ? std::optional(other)
                                                                          : sweep_.around[other];
  }

  const Rings& rings_;
  std::vector<Index> ring_of_;  // by vertex
  std::vector<Segment> segments_;
  std::set<Index, Below> active_;
  std::vector<std::set<Index, Below>::iterator> where_;
  std::vector<bool> seen_;  // by ring
  RingSweep sweep_;
};

}  // namespace

RingSweep sweep(const Rings& rings, const SortedIndices& order) { return Sweep(rings).run(order); }

}  // namespace evenlift
