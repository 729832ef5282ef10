#include "polygon/edge_tree.h"

namespace evenlift {
namespace {

constexpr std::uint32_t edges_of_leaf = 3;

Box box_of(const std::vector<LineEnds>& lines, std::uint32_t begin, std::uint32_t end) {
  if (begin == end) return {};
  Box box{lines[begin].start, lines[begin].start};
  for (std::uint32_t line = begin; line < end; ++line) {
    for (const Vec2& p : {lines[line].start, lines[line].end}) {
      box.low = componentwise_min(box.low, p);
      box.high = componentwise_max(box.high, p);
    }
  }
  return box;
}

}  // namespace

std::vector<LineEnds> edges_of(const Points& ring) {
  std::vector<LineEnds> lines;
  lines.reserve(ring.size());
  for (std::size_t i = 0; i < ring.size(); ++i)
    lines.push_back({ring[i], ring[i + 1 == ring.size() ? 0 : i + 1]});
  return lines;
}

EdgeTree::EdgeTree(const Polygon& polygon) : EdgeTree(edges_of(polygon.vertices())) {}

EdgeTree::EdgeTree(const std::vector<LineEnds>& lines) {
  nodes_.reserve(2 * lines.size() / edges_of_leaf + 2);
  build(lines, 0, static_cast<std::uint32_t>(lines.size()));
}

std::uint32_t EdgeTree::build(const std::vector<LineEnds>& lines, std::uint32_t begin,
                              std::uint32_t end) {
  const auto node = static_cast<std::uint32_t>(nodes_.size());
  nodes_.push_back({{}, begin, end, 0, 0});
  if (end - begin <= edges_of_leaf) {
    nodes_[node].box = box_of(lines, begin, end);
    return node;
  }
  const std::uint32_t middle = begin + (end - begin) / 2;
  const std::uint32_t left = build(lines, begin, middle), right = build(lines, middle, end);
  const Box &a = nodes_[left].box, &b = nodes_[right].box;
  nodes_[node] = {{componentwise_min(a.low, b.low), componentwise_max(a.high, b.high)},
                  begin,
                  end,
                  left,
                  right};
  return node;
}

}  // namespace evenlift
