// Ties within a tolerance are not transitive, so a sort cannot use them. Candidate order
// (algorithm.md, Order and duplicates) therefore sorts by the key, then cuts the list into classes
// whose members all tie with the best of their class.
#pragma once

#include <cstdint>
#include <span>

#include "exact/sorted_indices.h"

namespace evenlift {

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
