#include "candidates/duplicates.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <utility>

#include "chords/section.h"
#include "exact/pseudo_angle.h"

namespace evenlift {
namespace {

using Index = std::uint32_t;
constexpr double no_bound = std::numeric_limits<double>::infinity();
constexpr double full_turn = 4;  // of line_pseudo_angle, which repeats after 180 degrees

// Sorts [first, last) by `key`, cuts it where the key jumps by more than `gap`, and visits the
// parts. Items of different parts do not agree if the keys of agreeing items differ by at most the
// gap.
template <class Key, class Visit>
void split_at_gaps(Index* first, Index* last, double gap, Key key, Visit visit) {
  const auto smaller = [&](Index a, Index b) {
    const double p = key(a), q = key(b);
    return p != q ? p < q : a < b;
  };
  if (!std::is_sorted(first, last, smaller)) std::sort(first, last, smaller);
  while (first != last) {
    Index* end = first + 1;
    while (end != last && key(*end) - key(*(end - 1)) <= gap) ++end;
    visit(first, end);
    first = end;
  }
}

// The line_pseudo_angle range of all chords within tolerance of a given chord.
struct Slopes {
  double low, high;
};

class Merger {
 public:
  Merger(const std::vector<Candidate>& candidates, double near)
      : candidates_(candidates), near_(near), parent_(candidates.size()) {
    std::iota(parent_.begin(), parent_.end(), Index{0});
  }

  // Each candidate's representative: the first member of its class.
  std::vector<Index> run() {
    split_by_slope();
    for (Index i = 0; i < parent_.size(); ++i) parent_[i] = find(i);
    return std::move(parent_);
  }

 private:
  // Slopes run from -2 to 2, repeat after a full turn, and change by at most twice the angle. If
  // the ends of two chords agree, their vectors u differ by at most 2 `near`, so the sine of their
  // angle is at most s = 2 near / |u|, and the angle at most s pi / 2; 8 near / |u| exceeds twice
  // the angle and all rounding. The slope of the rounded ends may differ from that of
  // Candidate::direction.
  Slopes slopes(Index i) const {
    const Vec2 u = candidates_[i].chord.r2.position - candidates_[i].chord.r1.position;
    const double width = std::fabs(u.x), height = std::fabs(u.y);
    if (width == 0 && height == 0) return {-full_turn, full_turn};  // the ends rounded to one point
    const double reach = std::min(8 * near_ / std::max(width, height), full_turn);
    const double middle = line_pseudo_angle(u);
    return {middle - reach, middle + reach};
  }

  // Cuts the list where no slope range crosses the cut. In candidate order slopes hardly ever
  // decrease, so nearly all groups are small without sorting.
  void split_by_slope() {
    const auto m = static_cast<Index>(candidates_.size());
    // lowest[i] is the lowest slope of candidate i and all after it.
    std::vector<double> lowest(m + std::size_t{1}, no_bound);
    double top = -no_bound;
    for (Index i = m; i-- > 0;) {
      const Slopes s = slopes(i);
      lowest[i] = std::min(lowest[i + 1], s.low);
      top = std::max(top, s.high);
    }
    // Nearly vertical chords may agree although their slopes are at opposite ends of the range, so
    // all groups that reach around the end are merged.
    const double around_low = top - full_turn, around_high = lowest[0] + full_turn;
    std::vector<Index> group, around;
    double highest = -no_bound;
    bool reaches_around = false;
    for (Index i = 0; i < m; ++i) {
      const Slopes s = slopes(i);
      group.push_back(i);
      highest = std::max(highest, s.high);
      reaches_around = reaches_around || s.low <= around_low || s.high >= around_high;
      if (lowest[i + 1] <= highest) continue;
      if (reaches_around) {
        around.insert(around.end(), group.begin(), group.end());
      } else {
        split(group.data(), group.data() + group.size(), 0, 0);
      }
      group.clear();
      reaches_around = false;
    }
    split(around.data(), around.data() + around.size(), 0, 0);
  }

  // These keys do not depend on which end is called r2.
  static constexpr int keys = 5;
  double key(Index i, int which) const {
    const Vec2 &p = candidates_[i].chord.r1.position, &q = candidates_[i].chord.r2.position;
    switch (which) {
      case 0:
        return -length(q - p);  // candidate order: the longer first
      case 1:
        return std::max(p.x, q.x);
      case 2:
        return std::max(p.y, q.y);
      case 3:
        return std::min(p.x, q.x);
      default:
        return std::min(p.y, q.y);
    }
  }
  // Agreeing chords differ by at most `near` in coordinates, twice that plus rounding in length.
  double gap(int which) const { return which == 0 ? 3 * near_ : near_; }

  // Splits by one key after another until no key splits the group. Compares small or remaining
  // groups pair by pair. `whole` counts the keys in a row that did not split it.
  void split(Index* first, Index* last, int which, int whole) {
    constexpr std::ptrdiff_t small = 4;
    if (last - first < 2) return;
    if (whole == keys || last - first <= small) return compare_all(first, last);
    const auto by_key = [&](Index i) { return key(i, which); };
    split_at_gaps(first, last, gap(which), by_key, [&](Index* begin, Index* end) {
      split(begin, end, (which + 1) % keys, end - begin == last - first ? whole + 1 : 1);
    });
  }

  void compare_all(const Index* first, const Index* last) {
    for (const Index* i = first; i != last; ++i) {
      for (const Index* j = i + 1; j != last; ++j) {
        if (same_chord(candidates_[*i].chord, candidates_[*j].chord, near_)) join(*i, *j);
      }
    }
  }

  // Union-find with path halving.
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

MergedCandidates merge_duplicates(std::vector<Candidate> candidates, double near) {
  const std::vector<Index> first_of = Merger(candidates, near).run();
  const auto is_preferred_to = [&](const Candidate& a, const Candidate& b) {
    if (a.between_vertices != b.between_vertices) return a.between_vertices;
    return a.chord.ratio > b.chord.ratio;
  };
  // The first member is kept unless a later one is preferred to it.
  std::vector<Index> best(candidates.size());
  std::vector<CandidateKind> kind(candidates.size());  // of each class, the first kind that occurs
  for (Index i = 0; i < candidates.size(); ++i) {
    const Index first = first_of[i];
    if (first == i) {
      best[first] = i;
      kind[first] = candidates[i].kind;
      continue;
    }
    kind[first] = std::min(kind[first], candidates[i].kind);
    if (is_preferred_to(candidates[i], candidates[best[first]])) best[first] = i;
  }
  std::vector<Index> place(candidates.size());
  Index kept = 0;
  for (Index i = 0; i < candidates.size(); ++i) {
    const Index first = first_of[i];
    if (best[first] != i) continue;
    place[first] = kept;
    if (kept != i) candidates[kept] = candidates[i];
    // Edge pairs that exist only by rounding, between two opposite vertices, do not change the kind
    // of a chord between two vertices.
    if (!candidates[kept].between_vertices) candidates[kept].kind = kind[first];
    ++kept;
  }
  candidates.resize(kept);
  std::vector<Index> became(first_of.size());
  for (Index i = 0; i < became.size(); ++i) became[i] = place[first_of[i]];
  return {std::move(candidates), std::move(became)};
}

}  // namespace evenlift
