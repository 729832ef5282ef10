#include "selection/tie_order.h"

#include <algorithm>
#include <limits>
#include <set>

#include "evenlift/tolerance.h"

namespace evenlift {
namespace {

using Index = std::uint32_t;
using Indices = std::vector<Index>;

// A row of places, each with an index or `nothing`. A tree whose inner nodes hold the lesser child
// finds the least of the first ones. O(log n) per change or query.
class LeastIndex {
 public:
  static constexpr Index nothing = std::numeric_limits<Index>::max();

  explicit LeastIndex(std::size_t places) {
    while (leaves_ < places) leaves_ *= 2;
    least_.assign(2 * leaves_, nothing);
  }

  void set(std::size_t place, Index index) {
    std::size_t node = leaves_ + place;
    least_[node] = index;
    while (node /= 2) least_[node] = std::min(least_[2 * node], least_[2 * node + 1]);
  }

  Index of_first(std::size_t places) const {
    if (places == leaves_) return least_[1];
    Index least = nothing;
    // The subtrees to the left of the path up from the first leaf that does not count.
    for (std::size_t node = leaves_ + places; node > 1; node /= 2)
      if (node % 2 == 1) least = std::min(least, least_[node - 1]);
    return least;
  }

 private:
  std::size_t leaves_ = 1;
  Indices least_;  // the root is node 1, the children of i are 2 i and 2 i + 1
};

// Removes candidates that `count` choices cannot reach: the best remaining ratio is always at least
// the count-th largest, and taken ratios tie with it. Thousands may tie when few are needed.
void leave_out_unreachable(const std::vector<Candidate>& candidates, std::size_t count,
                           Indices& left) {
  if (left.size() <= count) return;
  const auto ratio = [&](Index i) { return candidates[i].chord.ratio; };
  const auto last = left.begin() + static_cast<std::ptrdiff_t>(count) - 1;
  std::nth_element(left.begin(), last, left.end(),
                   [&](Index i, Index j) { return ratio(i) > ratio(j); });
  const double least = ratio(*last) - 2 * tau;
  std::erase_if(left, [&](Index i) { return ratio(i) < least; });
}

template <class Key>
Indices sorted_by(const Indices& indices, Key key) {
  Indices sorted = indices;
  std::sort(sorted.begin(), sorted.end(),
            [&](Index i, Index j) { return key(i) != key(j) ? key(i) > key(j) : i < j; });
  return sorted;
}

}  // namespace

std::vector<std::uint32_t> order_of_taking(const std::vector<Candidate>& candidates,
                                           std::vector<std::uint32_t> candidates_left,
                                           std::size_t count) {
  const auto ratio = [&](Index i) { return candidates[i].chord.ratio; };
  const auto length = [&](Index i) { return candidates[i].length; };
  leave_out_unreachable(candidates, count, candidates_left);
  const Indices by_ratio = sorted_by(candidates_left, ratio),
                by_length = sorted_by(candidates_left, length);
  std::vector<std::size_t> place(candidates.size());  // of each candidate in by_length
  for (std::size_t k = 0; k < by_length.size(); ++k) place[by_length[k]] = k;

  // The places whose ratio ties with the best remaining one. This only falls, so places stay until
  // taken.
  std::set<std::size_t> places;
  LeastIndex indices(by_length.size());
  std::vector<bool> taken(candidates.size(), false);
  Indices order;
  auto best = by_ratio.begin(), next = by_ratio.begin();
  while (order.size() < count && best != by_ratio.end()) {
    if (taken[*best]) {
      ++best;
      continue;
    }
    for (; next != by_ratio.end() && ratios_tie(ratio(*best), ratio(*next)); ++next) {
      places.insert(place[*next]);
      indices.set(place[*next], *next);
    }
    const auto longest = by_length.begin() + static_cast<std::ptrdiff_t>(*places.begin());
    const auto shorter = std::partition_point(longest, by_length.end(), [&](Index i) {
      return lengths_tie(length(*longest), length(i));
    });
    const Index first = indices.of_first(static_cast<std::size_t>(shorter - by_length.begin()));
    order.push_back(first);
    taken[first] = true;
    places.erase(place[first]);
    indices.set(place[first], LeastIndex::nothing);
  }
  return order;
}

}  // namespace evenlift
