#include <algorithm>
#include <cstddef>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "evenlift/hull.h"
#include "evenlift/polygon.h"
#include "evenlift/polygon_with_holes.h"
#include "evenlift/predicates.h"
#include "exact/pseudo_angle.h"
#include "import/joining/joining.h"

namespace evenlift {
namespace {

constexpr std::size_t most_compared = 20'000'000;  // edges, and pairs of them
constexpr std::size_t most_cuts = 200'000;
// Where a union passes a point twice, its two ways are parted by this share of its larger side.
constexpr double parting = 1e-6;

bool overlap(const Box& a, const Box& b) {
  return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y;
}

struct Edge {
  Vec2 from, to;
  std::size_t ring, number;  // the edge after this vertex of the ring
};

Box box_of(const Edge& edge) {
  return {{std::min(edge.from.x, edge.to.x), std::min(edge.from.y, edge.to.y)},
          {std::max(edge.from.x, edge.to.x), std::max(edge.from.y, edge.to.y)}};
}

// The places where two edges meet: ends that lie on the other edge, or the point where they cross. The
// signs are exact; the point of a crossing is rounded.
void meetings(const Edge& a, const Edge& b, Points& found) {
  const double from = orient(a.from, a.to, b.from), to = orient(a.from, a.to, b.to);
  if ((from > 0 && to > 0) || (from < 0 && to < 0)) return;
  const double back = orient(b.from, b.to, a.from), ahead = orient(b.from, b.to, a.to);
  if ((back > 0 && ahead > 0) || (back < 0 && ahead < 0)) return;
  const auto add_end = [&](double side, const Vec2& end, const Edge& other) {
    if (side == 0 && overlap({end, end}, box_of(other))) found.push_back(end);
  };
  add_end(from, b.from, a);
  add_end(to, b.to, a);
  add_end(back, a.from, b);
  add_end(ahead, a.to, b);
  if (from * to < 0 && back * ahead < 0)
    found.push_back(a.from + back / (back - ahead) * (a.to - a.from));
}

class Uniter {
 public:
  explicit Uniter(const std::vector<Points>& rings) : rings_(rings), group_(rings.size()) {
    for (std::size_t i = 0; i < rings.size(); ++i) {
      group_[i] = i;
      boxes_.push_back(bounding_box(rings[i]));
    }
  }

  Uniting unite() {
    if (!find_cuts()) return {rings_, 0};
    std::sort(cuts_.begin(), cuts_.end(), [](const Cut& a, const Cut& b) {
      const auto first = std::tie(a.ring, a.edge, a.far), second = std::tie(b.ring, b.edge, b.far);
      return first < second || (first == second && is_before(a.at, b.at));
    });
    Uniting result;
    std::vector<Points> unions;
    for (std::size_t first = 0; first < rings_.size(); ++first) {
      std::vector<std::size_t> members;
      for (std::size_t i = first; i < rings_.size() && group_of(first) == first; ++i)
        if (group_of(i) == first) members.push_back(i);
      if (members.empty()) continue;
      auto united = members.size() > 1 ? union_of(members) : std::nullopt;
      if (united) {
        result.united += members.size();
        unions.push_back(*united);
        result.rings.push_back(*std::move(united));
      } else {
        for (const std::size_t i : members) result.rings.push_back(rings_[i]);
      }
    }
    drop_enclosed(unions, result);
    return result;
  }

 private:
  struct Cut {
    std::size_t ring, edge;
    double far;  // along the edge
    Vec2 at;
  };

  std::size_t group_of(std::size_t ring) const {
    while (group_[ring] != ring) ring = group_[ring];
    return ring;
  }

  void join_groups(std::size_t a, std::size_t b) {
    const std::size_t first = group_of(a), second = group_of(b);
    group_[std::max(first, second)] = std::min(first, second);
  }

  // False if that would take too long.
  bool find_cuts() {
    std::size_t compared = 0;
    for (std::size_t i = 0; i < rings_.size(); ++i) {
      for (std::size_t j = i + 1; j < rings_.size(); ++j) {
        if (!overlap(boxes_[i], boxes_[j])) continue;
        const std::vector<Edge> ours = edges_in(i, boxes_[j]), theirs = edges_in(j, boxes_[i]);
        compared += rings_[i].size() + rings_[j].size() + ours.size() * theirs.size();
        if (compared > most_compared || !cut_each_other(ours, theirs)) return false;
      }
    }
    return true;
  }

  std::vector<Edge> edges_in(std::size_t ring, const Box& box) const {
    const Points& points = rings_[ring];
    std::vector<Edge> edges;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Edge edge{points[i], points[i + 1 == points.size() ? 0 : i + 1], ring, i};
      if (overlap(box_of(edge), box)) edges.push_back(edge);
    }
    return edges;
  }

  bool cut_each_other(const std::vector<Edge>& ours, const std::vector<Edge>& theirs) {
    Points found;
    for (const Edge& a : ours) {
      if (cuts_.size() > most_cuts) return false;
      for (const Edge& b : theirs) {
        if (!overlap(box_of(a), box_of(b))) continue;
        found.clear();
        meetings(a, b, found);
        if (!found.empty()) join_groups(a.ring, b.ring);
        for (const Vec2& at : found)
          for (const Edge* edge : {&a, &b})
            cuts_.push_back(
                {edge->ring, edge->number, dot(at - edge->from, edge->to - edge->from), at});
      }
    }
    return true;
  }

  // The vertices of the ring and the places where others meet it, in order.
  Points cut_ring(std::size_t ring) const {
    Points cut;
    const auto add = [&](const Vec2& at) {
      if (cut.empty() || cut.back() != at) cut.push_back(at);
    };
    auto next =
        std::lower_bound(cuts_.begin(), cuts_.end(), ring,
                         [](const Cut& each, std::size_t wanted) { return each.ring < wanted; });
    for (std::size_t i = 0; i < rings_[ring].size(); ++i) {
      add(rings_[ring][i]);
      for (; next != cuts_.end() && next->ring == ring && next->edge == i; ++next) add(next->at);
    }
    if (cut.size() > 1 && cut.back() == cut.front()) cut.pop_back();
    return cut;
  }

  std::optional<Points> union_of(const std::vector<std::size_t>& members) const {
    std::vector<std::pair<Vec2, Vec2>> ways;  // each edge in both directions
    for (const std::size_t ring : members) {
      const Points points = cut_ring(ring);
      for (std::size_t i = 0; i < points.size(); ++i) {
        const Vec2 &from = points[i], &to = points[i + 1 == points.size() ? 0 : i + 1];
        ways.emplace_back(from, to);
        ways.emplace_back(to, from);
      }
    }
    const auto comes_first = [](const auto& a, const auto& b) {
      return is_before(a.first, b.first) || (a.first == b.first && is_before(a.second, b.second));
    };
    std::sort(ways.begin(), ways.end(), comes_first);
    ways.erase(std::unique(ways.begin(), ways.end()), ways.end());
    const auto boundary = outer_boundary(ways);
    if (!boundary) return std::nullopt;
    Points points = parted(*boundary);
    if (!Polygon::create(points)) return std::nullopt;
    return points;
  }

  // The outermost way around the edges, counter-clockwise from the first point by x, then y. At each
  // point it turns right as far as it can.
  static std::optional<Points> outer_boundary(const std::vector<std::pair<Vec2, Vec2>>& ways) {
    Points boundary;
    Vec2 at = ways.front().first, back(0, -1);
    std::optional<Vec2> second;
    while (boundary.size() <= ways.size()) {
      auto way = std::lower_bound(
          ways.begin(), ways.end(), at,
          [](const auto& each, const Vec2& p) { return is_before(each.first, p); });
      std::optional<Vec2> next;
      double least = 5;
      for (; way != ways.end() && way->first == at; ++way) {
        double turn = pseudo_angle(way->second - at) - pseudo_angle(back);
        if (turn <= 0) turn += 4;
        if (turn >= least) continue;
        least = turn;
        next = way->second;
      }
      if (!next) return std::nullopt;
      if (at == ways.front().first) {
        if (second == next) return boundary;
        if (!second) second = next;
      }
      boundary.push_back(at);
      back = at - *next;
      at = *next;
    }
    return std::nullopt;
  }

  // A way that passes a point twice is moved there by a parting to its right, which is outside.
  static Points parted(const Points& boundary) {
    Points sorted = boundary;
    std::sort(sorted.begin(), sorted.end(), is_before);
    const Box box = bounding_box(boundary);
    const double most = parting * std::max(box.size().x, box.size().y);
    Points points;
    const std::size_t n = boundary.size();
    for (std::size_t i = 0; i < n; ++i) {
      const Vec2& at = boundary[i];
      const auto [low, high] = std::equal_range(sorted.begin(), sorted.end(), at, is_before);
      if (high - low == 1) {
        points.push_back(at);
        continue;
      }
      const Vec2 in = at - boundary[(i + n - 1) % n], out = boundary[(i + 1) % n] - at;
      const Vec2 right = Vec2(in.y, -in.x) / length(in) + Vec2(out.y, -out.x) / length(out);
      const double size = length(right);
      const Vec2 way = size > 1e-9 ? right / size : in / length(in);
      points.push_back(at + std::min({most, length(in) / 1000, length(out) / 1000}) * way);
    }
    return points;
  }

  // What a union encloses falls out with it.
  static void drop_enclosed(const std::vector<Points>& unions, Uniting& result) {
    for (const Points& united : unions) {
      const auto polygon = Polygon::create(united);
      result.united += std::erase_if(result.rings, [&](const Points& ring) {
        return ring != united && is_inside(*polygon, ring.front());
      });
    }
  }

  const std::vector<Points>& rings_;
  std::vector<std::size_t> group_;  // towards the first ring that each one meets
  std::vector<Box> boxes_;
  std::vector<Cut> cuts_;
};

}  // namespace

Uniting unite_touching(const std::vector<Points>& rings) { return Uniter(rings).unite(); }

}  // namespace evenlift
