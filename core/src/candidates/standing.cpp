#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <tuple>
#include <utility>

#include "candidates/candidate_order.h"
#include "candidates/pair_candidate.h"
#include "candidates/standing.h"
#include "chords/radial_view.h"
#include "evenlift/candidates.h"
#include "evenlift/tolerance.h"
#include "exact/pseudo_angle.h"
#include "exact/sorted_indices.h"

namespace evenlift {
namespace {

double evenness(double q) { return q < 1 ? q : 1 / q; }

Candidate make_candidate(const Vec2& centre, const StandLine& a, const StandLine& b, double t,
                         double q, CandidateKind kind) {
  const Vec2 offset = a.at(t);
  const double arm = length(offset), g = 1 / q;
  const LiftingPoint ahead{centre + offset, a.edge}, behind{centre - g * offset, b.edge};
  Candidate candidate;
  candidate.chord = order_ends(ahead, arm, behind, g * arm, offset);
  candidate.chord.ratio = evenness(q);
  candidate.kind = kind;
  candidate.direction = rightward(offset);
  candidate.length = candidate.chord.arm1 + candidate.chord.arm2;
  return candidate;
}

class Finder {
 public:
  Finder(const Vec2& centre, const StandLine& a, const StandLine& b, double min_ratio, double near)
      : centre_(centre),
        a_(a),
        b_(b),
        range_(a, b),
        near_(near),
        pieces_(range_.pieces(min_ratio)) {}

  // Passes the best chord to `take` first, unless it is already known.
  template <class Take>
  void run(bool best_is_known, Take take) const {
    if (pieces_.empty()) return;
    if (!best_is_known) take(best());
    for (const Stretch& piece : pieces_)
      for (const double t : {piece.from, piece.to})
        if (ends_on_both(t)) take(at(t));
  }

 private:
  // An even chord counts as bisecting unless the lines are parallel. All others are range chords.
  Candidate at(double t) const {
    const double q = range_.q(t);
    const bool even = evenness(q) >= 1 - tau && !parallel();
    return make_candidate(centre_, a_, b_, t, q,
                          even ? CandidateKind::bisecting : CandidateKind::range);
  }

  // The range in which the lines, from their first to last usable places, face each other.
  std::optional<Stretch> whole() const {
    return range_.common({a_.low, a_.high}, {b_.low, b_.high});
  }

  bool parallel() const {
    const auto range = whole();
    if (!range) return true;
    const double g0 = 1 / range_.q(range->from), g1 = 1 / range_.q(range->to);
    return std::fabs(g0 - g1) <= tau * std::max(g0, g1);
  }

  Candidate best() const { return parallel() ? nearest_to_middle() : most_even(); }

  Candidate nearest_to_middle() const {
    const auto range = whole();
    const double middle = range ? (range->from + range->to) / 2 : pieces_.front().from;
    std::vector<double> places;
    for (const Stretch& piece : pieces_) places.push_back(std::clamp(middle, piece.from, piece.to));
    const double place = longest_of(places, [&](double t, double u) {
      const double way = std::fabs(t - middle), other = std::fabs(u - middle);
      return std::fabs(way - other) <= near_ ? 0 : way < other ? 1 : -1;
    });
    Candidate candidate = at(place);
    if (place == middle) candidate.kind = CandidateKind::midpoint;
    return candidate;
  }

  Candidate most_even() const {
    const double bisecting = (1 - range_.q0()) / range_.slope();
    for (const Stretch& piece : pieces_)
      if (bisecting >= piece.from && bisecting <= piece.to)
        return make_candidate(centre_, a_, b_, bisecting, 1, CandidateKind::bisecting);
    std::vector<double> places;
    for (const Stretch& piece : pieces_) {
      places.push_back(piece.from);
      places.push_back(piece.to);
    }
    return at(longest_of(places, [&](double t, double u) {
      const double ratio = evenness(range_.q(t)), other = evenness(range_.q(u));
      return ratios_tie(ratio, other) ? 0 : ratio > other ? 1 : -1;
    }));
  }

  // The best place by `compare`; of those that tie, the one with the longest chord, then the first.
  template <class Compare>
  double longest_of(const std::vector<double>& places, Compare compare) const {
    double best = places.front();
    for (const double place : places)
      if (compare(place, best) > 0) best = place;
    double chosen = best;
    for (const double place : places)
      if (compare(place, best) == 0 && size(place) > size(chosen) * (1 + tau)) chosen = place;
    return chosen;
  }

  double size(double t) const { return length(a_.at(t)) * (1 + 1 / range_.q(t)); }

  bool ends_on_both(double t) const {
    return is_end(a_.usable, t) && is_end(b_.usable, range_.on_b(t));
  }

  bool is_end(const Stands::Stretches& stretches, double t) const {
    return std::any_of(stretches.begin(), stretches.end(), [&](const Stretch& s) {
      return std::fabs(s.from - t) <= near_ || std::fabs(s.to - t) <= near_;
    });
  }

  Vec2 centre_;
  const StandLine &a_, &b_;
  ChordRange range_;
  double near_;
  std::vector<Stretch> pieces_;  // of `a`, where robots can stand at both ends of a chord
};

// If `best` is given, it comes first, unchanged. If a line is missing, there are no others.
std::vector<Candidate> usable_chords(const std::optional<Candidate>& best, const Stands& stands,
                                     const Vec2& centre, const StandLine* a, const StandLine* b,
                                     double min_ratio, double near) {
  std::vector<Candidate> found;
  if (best) found.push_back(*best);
  if (!a || !b || std::fabs(a->height) <= near || std::fabs(b->height) <= near) return found;
  Finder(centre, *a, *b, min_ratio, near).run(best.has_value(), [&](const Candidate& candidate) {
    if (reaches(candidate.chord, min_ratio) && can_stand(stands, candidate))
      found.push_back(candidate);
  });
  return found;
}

}  // namespace

std::optional<StandLine> stand_line(const Polygon& polygon, const Vec2& centre,
                                    const Stands& stands, std::uint32_t edge) {
  const Stands::Stretches usable = stands.usable(edge);
  if (usable.empty()) return std::nullopt;
  const Vec2 &p = polygon.edge_start(edge), &q = polygon.edge_end(edge);
  StandLine line;
  line.edge = edge;
  line.start = stands.lifting_point({p, edge}).position - centre;
  line.along = (q - p) / length(q - p);
  line.low = usable.begin()->from;
  line.high = (usable.end() - 1)->to;
  line.usable = usable;
  line.height = cross(line.start, line.along);
  return line;
}

bool can_stand(const Stands& stands, const Candidate& candidate) {
  const LiftingPoint &r1 = candidate.chord.r1, &r2 = candidate.chord.r2;
  return stands.can_use(r1) && stands.can_use(r2) && !stands.collide(r1, r2);
}

std::vector<Candidate> standing_chords(const Stands& stands, const Vec2& centre, const StandLine& a,
                                       const StandLine& b, double min_ratio, double near) {
  return usable_chords(std::nullopt, stands, centre, &a, &b, min_ratio, near);
}

std::vector<Candidate> standing_chords(const Polygon& polygon, const Stands& stands,
                                       const Vec2& centre, const EdgePair& pair, double min_ratio) {
  const PairVerdict verdict = examine_pair(polygon, centre, pair, min_ratio);
  std::optional<Candidate> best;
  if (verdict.candidate && can_stand(stands, *verdict.candidate)) best = verdict.candidate;
  std::optional<StandLine> a, b;
  if (!best || stands.has_body()) {
    a = stand_line(polygon, centre, stands, pair.a);
    b = stand_line(polygon, centre, stands, pair.b);
  }
  return usable_chords(best, stands, centre, a ? &*a : nullptr, b ? &*b : nullptr, min_ratio,
                       near_distance(polygon.diameter()));
}

// --- The ranges of robots with a size, and the candidates in them.

namespace {

// The length of a range, on both edges together.
double way(const PairRange& range) {
  const Vec2 on_a = range.a1 - range.a0;
  const Vec2 on_b = range.a1 / range.q1 - range.a0 / range.q0;
  return length(on_a) + length(on_b);
}

}  // namespace

std::vector<PairRange> standing_ranges(const StandLine& a, const StandLine& b, double min_ratio,
                                       double near) {
  std::vector<PairRange> ranges;
  if (std::fabs(a.height) <= near || std::fabs(b.height) <= near) return ranges;
  const ChordRange chords(a, b);
  for (const Stretch& piece : chords.pieces(min_ratio)) {
    PairRange range;
    range.a = a.edge;
    range.b = b.edge;
    range.a0 = a.at(piece.from);
    range.a1 = a.at(piece.to);
    range.q0 = chords.q(piece.from);
    range.q1 = chords.q(piece.to);
    ranges.push_back(range);
  }
  return ranges;
}

std::vector<PairRange> standing_ranges(const Polygon& polygon, const Vec2& centre, std::uint32_t a,
                                       std::uint32_t b, double min_ratio, const Stands& stands) {
  const auto line_a = stand_line(polygon, centre, stands, a);
  const auto line_b = stand_line(polygon, centre, stands, b);
  if (!line_a || !line_b) return {};
  return standing_ranges(*line_a, *line_b, min_ratio, near_distance(polygon.diameter()));
}

std::size_t longest_range(const std::vector<PairRange>& ranges, double near) {
  std::size_t longest = 0;
  for (std::size_t i = 1; i < ranges.size(); ++i)
    if (way(ranges[i]) > way(ranges[longest]) + near) longest = i;
  return longest;
}

std::vector<Candidate> standing_range_chords(const FromCorners& from, const Vec2& centre,
                                             const StandLine& a, const StandLine& b,
                                             double min_ratio, double near) {
  const std::vector<PairRange> ranges = standing_ranges(a, b, min_ratio, near);
  std::vector<Candidate> found;
  if (ranges.empty()) return found;
  const PairRange& range = ranges[longest_range(ranges, near)];
  if (is_one_place(range, near)) return found;
  const auto clear = clear_part(from, centre, range);
  for (const double s : range_places) {
    const Candidate candidate = range_candidate(centre, range, clear_place_at(range, clear, s));
    if (reaches(candidate.chord, min_ratio) && can_stand(*from.stands, candidate))
      found.push_back(candidate);
  }
  return found;
}

namespace {

constexpr double half_turn = 2;  // of pseudo_angle

// Unlike in RadialSweep (chords), directions are rounded: these lines are computed, so their ends
// have no exact directions. Rounding confuses only lines whose common range of directions is about
// 1e-16 rad. Such a range is one place within tau L, and ChordRange then decides, within tau L,
// whether a chord ends on both lines.
//
// A line through C turns by 180 degrees. Its half ahead meets each listed line from that line's
// first to its last direction; its half behind, half a turn later.
struct Event {
  double angle;  // in [0, half_turn)
  bool enters;   // leaving lines come first, since the ranges are open
  std::uint32_t line;
  int side;  // 0: ahead, 1: behind
  bool operator<(const Event& other) const {
    return std::tie(angle, enters, line) < std::tie(other.angle, other.enters, other.line);
  }
};

// The lines that one half of the turning line meets.
class Met {
 public:
  explicit Met(std::size_t lines) : slots_(lines, none) {}

  void add(std::uint32_t line) {
    if (slots_[line] != none) return;
    slots_[line] = lines_.size();
    lines_.push_back(line);
  }

  void remove(std::uint32_t line) {
    const std::size_t slot = std::exchange(slots_[line], none);
    if (slot == none) return;
    if (lines_.back() != line) {
      lines_[slot] = lines_.back();
      slots_[lines_.back()] = slot;
    }
    lines_.pop_back();
  }

  const std::vector<std::uint32_t>& lines() const { return lines_; }

 private:
  static constexpr std::size_t none = ~std::size_t{0};
  std::vector<std::size_t> slots_;
  std::vector<std::uint32_t> lines_;
};

int side_of(double angle) { return angle < half_turn ? 0 : 1; }

}  // namespace

void for_each_facing(const std::vector<StandLine>& lines, double near,
                     const std::function<bool(std::uint32_t i, std::uint32_t j)>& visit) {
  std::vector<Event> events;
  Met met[2] = {Met(lines.size()), Met(lines.size())};
  for (std::uint32_t i = 0; i < lines.size(); ++i) {
    const StandLine& line = lines[i];
    if (std::fabs(line.height) <= near) continue;
    double first = pseudo_angle(line.at(line.low)), last = pseudo_angle(line.at(line.high));
    if (line.height < 0) std::swap(first, last);
    if (first == last) continue;
    for (const auto& [angle, enters] : {std::pair(first, true), std::pair(last, false)})
      events.push_back({angle - half_turn * side_of(angle), enters, i, side_of(angle)});
    // Lines that are met from the beginning.
    if (first > last && last > 0) met[0].add(i);
    if (first < half_turn && last > half_turn) met[1].add(i);
  }
  sort_items(events, std::less<Event>());
  for (const Event& event : events) {
    if (!event.enters) {
      met[event.side].remove(event.line);
      continue;
    }
    for (const std::uint32_t other : met[1 - event.side].lines())
      if (!(event.side == 0 ? visit(event.line, other) : visit(other, event.line))) return;
    met[event.side].add(event.line);
  }
}

namespace {

// The unsorted candidates, the best of each source first. Until the end, a candidate's `source` is
// its number here.
struct FoundStanding {
  struct Origin {
    std::uint32_t source;
    bool in_range;  // from positions anywhere in the range
  };
  std::vector<Candidate> candidates;
  std::vector<Origin> origins;  // by candidate
  std::uint32_t sources = 0;
  void add(const std::vector<Candidate>& some, std::uint32_t source, bool in_range) {
    for (const Candidate& candidate : some) {
      candidates.push_back(candidate);
      candidates.back().source = static_cast<std::uint32_t>(origins.size());
      origins.push_back({source, in_range});
    }
  }
};

struct Wanted {
  const Polygon& polygon;
  Vec2 centre;
  double min_ratio;
  const Stands& stands;
  Positions positions;
  double near;
  FromCorners from_corners;
};

void add_pair(const Wanted& wanted, const EdgePair& pair, FoundStanding& found) {
  const auto& [polygon, centre, min_ratio, stands, positions, near, from_corners] = wanted;
  found.add(standing_chords(polygon, stands, centre, pair, min_ratio), found.sources, false);
  if (positions != Positions::range) return;
  const auto a = stand_line(polygon, centre, stands, pair.a);
  const auto b = stand_line(polygon, centre, stands, pair.b);
  if (a && b)
    found.add(standing_range_chords(from_corners, centre, *a, *b, min_ratio, near), found.sources,
              true);
}

// For hands without depth: the edge pairs and opposite vertices of the polygon.
std::optional<InputError> find_on_outline(const Wanted& wanted, FoundStanding& found) {
  const auto& [polygon, centre, min_ratio, stands, positions, near, from_corners] = wanted;
  const RadialView view(polygon, centre);
  const std::uint64_t pairs = count_edge_pairs(polygon, view);
  if (auto error = check_number(pairs, "edge pairs")) return error;
  const auto opposite = find_opposite_vertices(polygon, centre, view, max_edge_pairs - pairs);
  if (!opposite) return too_many_opposite_vertices();
  for_each_edge_pair(polygon, view, [&](const EdgePair& pair) {
    if (found.candidates.size() <= max_edge_pairs) add_pair(wanted, pair, found);
    ++found.sources;
  });
  for (const OppositeVertices& two : *opposite) {
    const Candidate candidate = opposite_chord(polygon, centre, two);
    if (!stands.has_body() && reaches(candidate.chord, min_ratio) && can_stand(stands, candidate))
      found.add({candidate}, found.sources, false);
    ++found.sources;
  }
  return std::nullopt;
}

struct NumberedPair {
  std::array<std::uint32_t, 2> edges;
  std::uint32_t number;
};

// The edge pairs of the polygon, which are the sources of chords between moved edges.
std::vector<NumberedPair> numbered_pairs(const Polygon& polygon, const RadialView& view) {
  std::vector<NumberedPair> pairs;
  for_each_edge_pair(polygon, view, [&](const EdgePair& pair) {
    pairs.push_back({{std::min(pair.a, pair.b), std::max(pair.a, pair.b)},
                     static_cast<std::uint32_t>(pairs.size())});
  });
  sort_items(pairs, [](const NumberedPair& a, const NumberedPair& b) {
    return a.edges != b.edges ? a.edges < b.edges : a.number < b.number;
  });
  return pairs;
}

std::uint32_t number_of_pair(const std::vector<NumberedPair>& pairs, std::uint32_t a,
                             std::uint32_t b) {
  const std::array edges{std::min(a, b), std::max(a, b)};
  const auto at = std::lower_bound(
      pairs.begin(), pairs.end(), edges,
      [](const NumberedPair& pair, const auto& wanted) { return pair.edges < wanted; });
  return at != pairs.end() && at->edges == edges ? at->number : no_index;
}

void add_lines(const Wanted& wanted, const StandLine& a, const StandLine& b, std::uint32_t source,
               FoundStanding& found) {
  const auto& [polygon, centre, min_ratio, stands, positions, near, from_corners] = wanted;
  found.add(standing_chords(stands, centre, a, b, min_ratio, near), source, false);
  if (positions == Positions::range)
    found.add(standing_range_chords(from_corners, centre, a, b, min_ratio, near), source, true);
}

// For hands with depth: the edges, moved inward.
std::optional<InputError> find_on_moved_edges(const Wanted& wanted, FoundStanding& found) {
  const Polygon& polygon = wanted.polygon;
  const Vec2& centre = wanted.centre;
  const RadialView view(polygon, centre);
  const std::uint64_t outline_pairs = count_edge_pairs(polygon, view);
  if (auto error = check_number(outline_pairs, "edge pairs")) return error;
  const auto opposite =
      find_opposite_vertices(polygon, centre, view, max_edge_pairs - outline_pairs);
  if (!opposite) return too_many_opposite_vertices();
  const std::vector<NumberedPair> numbers = numbered_pairs(polygon, view);
  found.sources = static_cast<std::uint32_t>(numbers.size() + opposite->size());
  std::vector<StandLine> lines;
  for (std::uint32_t edge = 0; edge < polygon.size(); ++edge)
    if (const auto line = stand_line(polygon, centre, wanted.stands, edge)) lines.push_back(*line);
  std::uint64_t pairs = 0;
  for_each_facing(lines, wanted.near, [&](std::uint32_t i, std::uint32_t j) {
    add_lines(wanted, lines[i], lines[j], number_of_pair(numbers, lines[i].edge, lines[j].edge),
              found);
    return ++pairs <= max_edge_pairs && found.candidates.size() <= max_edge_pairs;
  });
  return check_number(pairs, "pairs of edges, moved inward,");
}

void note_sources(const FoundStanding& found, const std::vector<std::uint32_t>& became_of,
                  Positions positions, TracedCandidates& traced) {
  traced.of_source.assign(found.sources, no_index);
  if (positions == Positions::range)
    traced.ranges_of_source.assign(found.sources, {no_index, no_index});
  for (std::size_t i = 0; i < found.origins.size(); ++i) {
    const auto& [source, in_range] = found.origins[i];
    if (source == no_index) continue;
    std::uint32_t& of_pair = traced.of_source[source];
    if (!in_range && of_pair == no_index) of_pair = became_of[i];
    if (!in_range) continue;
    auto& ranges = traced.ranges_of_source[source];
    ranges[ranges[0] == no_index ? 0 : 1] = became_of[i];
  }
  for (auto& [first, last] : traced.ranges_of_source)
    if (last < first) std::swap(first, last);
}

}  // namespace

Result<TracedCandidates> standing_candidates(const Polygon& polygon, const Vec2& centre,
                                             double min_ratio, const Stands& stands,
                                             Positions positions, double clear) {
  const double near = near_distance(polygon.diameter());
  const Corners corners(polygon);
  const Wanted wanted{
      polygon, centre, min_ratio, stands, positions, near, {polygon, corners, clear, &stands}};
  FoundStanding found;
  const bool on_outline = stands.robot().depth == 0;
  if (auto error = on_outline ? find_on_outline(wanted, found) : find_on_moved_edges(wanted, found))
    return *error;
  if (auto error = check_number(found.candidates.size(), "candidates")) return *error;
  std::vector<Candidate> ordered = in_candidate_order(found.candidates, near);
  std::vector<std::uint32_t> number;  // in `found`
  for (const Candidate& candidate : ordered) number.push_back(candidate.source);
  MergedCandidates merged = merge_duplicates(std::move(ordered), near);
  std::vector<std::uint32_t> became_of(number.size());
  for (std::size_t i = 0; i < number.size(); ++i) became_of[number[i]] = merged.became[i];
  TracedCandidates traced{std::move(merged.candidates), {}, {}};
  for (Candidate& candidate : traced.candidates)
    candidate.source = found.origins[candidate.source].source;
  note_sources(found, became_of, positions, traced);
  return traced;
}

}  // namespace evenlift
