#include "optimum/rings.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <utility>

namespace evenlift::optimum {
namespace {

constexpr double impossible = -1;

bool is_over(const Stop& stop) { return stop && stop(); }

// For each number of ends after a first one and each place of the last: the greatest sum of the
// triangles between them, and the place before the last.
class Chain {
 public:
  // Places up to `length` and up to `most` further ends. O(length^2 most).
  Chain(const Triangles& triangles, std::uint32_t first, std::uint32_t length, std::uint32_t most)
      : width_(length + 1),
        sums_(std::size_t{width_} * (most + 1), impossible),
        before_(sums_.size()) {
    sums_[0] = 0;
    const std::uint32_t ends = triangles.ends(), longest = triangles.chords();
    for (std::uint32_t number = 1; number <= most; ++number)
      for (std::uint32_t to = 1; to < width_; ++to)
        for (std::uint32_t from = to > longest ? to - longest : 0; from < to; ++from) {
          const double sum = at(number - 1, from);
          if (sum < 0) continue;
          offer(number, to, from, sum + triangles.share((first + from) % ends, to - from));
        }
  }

  double at(std::uint32_t number, std::uint32_t place) const {
    return sums_[std::size_t{number} * width_ + place];
  }

  // Without the first place.
  std::vector<std::uint32_t> places(std::uint32_t number, std::uint32_t place) const {
    std::vector<std::uint32_t> places;
    for (; number > 0; --number) {
      places.push_back(place);
      place = before_[std::size_t{number} * width_ + place];
    }
    std::reverse(places.begin(), places.end());
    return places;
  }

 private:
  void offer(std::uint32_t number, std::uint32_t to, std::uint32_t from, double sum) {
    const std::size_t i = std::size_t{number} * width_ + to;
    if (sum <= sums_[i]) return;
    sums_[i] = sum;
    before_[i] = from;
  }

  std::uint32_t width_;
  std::vector<double> sums_;
  std::vector<std::uint32_t> before_;
};

// The best chain that a triangle to the place `length` closes.
struct Closed {
  double sum = impossible;
  std::uint32_t number = 0, place = 0;
};

Closed close(const Triangles& triangles, const Chain& chain, std::uint32_t first,
             std::uint32_t length, std::uint32_t most) {
  Closed best;
  for (std::uint32_t number = 0; number <= most; ++number)
    for (std::uint32_t place = 0; place < length; ++place) {
      const double sum = chain.at(number, place);
      const std::uint32_t left = length - place;
      if (sum < 0 || left > triangles.chords()) continue;
      const double closed = sum + triangles.share((first + place) % triangles.ends(), left);
      if (closed > best.sum) best = {closed, number, place};
    }
  return best;
}

// The best ring through both ends of the chord at place 0, by dynamic programming over chords in
// order of slope. The state is the last end used on each side, and the number of chords used. There
// must be a chord.
class BothSides {
 public:
  BothSides(const Triangles& triangles, std::uint32_t first, std::uint32_t teams)
      : triangles_(triangles),
        first_(first),
        chords_(triangles.chords()),
        teams_(teams),
        sums_(std::size_t{chords_} * chords_ * teams, impossible),
        before_(sums_.size(), 0) {
    sums_[index(0, 0, 1)] = 0;
    for (std::uint32_t chord = 1; chord < chords_; ++chord) extend(chord);
  }

  Ring best() const {
    Ring best{impossible, {}};
    std::array<std::uint32_t, 3> last{};
    for (std::uint32_t right = 0; right < chords_; ++right)
      for (std::uint32_t left = 0; left < chords_; ++left)
        for (std::uint32_t used = 1; used <= teams_; ++used) {
          const double sum = sums_[index(right, left, used)];
          if (sum < 0) continue;
          const double closed = sum + step(right, chords_) + step(chords_ + left, 2 * chords_);
          if (closed <= best.share) continue;
          best.share = closed;
          last = {right, left, used};
        }
    best.ends = ends_of(last);
    return best;
  }

 private:
  std::size_t index(std::uint32_t right, std::uint32_t left, std::uint32_t used) const {
    return (std::size_t{right} * chords_ + left) * teams_ + (used - 1);
  }
  // Places are counted about C from the chord's right end.
  double step(std::uint32_t from, std::uint32_t to) const {
    return triangles_.share((first_ + from) % triangles_.ends(), to - from);
  }

  void extend(std::uint32_t chord) {
    for (std::uint32_t right = 0; right < chord; ++right)
      for (std::uint32_t left = 0; left < chord; ++left) {
        const double on_right = step(right, chord), on_left = step(chords_ + left, chords_ + chord);
        for (std::uint32_t used = 1; used < teams_; ++used) {
          const std::size_t from = index(right, left, used);
          if (sums_[from] < 0) continue;
          offer(index(chord, left, used + 1), from, sums_[from] + on_right);
          offer(index(right, chord, used + 1), from, sums_[from] + on_left);
          offer(index(chord, chord, used + 1), from, sums_[from] + on_right + on_left);
        }
      }
  }

  void offer(std::size_t to, std::size_t from, double sum) {
    if (sum <= sums_[to]) return;
    sums_[to] = sum;
    before_[to] = static_cast<std::uint32_t>(from);
  }

  std::vector<std::uint32_t> ends_of(std::array<std::uint32_t, 3> last) const {
    assert(chords_ > 0);
    std::vector<std::uint32_t> right{0}, left{0};
    for (std::size_t at = index(last[0], last[1], last[2]); at % teams_ != 0; at = before_[at]) {
      const auto pair = static_cast<std::uint32_t>(at / teams_);
      right.push_back(pair / chords_);
      left.push_back(pair % chords_);
    }
    std::vector<std::uint32_t> ends;
    for (const std::uint32_t place : right) ends.push_back((first_ + place) % triangles_.ends());
    for (const std::uint32_t place : left)
      ends.push_back((first_ + chords_ + place) % triangles_.ends());
    std::sort(ends.begin(), ends.end());
    ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
    return ends;
  }

  const Triangles& triangles_;
  std::uint32_t first_, chords_, teams_;
  std::vector<double> sums_;
  std::vector<std::uint32_t> before_;
};

}  // namespace

std::optional<Ring> best_ring(const Triangles& triangles, std::uint32_t most, const Stop& stop) {
  const std::uint32_t ends = triangles.ends();
  Ring best;
  for (std::uint32_t first = 0; first < ends && most > 0; ++first) {
    if (is_over(stop)) return std::nullopt;
    const Chain chain(triangles, first, ends - 1 - first, most - 1);
    Closed closed;
    for (std::uint32_t number = 0; number < most; ++number)
      for (std::uint32_t place = 0; place + first < ends; ++place) {
        const double sum = chain.at(number, place);
        const std::uint32_t left = ends - place;
        if (sum < 0 || left > triangles.chords()) continue;
        const double whole = sum + triangles.share(first + place, left);
        if (whole > closed.sum) closed = {whole, number, place};
      }
    if (closed.sum <= best.share) continue;
    best.share = closed.sum;
    best.ends = {first};
    for (const std::uint32_t place : chain.places(closed.number, closed.place))
      best.ends.push_back(first + place);
  }
  return best;
}

std::optional<Ring> best_ring_of_chords(const Triangles& triangles, std::uint32_t teams,
                                        const Stop& stop) {
  Ring best;
  for (std::uint32_t first = 0; first < triangles.chords() && teams > 0; ++first) {
    if (is_over(stop)) return std::nullopt;
    Ring ring = BothSides(triangles, first, teams).best();
    if (ring.share > best.share) best = std::move(ring);
  }
  return best;
}

std::optional<Ring> best_ring_by_sides(const Triangles& triangles, std::uint32_t teams,
                                       const Stop& stop) {
  const std::uint32_t chords = triangles.chords();
  Ring best;
  for (std::uint32_t first = 0; first < chords && teams > 0; ++first) {
    if (is_over(stop)) return std::nullopt;
    const std::uint32_t opposite = first + chords;
    const Chain right(triangles, first, chords - 1, teams - 1),
        left(triangles, opposite, chords - 1, teams - 1);
    const Closed a = close(triangles, right, first, chords, teams - 1),
                 b = close(triangles, left, opposite, chords, teams - 1);
    if (a.sum + b.sum <= best.share) continue;
    best.share = a.sum + b.sum;
    best.ends = {first, opposite};
    for (const std::uint32_t place : right.places(a.number, a.place))
      best.ends.push_back((first + place) % triangles.ends());
    for (const std::uint32_t place : left.places(b.number, b.place))
      best.ends.push_back((opposite + place) % triangles.ends());
  }
  return best;
}

}  // namespace evenlift::optimum
