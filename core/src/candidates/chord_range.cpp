#include "candidates/chord_range.h"

#include <algorithm>
#include <utility>

#include "evenlift/tolerance.h"

namespace evenlift {
namespace {

constexpr double least_ratio = 1e-12;  // below it, one end is practically at infinity

}  // namespace

// The part of a piece of `a` in which q is from `low` to `high`.
std::optional<Stretch> ChordRange::with_ratio(Stretch stretch, double low, double high) const {
  for (const double bound : {low, high}) {
    const double sign = bound == low ? 1 : -1;
    const bool first = sign * (q(stretch.from) - bound) >= 0,
               last = sign * (q(stretch.to) - bound) >= 0;
    if (!first && !last) return std::nullopt;
    if (first && last) continue;
    const double t = std::clamp((bound - q0_) / slope_, stretch.from, stretch.to);
    (first ? stretch.to : stretch.from) = t;
  }
  return stretch;
}

// The place along `a` of the chord at `t_b` along `b`.
double ChordRange::on_a(double t_b) const {
  const Vec2 r_b = b_.at(t_b);
  return dot(r_b * (a_.height / cross(r_b, a_.along)) - a_.start, a_.along);
}

// The part of a piece of `a` whose chords end in a piece of `b`; q must be above 0.
std::optional<Stretch> ChordRange::that_reach(const Stretch& stretch, const Stretch& of_b) const {
  double t_low = stretch.from, t_high = stretch.to;
  double low = on_b(t_low), high = on_b(t_high);
  if (low > high) {
    std::swap(low, high);
    std::swap(t_low, t_high);
  }
  if (high < of_b.from || low > of_b.to) return std::nullopt;
  if (low < of_b.from) t_low = std::clamp(on_a(of_b.from), stretch.from, stretch.to);
  if (high > of_b.to) t_high = std::clamp(on_a(of_b.to), stretch.from, stretch.to);
  return Stretch{std::min(t_low, t_high), std::max(t_low, t_high)};
}

std::optional<Stretch> ChordRange::common(const Stretch& of_a, const Stretch& of_b) const {
  const auto seen = with_ratio(of_a, least_ratio, 1 / least_ratio);
  return seen ? that_reach(*seen, of_b) : std::nullopt;
}

std::vector<Stretch> ChordRange::pieces(double min_ratio) const {
  const double least = std::max(min_ratio - tau, least_ratio);
  std::vector<Stretch> pieces;
  for (const Stretch& of_a : a_.usable)
    if (const auto even = with_ratio(of_a, least, 1 / least))
      for (const Stretch& of_b : b_.usable)
        if (const auto piece = that_reach(*even, of_b)) pieces.push_back(*piece);
  return pieces;
}

}  // namespace evenlift
