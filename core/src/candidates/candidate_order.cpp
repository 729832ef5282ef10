#include "candidates/candidate_order.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <span>
#include <utility>

#include "candidates/pair_candidate.h"
#include "chords/radial_view.h"
#include "evenlift/predicates.h"
#include "evenlift/tolerance.h"
#include "exact/pseudo_angle.h"
#include "exact/sorted_indices.h"

namespace evenlift {

CandidateSeeds::CandidateSeeds(const Polygon& polygon, const Vec2& centre, const RadialView& view,
                               const std::vector<OppositeVertices>& opposite, double min_ratio,
                               Positions positions, double clear, bool traced)
    : polygon_(polygon),
      centre_(centre),
      view_(view),
      min_ratio_(min_ratio),
      positions_(positions),
      clear_(clear),
      traced_(traced),
      corners_(polygon),
      has_opposite_(polygon.size()) {
  for (const OppositeVertices& two : opposite) has_opposite_[two.v] = has_opposite_[two.w] = true;
}

bool CandidateSeeds::ends_at_opposite_vertices(const EdgePair& pair) const {
  const auto at = [&](std::uint32_t vertex_a, std::uint32_t vertex_b) {
    return has_opposite_[vertex_a != inside_edge ? vertex_a : vertex_b];
  };
  return at(pair.begin_a, pair.begin_b) || at(pair.end_a, pair.end_b);
}

void CandidateSeeds::examine_and_add(const EdgePair& pair) {
  const SeenEdge a = see(polygon_, view_, pair.a), b = see(polygon_, view_, pair.b);
  const QuickVerdict quick = ends_at_opposite_vertices(pair)
                                 ? QuickVerdict::unsure
                                 : examine_quickly(polygon_, centre_, a, b, pair, min_ratio_);
  switch (quick) {
    case QuickVerdict::none:
      return;
    case QuickVerdict::at_begin:
      return add_vertex_chord(pair, pair.begin_a, pair.begin_b);
    case QuickVerdict::at_end:
      return add_vertex_chord(pair, pair.end_a, pair.end_b);
    case QuickVerdict::bisecting:
      offsets_.push_back(bisecting_offset(centre_, a, b));
      return add_seed(
          BisectingSeed{pair.a, pair.b, static_cast<std::uint32_t>(offsets_.size() - 1)},
          rightward(offsets_.back()));
    case QuickVerdict::unsure:
      break;
  }
  const PairVerdict verdict = examine(polygon_, centre_, a, b, pair, min_ratio_);
  if (verdict.candidate) add_finished(*verdict.candidate);
}

void CandidateSeeds::examine_and_add(const OppositeVertices& opposite) {
  const Candidate candidate = opposite_chord(polygon_, centre_, opposite);
  if (reaches(candidate.chord, min_ratio_)) add_finished(candidate);
}

void CandidateSeeds::add_range(const EdgePair& pair) {
  const SeenEdge a = see(polygon_, view_, pair.a), b = see(polygon_, view_, pair.b);
  const auto range = find_range(polygon_, centre_, a, b, pair, min_ratio_);
  if (!range || is_one_place(*range, near_distance(polygon_.diameter()))) return;
  const auto clear = clear_part({polygon_, corners_, clear_}, centre_, *range);
  for (const double s : range_places)
    add_finished(range_candidate(centre_, *range, clear_place_at(*range, clear, s)));
}

void CandidateSeeds::add_finished(const Candidate& candidate) {
  finished_.push_back(candidate);
  add_seed(FinishedSeed{static_cast<std::uint32_t>(finished_.size() - 1)}, candidate.direction);
}

void CandidateSeeds::add_vertex_chord(const EdgePair& pair, std::uint32_t vertex_a,
                                      std::uint32_t vertex_b) {
  const VertexChordSeed seed = vertex_a != inside_edge
                                   ? VertexChordSeed{pair.a, pair.b, vertex_a, vertex_b}
                                   : VertexChordSeed{pair.b, pair.a, vertex_b, inside_edge};
  add_seed(seed, rightward(centre_ - polygon_.vertex(seed.vertex)));
}

void CandidateSeeds::add_seed(const Seed& seed, const Vec2& direction) {
  keys_.push_back(slope_key(direction, static_cast<std::uint32_t>(seeds_.size())));
  seeds_.push_back(seed);
  if (traced_) source_of_seed_.push_back(sources_);
}

Candidate CandidateSeeds::grow(const VertexChordSeed& seed) const {
  return vertex_candidate(polygon_, centre_, seed.vertex, seed.edge,
                          see(polygon_, view_, seed.other), seed.opposite);
}

Candidate CandidateSeeds::grow(const BisectingSeed& seed) const {
  return bisecting_candidate(centre_, seed.edge_a, seed.edge_b, offsets_[seed.offset]);
}

Candidate CandidateSeeds::grow(const FinishedSeed& seed) const { return finished_[seed.index]; }

std::vector<Candidate> CandidateSeeds::grow() {
  sort_keys(keys_);
  std::vector<Candidate> candidates;
  candidates.reserve(keys_.size());
  for (const SlopeKey key : keys_) {
    const std::uint32_t seed = number_of(key);
    candidates.push_back(std::visit([&](const auto& each) { return grow(each); }, seeds_[seed]));
    if (traced_) candidates.back().source = source_of_seed_[seed];
  }
  settle_order(candidates, near_distance(polygon_.diameter()));
  return candidates;
}

namespace {

constexpr int number_bits = 24;
constexpr int slope_bits = 40;
constexpr SlopeKey vertical_slope = (SlopeKey{1} << slope_bits) - 1;
static_assert(max_edge_pairs <= SlopeKey{1} << number_bits && number_bits + slope_bits == 64);

class Settler {
 public:
  Settler(std::vector<Candidate>& candidates, double near) : candidates_(candidates), near_(near) {}

  void run() {
    const std::size_t m = candidates_.size();
    vertical_from_ = m;
    while (vertical_from_ > 0 && is_vertical(direction(vertical_from_ - 1))) --vertical_from_;
    for_each_run([&](std::size_t i) { return same_key(i); },
                 [&](std::size_t i, std::size_t j) { sort_exactly(i, j); });
    for_each_run([&](std::size_t i) { return same_line(i); },
                 [&](std::size_t i, std::size_t j) { sort_line(i, j); });
  }

 private:
  const Vec2& direction(std::size_t i) const { return candidates_[i].direction; }

  // Calls visit(begin, end) for each maximal run of two or more candidates in which together(i)
  // joins each i to i + 1.
  template <class Together, class Visit>
  void for_each_run(Together together, Visit visit) {
    for (std::size_t begin = 0, end; begin < candidates_.size(); begin = end) {
      end = begin + 1;
      while (end < candidates_.size() && together(end - 1)) ++end;
      if (end - begin > 1) visit(begin, end);
    }
  }

  // Chords of one vertex have exactly the same direction. Few other chords share a key.
  bool same_key(std::size_t i) const {
    return i + 1 < vertical_from_ && (direction(i) == direction(i + 1) ||
                                      slope_key(direction(i), 0) == slope_key(direction(i + 1), 0));
  }

  bool same_line(std::size_t i) const {
    if (i >= vertical_from_) return true;
    if (i + 1 >= vertical_from_) return false;
    return direction(i) == direction(i + 1) || directions_agree(direction(i), direction(i + 1));
  }

  void sort_exactly(std::size_t begin, std::size_t end) {
    const auto is_first = [&](std::size_t i) { return direction(i) == direction(begin); };
    std::size_t other = begin + 1;
    while (other < end && is_first(other)) ++other;
    if (other == end) return;
    fill(begin, end);
    const Vec2 zero;
    sort_indices(members_, [&](std::uint32_t i, std::uint32_t j) {
      return cross_of_differences(zero, direction(i), zero, direction(j)) > 0;
    });
    rearrange(begin);
  }

  void sort_line(std::size_t begin, std::size_t end) {
    fill(begin, end);
    const auto length_of = [&](std::uint32_t i) { return candidates_[i].length; };
    const auto right_arm = [&](std::uint32_t i) { return candidates_[i].chord.arm2; };
    using Class = std::span<std::uint32_t>;
    for_each_tie_class(members_, length_of, lengths_tie, [&](Class equally_long) {
      if (equally_long.size() == 1) return;
      for_each_tie_class(equally_long, right_arm, lengths_tie,
                         [&](Class alike) { sort_by_coordinates(alike, 0); });
    });
    rearrange(begin);
  }

  // Sorts by the first coordinate whose difference rounding cannot reverse. Two distinct chords
  // differ in some coordinate by more than near / sqrt(2).
  void sort_by_coordinates(std::span<std::uint32_t> alike, std::size_t which) {
    const auto coordinate = [&](std::uint32_t i) { return coordinates(candidates_[i])[which]; };
    const auto tie = [&](double a, double b) { return std::fabs(a - b) <= near_ / 2; };
    const auto all_tie = [&] {
      const auto less = [&](std::uint32_t i, std::uint32_t j) {
        return coordinate(i) < coordinate(j);
      };
      const auto [low, high] = std::minmax_element(alike.begin(), alike.end(), less);
      return tie(coordinate(*low), coordinate(*high));
    };
    while (alike.size() > 1 && which < 4 && all_tie()) ++which;
    if (alike.size() == 1) return;
    if (which == 4)
      return sort_indices(alike,
                          [&](std::uint32_t i, std::uint32_t j) { return comes_first(i, j); });
    for_each_tie_class(
        alike, [&](std::uint32_t i) { return -coordinate(i); }, tie,
        [&](std::span<std::uint32_t> level) { sort_by_coordinates(level, which + 1); });
  }

  // For chords that are equal except for rounding.
  bool comes_first(std::uint32_t i, std::uint32_t j) const {
    const Candidate &a = candidates_[i], &b = candidates_[j];
    const auto p = coordinates(a), q = coordinates(b);
    if (p != q) return p < q;
    return a.kind != b.kind ? a.kind < b.kind : i < j;
  }

  static std::array<double, 4> coordinates(const Candidate& c) {
    const Vec2 &p = c.chord.r1.position, &q = c.chord.r2.position;
    return {p.x, p.y, q.x, q.y};
  }

  void fill(std::size_t begin, std::size_t end) {
    members_.resize(end - begin);
    std::iota(members_.begin(), members_.end(), static_cast<std::uint32_t>(begin));
  }

  // Puts the members, in their order, into the places from `begin` on.
  void rearrange(std::size_t begin) {
    const auto in_place = [&](std::size_t k) { return members_[k] == begin + k; };
    std::size_t from = 0;
    while (from < members_.size() && in_place(from)) ++from;
    if (from == members_.size()) return;
    moved_.clear();
    for (std::size_t k = from; k < members_.size(); ++k) moved_.push_back(candidates_[members_[k]]);
    std::copy(moved_.begin(), moved_.end(),
              candidates_.begin() + static_cast<std::ptrdiff_t>(begin + from));
  }

  std::vector<Candidate>& candidates_;
  double near_;  // tau L
  std::size_t vertical_from_ = 0;
  SortedIndices members_;  // of the current run
  std::vector<Candidate> moved_;
};

}  // namespace

SlopeKey slope_key(const Vec2& direction, std::uint32_t number) {
  constexpr double scale = 0x1p38;  // maps [0, 4] to slope_bits
  const SlopeKey key =
      is_vertical(direction)
          ? vertical_slope
          : std::min(static_cast<SlopeKey>((line_pseudo_angle(direction) + 2) * scale),
                     vertical_slope - 1);
  return key << number_bits | number;
}

std::uint32_t number_of(SlopeKey key) {
  return static_cast<std::uint32_t>(key & ((SlopeKey{1} << number_bits) - 1));
}

// The numbers ascend at first and each pass is stable, so only the bits of the slope need passes.
void sort_keys(std::vector<SlopeKey>& keys) {
  constexpr std::size_t few = 512;
  if (keys.size() < few) {
    std::sort(keys.begin(), keys.end());
    return;
  }
  constexpr int digit_bits = 8, digits = slope_bits / digit_bits;
  constexpr std::size_t values = std::size_t{1} << digit_bits;
  const auto digit = [](SlopeKey key, int d) {
    return static_cast<std::size_t>(key >> (number_bits + d * digit_bits)) % values;
  };
  std::array<std::array<std::uint32_t, values>, digits> places{};
  for (const SlopeKey key : keys) {
    for (int d = 0; d < digits; ++d) ++places[static_cast<std::size_t>(d)][digit(key, d)];
  }
  std::vector<SlopeKey> sorted(keys.size());
  for (int d = 0; d < digits; ++d) {
    auto& place = places[static_cast<std::size_t>(d)];
    std::exclusive_scan(place.begin(), place.end(), place.begin(), std::uint32_t{0});
    for (const SlopeKey key : keys) sorted[place[digit(key, d)]++] = key;
    keys.swap(sorted);
  }
}

void settle_order(std::vector<Candidate>& candidates, double near) {
  Settler(candidates, near).run();
}

std::vector<Candidate> in_candidate_order(const std::vector<Candidate>& found, double near) {
  std::vector<SlopeKey> keys;
  keys.reserve(found.size());
  for (std::uint32_t i = 0; i < found.size(); ++i) keys.push_back(slope_key(found[i].direction, i));
  sort_keys(keys);
  std::vector<Candidate> ordered;
  ordered.reserve(found.size());
  for (const SlopeKey key : keys) ordered.push_back(found[number_of(key)]);
  settle_order(ordered, near);
  return ordered;
}

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
