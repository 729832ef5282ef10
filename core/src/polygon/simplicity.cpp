#include "polygon/simplicity.h"

#include <algorithm>
#include <set>
#include <vector>

#include "evenlift/predicates.h"

namespace evenlift {
namespace {

using Index = std::size_t;
using Pair = std::pair<Index, Index>;

int sign(double value) { return (value > 0) - (value < 0); }

// An edge with its ends in sweep order.
struct Segment {
  Vec2 left, right;
};

// Whether two closed segments have a common point other than a shared end. Neighbours, which share
// an end, have one only if one segment overlaps the other.
bool meet_improperly(const Segment& s, const Segment& t) {
  const int t_left = sign(orient(s.left, s.right, t.left)),
            t_right = sign(orient(s.left, s.right, t.right));
  const int s_left = sign(orient(t.left, t.right, s.left)),
            s_right = sign(orient(t.left, t.right, s.right));
  const bool neighbours =
      s.left == t.left || s.left == t.right || s.right == t.left || s.right == t.right;
  const bool parallel = t_left == 0 && t_right == 0;
  if (parallel) {
    // Collinear segments overlap in more than an end if each begins before the other ends.
    return lexicographically_before(s.left, t.right) && lexicographically_before(t.left, s.right);
  }
  if (neighbours) return false;
  return t_left * t_right <= 0 && s_left * s_right <= 0;
}

class Sweep {
 public:
  explicit Sweep(const Points& vertices) : vertices_(vertices), active_(Below{this}) {
    const Index n = vertices.size();
    segments_.reserve(n);
    for (Index i = 0; i < n; ++i) {
      const Vec2& p = vertices[i];
      const Vec2& q = vertices[i + 1 == n ? 0 : i + 1];
      segments_.push_back(lexicographically_before(p, q) ? Segment{p, q} : Segment{q, p});
    }
    where_.resize(n);
  }

  std::optional<Pair> run(const SortedIndices& order) {
    const Index n = vertices_.size();
    for (const Index v : order) {
      const Index incident[] = {v == 0 ? n - 1 : v - 1, v};
      for (const Index edge : incident) {
        if (segments_[edge].right == vertices_[v]) end(edge);
      }
      for (const Index edge : incident) {
        if (segments_[edge].left == vertices_[v]) begin(edge);
      }
      if (found_) return found_;
    }
    return std::nullopt;
  }

 private:
  // The vertical order of two active segments where the later one begins. It never changes before
  // two segments meet, so the set stays sorted. If the two meet there, `found_` stores them.
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
    if (!found_) found_ = std::minmax(a, b);
  }

  void check(Index a, Index b) {
    if (!found_ && meet_improperly(segments_[a], segments_[b])) note(a, b);
  }

  void begin(Index edge) {
    if (found_) return;
    const auto place = active_.insert(edge).first;
    where_[edge] = place;
    if (place != active_.begin()) check(*std::prev(place), edge);
    if (std::next(place) != active_.end()) check(edge, *std::next(place));
  }

  void end(Index edge) {
    if (found_) return;
    const auto next = active_.erase(where_[edge]);
    if (next != active_.begin() && next != active_.end()) check(*std::prev(next), *next);
  }

  const Points& vertices_;
  std::vector<Segment> segments_;
  std::set<Index, Below> active_;
  std::vector<std::set<Index, Below>::iterator> where_;
  std::optional<Pair> found_;
};

}  // namespace

std::optional<std::pair<std::size_t, std::size_t>> find_crossing(const Points& vertices,
                                                                 const SortedIndices& order) {
  return Sweep(vertices).run(order);
}

}  // namespace evenlift
