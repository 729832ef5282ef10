#include "import/joining/joining.h"

#include <algorithm>
#include <cstdint>
#include <tuple>
#include <utility>

#include "evenlift/hull.h"
#include "exact/pseudo_angle.h"

namespace evenlift {
namespace {

using PieceKind = CurvePiece::Kind;

// An edge as seen from its lesser end, so that repeated edges look alike.
struct Look {
  std::size_t low, high;
  PieceKind kind;
  Vec2 first, second;
  double weight;
};

Look look_of(const GraphEdge& edge) {
  const bool back = edge.from > edge.to;
  const CurvePiece& curve = edge.curve;
  Look look{
      std::min(edge.from, edge.to), std::max(edge.from, edge.to), curve.kind, Vec2{}, Vec2{}, 1};
  if (curve.kind == PieceKind::line) return look;
  look.first = curve.kind == PieceKind::cubic && back ? curve.second : curve.first;
  look.second = curve.kind == PieceKind::cubic ? (back ? curve.first : curve.second) : look.first;
  look.weight = curve.kind == PieceKind::conic ? curve.weight : 1;
  return look;
}

auto order_of(const Look& look) {
  return std::tuple(look.low, look.high, look.kind, look.first.x, look.first.y, look.second.x,
                    look.second.y, look.weight);
}

bool same(const Look& a, const Look& b, double near) {
  return a.low == b.low && a.high == b.high && a.kind == b.kind &&
         length(a.first - b.first) <= near && length(a.second - b.second) <= near;
}

// An edge and a direction in one number.
std::size_t half(std::size_t edge, bool back) { return 2 * edge + (back ? 1 : 0); }
std::size_t twin(std::size_t h) { return h ^ 1u; }

class Graph {
 public:
  Graph(const std::vector<GraphEdge>& edges, const Points& nodes)
      : edges_(edges), nodes_(nodes), alive_(edges.size(), 1) {}

  std::vector<Face> faces() {
    prune();
    walks();
    drop_bridges();
    std::vector<Face> faces;
    for (const std::vector<std::size_t>& walk : walks())
      for (const std::vector<std::size_t>& cycle : simple_cycles(walk)) add_face(cycle, faces);
    std::sort(faces.begin(), faces.end(),
              [&](const Face& a, const Face& b) { return key(a) < key(b); });
    return faces;
  }

 private:
  std::size_t start(std::size_t h) const {
    const GraphEdge& edge = edges_[h / 2];
    return h % 2 == 0 ? edge.from : edge.to;
  }

  // Repeatedly removes edges with an end that no other edge shares.
  void prune() {
    std::vector<std::uint32_t> degree(nodes_.size());
    std::vector<std::vector<std::size_t>> at(nodes_.size());
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      if (alive_[e] == 0) continue;
      for (const std::size_t node : {edges_[e].from, edges_[e].to}) {
        ++degree[node];
        at[node].push_back(e);
      }
    }
    std::vector<std::size_t> loose;
    for (std::size_t node = 0; node < nodes_.size(); ++node)
      if (degree[node] == 1) loose.push_back(node);
    while (!loose.empty()) {
      const std::size_t node = loose.back();
      loose.pop_back();
      for (const std::size_t e : at[node]) {
        if (alive_[e] == 0) continue;
        alive_[e] = 0;
        for (const std::size_t end : {edges_[e].from, edges_[e].to})
          if (--degree[end] == 1) loose.push_back(end);
      }
    }
  }

  // The direction of a half-edge at its node, and its bend to the left.
  std::pair<double, double> direction(std::size_t h) const {
    const GraphEdge& edge = edges_[h / 2];
    const CurvePiece& curve = edge.curve;
    const bool back = h % 2 == 1;
    const Vec2 &from = nodes_[edge.from], &to = nodes_[edge.to];
    const Vec2 &here = back ? to : from, &there = back ? from : to;
    if (curve.kind == PieceKind::line) return {pseudo_angle(there - here), 0};
    const Vec2& first = curve.kind == PieceKind::cubic && back ? curve.second : curve.first;
    const Vec2& second = curve.kind == PieceKind::cubic && !back ? curve.second : curve.first;
    Vec2 way = first - here;
    if (one_norm(way) == 0) way = second - here;
    if (one_norm(way) == 0) way = there - here;
    const Vec2 middle =
        curve.kind == PieceKind::conic
            ? Vec2((here + 2 * curve.weight * first + there) / (2 + 2 * curve.weight))
            : Vec2((here + 3 * first + 3 * second + there) / 8);
    const Vec2 chord = middle - here;
    const double square = dot(chord, chord), size = length(way);
    const double bend = square > 0 && size > 0 ? cross(way, chord) / (size * square) : 0;
    return {pseudo_angle(way), bend};
  }

  // Also sets the face to the left of each half-edge.
  std::vector<std::vector<std::size_t>> walks() {
    std::vector<std::tuple<std::size_t, double, double, std::size_t>> around;
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      if (alive_[e] == 0) continue;
      for (const bool back : {false, true}) {
        const std::size_t h = half(e, back);
        const auto [angle, bend] = direction(h);
        around.emplace_back(start(h), angle, bend, h);
      }
    }
    std::sort(around.begin(), around.end());
    // A boundary that arrives at a node leaves it by the next half-edge clockwise.
    std::vector<std::size_t> next(2 * edges_.size());
    for (std::size_t first = 0; first < around.size();) {
      std::size_t last = first;
      const std::size_t node = std::get<0>(around[first]);
      while (last < around.size() && std::get<0>(around[last]) == node) ++last;
      for (std::size_t i = first; i < last; ++i) {
        const std::size_t before = i == first ? last - 1 : i - 1;
        next[twin(std::get<3>(around[i]))] = std::get<3>(around[before]);
      }
      first = last;
    }
    std::vector<std::vector<std::size_t>> walks;
    walk_of_.assign(2 * edges_.size(), SIZE_MAX);
    for (const auto& [node, angle, bend, begin] : around) {
      if (walk_of_[begin] != SIZE_MAX) continue;
      std::vector<std::size_t> walk;
      for (std::size_t h = begin; walk_of_[h] == SIZE_MAX; h = next[h]) {
        walk_of_[h] = walks.size();
        walk.push_back(h);
      }
      walks.push_back(std::move(walk));
    }
    return walks;
  }

  // An edge with the same face on both sides is the only link between two parts.
  void drop_bridges() {
    for (std::size_t e = 0; e < edges_.size(); ++e)
      if (walk_of_[half(e, false)] == walk_of_[half(e, true)]) alive_[e] = 0;
  }

  // A boundary that passes a node twice is several cycles.
  std::vector<std::vector<std::size_t>> simple_cycles(const std::vector<std::size_t>& walk) {
    std::vector<std::vector<std::size_t>> cycles;
    std::vector<std::size_t> path;
    position_.resize(nodes_.size(), SIZE_MAX);
    for (const std::size_t h : walk) {
      position_[start(h)] = path.size();
      path.push_back(h);
      const std::size_t at = position_[start(twin(h))];
      if (at == SIZE_MAX) continue;
      cycles.emplace_back(path.begin() + static_cast<std::ptrdiff_t>(at), path.end());
      for (std::size_t i = at; i < path.size(); ++i) position_[start(path[i])] = SIZE_MAX;
      path.resize(at);
    }
    return cycles;
  }

  bool is_on_line(std::size_t before, std::size_t after) const {
    const GraphEdge &a = edges_[before / 2], &b = edges_[after / 2];
    return before / 2 != after / 2 && a.curve.kind == PieceKind::line &&
           b.curve.kind == PieceKind::line && a.line == b.line;
  }

  void add_face(const std::vector<std::size_t>& cycle, std::vector<Face>& faces) const {
    std::size_t first = cycle.size();
    for (std::size_t i = 0; i < cycle.size(); ++i) {
      const std::size_t before = cycle[i == 0 ? cycle.size() - 1 : i - 1];
      if (is_on_line(before, cycle[i])) continue;
      if (first == cycle.size() || start(cycle[i]) < start(cycle[first])) first = i;
    }
    if (first == cycle.size()) return;
    Face face;
    for (std::size_t i = 0; i < cycle.size(); ++i) {
      const std::size_t h = cycle[(first + i) % cycle.size()];
      face.boundary.push_back({h / 2, h % 2 == 1});
    }
    if (area_of(face) > 0) faces.push_back(std::move(face));
  }

  double area_of(const Face& face) const {
    const Outline outline = outline_of(face, edges_, nodes_);
    const Box box = control_box(outline);
    const double side = std::max(box.size().x, box.size().y);
    if (!(side > 0)) return 0;
    constexpr std::size_t most = 1u << 22;
    const auto points = flatten(outline, side / 1000, most);
    if (!points) return 0;
    return signed_area(*points);
  }

  std::vector<std::size_t> key(const Face& face) const {
    std::vector<std::size_t> nodes;
    for (const HalfEdge& h : face.boundary) {
      nodes.push_back(start(half(h.edge, h.back)));
      if (nodes.size() == 3) break;
    }
    return nodes;
  }

  const std::vector<GraphEdge>& edges_;
  const Points& nodes_;
  std::vector<char> alive_;
  std::vector<std::size_t> walk_of_;
  std::vector<std::size_t> position_;
};

}  // namespace

void drop_repeated(std::vector<GraphEdge>& edges, double near) {
  std::vector<std::pair<Look, std::size_t>> looks;
  for (std::size_t i = 0; i < edges.size(); ++i) looks.emplace_back(look_of(edges[i]), i);
  std::stable_sort(looks.begin(), looks.end(), [&](const auto& a, const auto& b) {
    const auto first = order_of(a.first), second = order_of(b.first);
    return first < second || (first == second && edges[a.second].line < edges[b.second].line);
  });
  std::vector<GraphEdge> kept;
  std::size_t group = 0;  // the first kept edge with these ends
  for (std::size_t i = 0; i < looks.size(); ++i) {
    const Look& look = looks[i].first;
    const bool begins =
        i == 0 || looks[i - 1].first.low != look.low || looks[i - 1].first.high != look.high;
    if (begins) group = kept.size();
    bool repeated = false;
    for (std::size_t k = group; k < kept.size() && !repeated; ++k)
      repeated = same(look_of(kept[k]), look, near);
    if (!repeated) kept.push_back(edges[looks[i].second]);
  }
  edges = std::move(kept);
}

std::vector<Face> faces_of(const std::vector<GraphEdge>& edges, const Points& nodes) {
  return Graph(edges, nodes).faces();
}

Outline outline_of(const Face& face, const std::vector<GraphEdge>& edges, const Points& nodes) {
  Outline outline;
  const HalfEdge& first = face.boundary.front();
  outline.start = nodes[first.back ? edges[first.edge].to : edges[first.edge].from];
  std::size_t line = SIZE_MAX;  // the straight line of the last edge
  for (const auto& [e, back] : face.boundary) {
    const GraphEdge& edge = edges[e];
    CurvePiece curve = edge.curve;
    curve.end = nodes[back ? edge.from : edge.to];
    if (back && curve.kind == PieceKind::cubic) std::swap(curve.first, curve.second);
    const bool straight = curve.kind == PieceKind::line;
    if (straight && line == edge.line)
      outline.pieces.back() = curve;
    else
      outline.pieces.push_back(curve);
    line = straight ? edge.line : SIZE_MAX;
  }
  return outline;
}

}  // namespace evenlift
