#include "evenlift/candidates.h"

#include <algorithm>
#include <string>
#include <utility>

#include "candidates/candidate_order.h"
#include "candidates/pair_candidate.h"
#include "candidates/standing.h"
#include "chords/radial_view.h"
#include "evenlift/tolerance.h"
#include "evenlift/wording.h"

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

namespace {

struct Found {
  std::vector<Candidate> candidates;
  std::uint32_t sources = 0;
  std::vector<std::uint32_t> source_of_chord;  // if traced: by chord before merging
  std::vector<char> in_range;                  // by chord: whether it is a range candidate
  std::vector<std::uint32_t> became;           // by chord: its candidate
};

// Each pair may have three candidates, and their numbers must fit into their keys
// (candidate_order.h).
std::optional<InputError> check_number_in_ranges(std::uint64_t sources) {
  constexpr std::uint64_t most = max_edge_pairs / 3;
  if (sources <= most) return std::nullopt;
  return InputError{
      ErrorCode::too_many_edge_pairs,
      say("the polygon has {number} edge pairs and opposite vertices about its centre "
          "of mass; with positions anywhere in the range, at most {most} are allowed",
          {std::to_string(sources), std::to_string(most)})};
}

Result<Found> find(const Polygon& polygon, const Vec2& centre, double min_ratio,
                   Positions positions, double clear, bool traced) {
  const RadialView view(polygon, centre);
  const std::uint64_t pairs = count_edge_pairs(polygon, view);
  if (auto error = check_number(pairs, "edge pairs")) return *error;
  const auto opposite = find_opposite_vertices(polygon, centre, view, max_edge_pairs - pairs);
  if (!opposite) return too_many_opposite_vertices();

  if (positions == Positions::range)
    if (auto error = check_number_in_ranges(pairs + opposite->size())) return *error;
  CandidateSeeds seeds(polygon, centre, view, *opposite, min_ratio, positions, clear, traced);
  for_each_edge_pair(polygon, view, [&](const EdgePair& pair) { seeds.add(pair); });
  for (const OppositeVertices& two : *opposite) seeds.add(two);
  Found found;
  std::vector<Candidate> chords = seeds.grow();
  found.sources = static_cast<std::uint32_t>(pairs + opposite->size());
  if (traced)
    for (const Candidate& c : chords) {
      found.source_of_chord.push_back(c.source);
      found.in_range.push_back(c.kind == CandidateKind::range ? 1 : 0);
    }
  MergedCandidates merged = merge_duplicates(std::move(chords), near_distance(polygon.diameter()));
  found.candidates = std::move(merged.candidates);
  found.became = std::move(merged.became);
  return found;
}

}  // namespace

std::string_view name(CandidateKind kind) {
  switch (kind) {
    case CandidateKind::bisecting:
      return "bisecting";
    case CandidateKind::midpoint:
      return "midpoint";
    case CandidateKind::vertex:
      return "vertex";
    case CandidateKind::range:
      return "range";
  }
  return {};
}

std::vector<Chord> chords_of(const std::vector<Candidate>& candidates,
                             const std::vector<std::uint32_t>& indices) {
  std::vector<Chord> chords;
  chords.reserve(indices.size());
  for (const std::uint32_t i : indices) chords.push_back(candidates[i].chord);
  return chords;
}

bool is_even(const Chord& chord) { return chord.ratio >= even_ratio; }

std::optional<PairRange> range_of(const Polygon& polygon, const Vec2& centre, const EdgePair& pair,
                                  double min_ratio) {
  return find_range(polygon, centre, see(polygon, centre, pair.a), see(polygon, centre, pair.b),
                    pair, min_ratio);
}

std::optional<PairRange> range_of(const Polygon& polygon, const Vec2& centre, const Chord& chord,
                                  double min_ratio) {
  const double near = near_distance(polygon.diameter());
  const auto pair = pair_of_edges(polygon, centre, chord.r1.edge, chord.r2.edge, near);
  return pair ? range_of(polygon, centre, *pair, min_ratio) : std::nullopt;
}

PairVerdict examine_pair(const Polygon& polygon, const Vec2& centre, const EdgePair& pair,
                         double min_ratio) {
  return examine(polygon, centre, see(polygon, centre, pair.a), see(polygon, centre, pair.b), pair,
                 min_ratio);
}

Result<std::vector<Candidate>> find_candidates(const Polygon& polygon, const Vec2& centre,
                                               double min_ratio, Positions positions,
                                               double clear) {
  auto found = find(polygon, centre, min_ratio, positions, clear, false);
  if (!found) return found.error();
  return std::move(found->candidates);
}

Result<TracedCandidates> trace_candidates(const Polygon& polygon, const Vec2& centre,
                                          double min_ratio, Positions positions, double clear) {
  auto found = find(polygon, centre, min_ratio, positions, clear, true);
  if (!found) return found.error();
  TracedCandidates traced{std::move(found->candidates), {}, {}};
  traced.of_source.assign(found->sources, no_index);
  if (positions == Positions::range)
    traced.ranges_of_source.assign(found->sources, {no_index, no_index});
  for (std::size_t i = 0; i < found->became.size(); ++i) {
    const std::uint32_t source = found->source_of_chord[i];
    if (found->in_range[i] == 0) {
      traced.of_source[source] = found->became[i];
      continue;
    }
    auto& ranges = traced.ranges_of_source[source];
    ranges[ranges[0] == no_index ? 0 : 1] = found->became[i];
  }
  return traced;
}

}  // namespace evenlift
