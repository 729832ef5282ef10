#include "candidates/candidate_order.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <span>

#include "evenlift/predicates.h"
#include "evenlift/tolerance.h"
#include "exact/pseudo_angle.h"
#include "exact/tie_classes.h"

namespace evenlift {
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

}  // namespace evenlift
