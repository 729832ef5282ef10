// Ties by tolerance are no equivalence, so std::sort cannot be given them. The rule of algorithm.md
// ("those that tie with the best of the remaining stay") as an order: sort by the key, best first,
// then cut into classes of those that tie with the best of the class.
#pragma once

#include <algorithm>

namespace evenlift {

// Sorts [first, last) by key, largest first, and calls visit(begin, end) for each class of ties,
// best first. `ties(best, key)` tells whether a key not larger than the best still ties with it.
// O(m log m).
template <class Iterator, class Key, class Ties, class Visit>
void for_each_tie_class(Iterator first, Iterator last, Key key, Ties ties, Visit visit) {
  if (last - first == 1) return visit(first, last);  // most often; stable_sort would ask for memory
  std::stable_sort(first, last, [&](const auto& a, const auto& b) { return key(a) > key(b); });
  while (first != last) {
    Iterator end = first + 1;
    while (end != last && ties(key(*first), key(*end))) ++end;
    visit(first, end);
    first = end;
  }
}

}  // namespace evenlift
