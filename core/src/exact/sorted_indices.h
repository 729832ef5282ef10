// Sorts indices. All orders share one instantiation of std::stable_sort by type erasure, since six
// instantiations added 9 KB to the compressed web page. The code for candidates and selection,
// where most of the sorting is done, has sorts of its own.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "evenlift/vec.h"

namespace evenlift {

using SortedIndices = std::vector<std::uint32_t>;

// Whether element i comes before element j in the order to which `order` points.
using IsBefore = bool (*)(const void* order, std::uint32_t i, std::uint32_t j);
void sort_indices(std::span<std::uint32_t> indices, const void* order, IsBefore is_before);

// Sorts stably by before(i, j), which must be a strict weak order. O(n log n) calls.
template <class Before>
void sort_indices(std::span<std::uint32_t> indices, const Before& before) {
  sort_indices(indices, &before, [](const void* order, std::uint32_t i, std::uint32_t j) {
    return static_cast<bool>((*static_cast<const Before*>(order))(i, j));
  });
}

// The indices 0 ... n - 1. O(n).
SortedIndices indices_below(std::size_t n);

// The indices 0 ... n - 1, sorted by sort_indices(). n must be below 2^32. O(n log n) calls.
template <class Before>
SortedIndices sorted_indices(std::size_t n, const Before& before) {
  SortedIndices indices = indices_below(n);
  sort_indices(indices, before);
  return indices;
}

// Sorts items stably by before(a, b), through their indices. O(n log n) calls, and a move of each item.
template <class Item, class Before>
void sort_items(std::vector<Item>& items, const Before& before) {
  std::vector<Item> sorted;
  sorted.reserve(items.size());
  for (const std::uint32_t i : sorted_indices(items.size(), [&](std::uint32_t a, std::uint32_t b) {
         return before(items[a], items[b]);
       }))
    sorted.push_back(std::move(items[i]));
  items = std::move(sorted);
}

inline bool lexicographically_before(const Vec2& a, const Vec2& b) {
  return a.x != b.x ? a.x < b.x : a.y < b.y;
}

// The indices of the points, sorted by x, then by y, then by index. O(n log n).
SortedIndices lexicographic_order(const Points& points);

// --- Ties within a tolerance are not transitive, so a sort cannot use them. Candidate order
// (algorithm.md, Order and duplicates) therefore sorts by the key, then cuts the list into classes
// whose members all tie with the best of their class.

// Sorts indices by key, largest first, and calls visit(span) with the indices of each class.
// ties(best, key) must return whether a key that is not larger than the best key ties with it. O(m
// log m) for m indices.
template <class Key, class Ties, class Visit>
void for_each_tie_class(std::span<std::uint32_t> indices, Key key, Ties ties, Visit visit) {
  if (indices.size() == 1) return visit(indices);  // the most frequent case; sorting would allocate
  sort_indices(indices, [&](std::uint32_t i, std::uint32_t j) { return key(i) > key(j); });
  for (std::size_t begin = 0, end; begin < indices.size(); begin = end) {
    end = begin + 1;
    while (end < indices.size() && ties(key(indices[begin]), key(indices[end]))) ++end;
    visit(indices.subspan(begin, end - begin));
  }
}

}  // namespace evenlift
