// Ties by tolerance are no equivalence, so no sort can be given them. The rule of algorithm.md
// ("those that tie with the best of the remaining stay") as an order: sort by the key, best first,
// then cut into classes of those that tie with the best of the class.
#pragma once

#include <cstdint>
#include <span>

#include "exact/sorted_indices.h"

namespace evenlift {

// Sorts indices by key, largest first, and calls visit(class) for each class of ties, best first.
// `ties(best, key)` tells whether a key not larger than the best still ties with it. O(m log m).
template <class Key, class Ties, class Visit>
void for_each_tie_class(std::span<std::uint32_t> indices, Key key, Ties ties, Visit visit) {
  if (indices.size() == 1) return visit(indices);  // most often; sorting would ask for memory
  sort_indices(indices, [&](std::uint32_t i, std::uint32_t j) { return key(i) > key(j); });
  for (std::size_t begin = 0, end; begin < indices.size(); begin = end) {
    end = begin + 1;
    while (end < indices.size() && ties(key(indices[begin]), key(indices[end]))) ++end;
    visit(indices.subspan(begin, end - begin));
  }
}

}  // namespace evenlift
