#include "candidates/pair_range.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "chords/section.h"

namespace evenlift {
namespace {

Vec2 offset_at(const PairRange& range, double x) { return (1 - x) * range.a0 + x * range.a1; }

// The place where q, which must differ between the ends, has this value.
double place_of(const PairRange& range, double q) {
  return std::clamp((q - range.q0) / (range.q1 - range.q0), 0.0, 1.0);
}

// Narrows the range to least <= q <= greatest. Returns whether any place remains.
bool narrow(PairRange& range, double least, double greatest) {
  const double low = std::min(range.q0, range.q1), high = std::max(range.q0, range.q1);
  if (high < least || low > greatest) return false;
  const double at_low = low < least ? place_of(range, least) : range.q0 < range.q1 ? 0 : 1;
  const double at_high = high > greatest ? place_of(range, greatest) : range.q0 < range.q1 ? 1 : 0;
  range.first = std::min(at_low, at_high);
  range.last = std::max(at_low, at_high);
  return true;
}

}  // namespace

std::optional<PairRange> find_range(const Polygon& polygon, const Vec2& centre, const SeenEdge& a,
                                    const SeenEdge& b, const EdgePair& pair, double min_ratio) {
  const SectionEnd begin = section_end(polygon, centre, a, b, pair.begin_a, pair.begin_b);
  const SectionEnd end = section_end(polygon, centre, a, b, pair.end_a, pair.end_b);
  PairRange range;
  range.a = pair.a;
  range.b = pair.b;
  range.a0 = offset_on_a(polygon, centre, begin);
  range.a1 = offset_on_a(polygon, centre, end);
  range.q0 = 1.0 / begin.g;
  range.q1 = 1.0 / end.g;
  if (are_parallel(begin.g, end.g)) {
    if (!reaches(chord_at(centre, range, 0.5), min_ratio)) return std::nullopt;
    return range;
  }
  const double greatest = min_ratio > 0 ? 1.0 / min_ratio : std::numeric_limits<double>::infinity();
  if (!narrow(range, min_ratio, greatest)) return std::nullopt;
  return range;
}

bool is_one_place(const PairRange& range, double near) {
  const auto way = [&](auto offset) { return length(offset(range.last) - offset(range.first)); };
  return way([&](double x) { return offset_at(range, x); }) <= near &&
         way([&](double x) { return Vec2(offset_at(range, x) / range.q(x)); }) <= near;
}

Chord chord_at(const Vec2& centre, const PairRange& range, double x) {
  const Vec2 offset = offset_at(range, x);
  const double q = range.q(x), arm = length(offset);
  Chord chord =
      order_ends({centre + offset, range.a}, arm, {centre - offset / q, range.b}, arm / q, offset);
  chord.ratio = q < 1.0 ? q : 1.0 / q;
  return chord;
}

double place_at(const PairRange& range, double s) {
  const auto weight = [&](double x) { return 1 + 1 / range.q(x); };  // |r_a r_b| / |C r_a|
  const double before = (1 - s) * weight(range.first), behind = s * weight(range.last);
  return range.first + (range.last - range.first) * (behind / (before + behind));
}

double place_towards(const PairRange& range, const Vec2& direction) {
  const double first = cross(range.a0, direction), last = cross(range.a1, direction);
  // The line through C along `direction` meets the edge's line at x, ahead of C or behind it.
  const double x = first == last ? range.first : first / (first - last);
  const bool ahead = dot(Vec2((1 - x) * range.a0 + x * range.a1), direction) > 0;
  if (ahead) return std::clamp(x, range.first, range.last);
  const auto closeness = [&](double place) {
    const Vec2 offset = offset_at(range, place);
    return dot(offset, direction) / length(offset);
  };
  return closeness(range.first) > closeness(range.last) ? range.first : range.last;
}

Candidate range_candidate(const Vec2& centre, const PairRange& range, double x) {
  const Chord chord = chord_at(centre, range, x);
  const Vec2 offset = offset_at(range, x);
  return {chord, CandidateKind::range, false, 0, rightward(offset), chord.arm1 + chord.arm2};
}

}  // namespace evenlift
