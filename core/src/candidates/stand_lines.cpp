#include "candidates/stand_lines.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "candidates/chord_range.h"
#include "candidates/pair_candidate.h"
#include "chords/section.h"
#include "evenlift/tolerance.h"

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

}  // namespace evenlift
