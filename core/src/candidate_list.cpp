#include "candidate_list.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <utility>

#include "evenlift/predicates.h"
#include "evenlift/tolerance.h"
#include "tie_classes.h"

namespace evenlift {
namespace {

using Index = std::uint32_t;

template <class T>
void permute(std::vector<T>& items, const std::vector<Index>& order) {
  std::vector<T> sorted;
  sorted.reserve(order.size());
  for (const Index i : order) sorted.push_back(items[i]);
  items.swap(sorted);
}

std::array<double, 4> coordinates(const Candidate& c) {
  const Vec2 &p = c.chord.r1.position, &q = c.chord.r2.position;
  return {p.x(), p.y(), q.x(), q.y()};
}

// Orders chords that lie on one line.
void sort_line(const std::vector<Candidate>& candidates, Index* first, Index* last) {
  const auto length_of = [&](Index i) { return candidates[i].length; };
  const auto right_arm = [&](Index i) { return candidates[i].chord.arm2; };
  for_each_tie_class(first, last, length_of, lengths_tie, [&](Index* begin, Index* end) {
    for_each_tie_class(begin, end, right_arm, lengths_tie, [&](Index* from, Index* to) {
      std::sort(from, to, [&](Index a, Index b) {
        const auto p = coordinates(candidates[a]), q = coordinates(candidates[b]);
        if (p != q) return p < q;
        if (candidates[a].kind != candidates[b].kind)
          return candidates[a].kind < candidates[b].kind;
        return a < b;
      });
    });
  });
}

// Cuts [first, last) wherever the sorted `key` jumps by more than `near`. Items in different parts
// cannot agree, since each key changes by no more than the ends move.
template <class Key, class Visit>
void split_at_gaps(Index* first, Index* last, double near, Key key, Visit visit) {
  std::sort(first, last,
            [&](Index a, Index b) { return key(a) != key(b) ? key(a) < key(b) : a < b; });
  while (first != last) {
    Index* end = first + 1;
    while (end != last && key(*end) - key(*(end - 1)) <= near) ++end;
    visit(first, end);
    first = end;
  }
}

class Merger {
 public:
  Merger(const std::vector<Candidate>& candidates, double near)
      : candidates_(candidates), near_(near), parent_(candidates.size()) {
    std::iota(parent_.begin(), parent_.end(), Index{0});
  }

  // The representative of each candidate's class: its first member.
  std::vector<Index> run() {
    std::vector<Index> all(candidates_.size());
    std::iota(all.begin(), all.end(), Index{0});
    if (!all.empty()) split(all.data(), all.data() + all.size(), 0, 0);
    for (Index i = 0; i < parent_.size(); ++i) parent_[i] = find(i);
    return parent_;
  }

 private:
  // The bounding box of a chord: keys that do not depend on which end is called the right one.
  double key(Index i, int which) const {
    const auto c = coordinates(candidates_[i]);
    switch (which) {
      case 0:
        return std::max(c[0], c[2]);
      case 1:
        return std::max(c[1], c[3]);
      case 2:
        return std::min(c[0], c[2]);
      default:
        return std::min(c[1], c[3]);
    }
  }

  // Splits by one key after another until four in a row leave the group whole; what is left is
  // compared pair by pair.
  void split(Index* first, Index* last, int which, int whole) {
    if (last - first < 2) return;
    if (whole == 4) return compare_all(first, last);
    split_at_gaps(
        first, last, near_, [&](Index i) { return key(i, which); },
        [&](Index* begin, Index* end) {
          split(begin, end, (which + 1) % 4, end - begin == last - first ? whole + 1 : 1);
        });
  }

  void compare_all(const Index* first, const Index* last) {
    for (const Index* i = first; i != last; ++i) {
      for (const Index* j = i + 1; j != last; ++j) {
        if (agree(*i, *j)) join(*i, *j);
      }
    }
  }

  bool agree(Index i, Index j) const {
    const Chord &a = candidates_[i].chord, &b = candidates_[j].chord;
    const auto close = [&](const LiftingPoint& p, const LiftingPoint& q) {
      return length(p.position - q.position) <= near_;
    };
    return (close(a.r1, b.r1) && close(a.r2, b.r2)) || (close(a.r1, b.r2) && close(a.r2, b.r1));
  }

  Index find(Index i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }

  void join(Index i, Index j) {
    const Index a = find(i), b = find(j);
    parent_[std::max(a, b)] = std::min(a, b);
  }

  const std::vector<Candidate>& candidates_;
  double near_;
  std::vector<Index> parent_;
};

}  // namespace

void sort_by_slope(std::vector<Candidate>& candidates) {
  const Vec2 zero = Vec2::Zero();
  std::vector<Index> order(candidates.size());
  std::vector<char> vertical(candidates.size());
  for (Index i = 0; i < order.size(); ++i) {
    order[i] = i;
    vertical[i] = is_vertical(candidates[i].direction);
  }
  std::sort(order.begin(), order.end(), [&](Index a, Index b) {
    if (vertical[a] != vertical[b]) return vertical[a] < vertical[b];
    if (!vertical[a]) {
      const double side =
          cross_of_differences(zero, candidates[a].direction, zero, candidates[b].direction);
      if (side != 0) return side > 0;
    }
    return a < b;
  });
  for (Index* first = order.data(); first != order.data() + order.size();) {
    Index* last = first + 1;
    while (last != order.data() + order.size() && vertical[*last] == vertical[*first] &&
           (vertical[*first] ||
            directions_agree(candidates[*(last - 1)].direction, candidates[*last].direction))) {
      ++last;
    }
    if (last - first > 1) sort_line(candidates, first, last);
    first = last;
  }
  permute(candidates, order);
}

void merge_duplicates(std::vector<Candidate>& candidates, double near) {
  const std::vector<Index> first_of = Merger(candidates, near).run();
  // In candidate order the first of a class comes first: a later one takes its place only with a
  // larger ratio.
  std::vector<Index> best(candidates.size());
  for (Index i = 0; i < candidates.size(); ++i) {
    const Index first = first_of[i];
    if (first == i) {
      best[first] = i;
      continue;
    }
    const CandidateKind kind = std::min(candidates[best[first]].kind, candidates[i].kind);
    if (candidates[i].chord.ratio > candidates[best[first]].chord.ratio) best[first] = i;
    candidates[best[first]].kind = kind;
  }
  std::vector<Candidate> kept;
  for (Index i = 0; i < candidates.size(); ++i) {
    if (best[first_of[i]] == i) kept.push_back(candidates[i]);
  }
  candidates.swap(kept);
}

}  // namespace evenlift
