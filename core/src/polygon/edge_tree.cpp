#include "polygon/edge_tree.h"

namespace evenlift {
namespace {

constexpr std::uint32_t edges_of_leaf = 3;

Box box_of(const Polygon& polygon, std::uint32_t begin, std::uint32_t end) {
  Box box{polygon.edge_start(begin), polygon.edge_start(begin)};
  for (std::uint32_t edge = begin; edge < end; ++edge) {
    box.low = box.low.cwiseMin(polygon.edge_end(edge));
    box.high = box.high.cwiseMax(polygon.edge_end(edge));
  }
  return box;
}

}  // namespace

EdgeTree::EdgeTree(const Polygon& polygon) {
  nodes_.reserve(2 * polygon.size() / edges_of_leaf + 2);
  build(polygon, 0, static_cast<std::uint32_t>(polygon.size()));
}

std::uint32_t EdgeTree::build(const Polygon& polygon, std::uint32_t begin, std::uint32_t end) {
  const auto node = static_cast<std::uint32_t>(nodes_.size());
  nodes_.push_back({{}, begin, end, 0, 0});
  if (end - begin <= edges_of_leaf) {
    nodes_[node].box = box_of(polygon, begin, end);
    return node;
  }
  const std::uint32_t middle = begin + (end - begin) / 2;
  const std::uint32_t left = build(polygon, begin, middle), right = build(polygon, middle, end);
  const Box &a = nodes_[left].box, &b = nodes_[right].box;
  nodes_[node] = {{a.low.cwiseMin(b.low), a.high.cwiseMax(b.high)}, begin, end, left, right};
  return node;
}

}  // namespace evenlift
