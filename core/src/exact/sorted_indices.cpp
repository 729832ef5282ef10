#include "exact/sorted_indices.h"

#include <algorithm>
#include <numeric>

namespace evenlift {

SortedIndices indices_below(std::size_t n) {
  SortedIndices indices(n);
  std::iota(indices.begin(), indices.end(), std::uint32_t{0});
  return indices;
}

void sort_indices(std::span<std::uint32_t> indices, const void* order, IsBefore is_before) {
  std::stable_sort(indices.begin(), indices.end(),
                   [=](std::uint32_t i, std::uint32_t j) { return is_before(order, i, j); });
}

SortedIndices lexicographic_order(const Points& points) {
  return sorted_indices(points.size(), [&](std::uint32_t i, std::uint32_t j) {
    return lexicographically_before(points[i], points[j]);
  });
}

}  // namespace evenlift
