// Candidates (algorithm.md): every pair of edges and every rule, exactly.
#include "oracle/exact.h"

#include <algorithm>

namespace oracle {
namespace {

/// As C sees it: not in line with C, and q less than 180 degrees counter-clockwise of p.
struct Edge {
  ExactVec p, q;
};

bool radial(const ExactShape& shape, std::size_t i, Calls& calls) {
  const std::size_t n = shape.vertices.size();
  const RealVec &p = shape.real_vertices[i], &q = shape.real_vertices[(i + 1) % n];
  return calls.within(abs(cross(p, q)) / length(q - p), tau * shape.size, "radial edge");
}

std::optional<Edge> seen_edge(const ExactShape& shape, std::size_t i, Calls& calls) {
  if (radial(shape, i, calls)) return std::nullopt;
  const ExactVec &p = shape.vertices[i], &q = shape.vertices[(i + 1) % shape.vertices.size()];
  return cross(p, q) > 0 ? Edge{p, q} : Edge{q, p};
}

/// The cone from p to q includes p's direction if `start`, q's if `end`.
bool in_cone(const ExactVec& u, const Edge& e, bool start, bool end) {
  const int from_p = sign(cross(e.p, u)), to_q = sign(cross(u, e.q));
  return (from_p > 0 || (start && from_p == 0 && dot(e.p, u) > 0)) &&
         (to_q > 0 || (end && to_q == 0 && dot(e.q, u) > 0));
}

/// s such that C + s u is on the edge's line, which must not be parallel to u.
Exact reach(const ExactVec& u, const Edge& e) {
  const ExactVec along = e.q - e.p;
  return cross(e.p, along) / cross(u, along);
}

/// The open range of directions u for which C + s u meets a and C - s u meets b (s > 0).
struct Range {
  ExactVec first, last;  // the section ends are in these directions and opposite to them
};
std::optional<Range> common_range(const Edge& a, const Edge& b) {
  const Edge across{-b.p, -b.q};  // b mirrored through C, still counter-clockwise
  const ExactVec* first = in_cone(a.p, across, true, false)   ? &a.p
                          : in_cone(across.p, a, true, false) ? &across.p
                                                              : nullptr;
  const ExactVec* last = in_cone(a.q, across, false, true)   ? &a.q
                         : in_cone(across.q, a, false, true) ? &across.q
                                                             : nullptr;
  if (!first || !last) return std::nullopt;
  return Range{*first, *last};
}

struct Section {
  ExactVec on_a, on_b;
  Real g;  // |C on_b| / |C on_a|
  bool between_vertices = false, even = false;
};
Section section_at(const ExactVec& u, const Edge& a, const Edge& b) {
  const Exact to_a = reach(u, a), to_b = -reach(u, b);
  return {u * to_a, u * -to_b, Real(to_b / to_a), false, false};
}

Real ratio_of(const Real& g) { return g <= 1 ? g : 1 / g; }

bool opposite(const ExactShape& shape, const ExactVec& v, const ExactVec& w, Calls& calls) {
  if (dot(v, w) >= 0) return false;
  const RealVec rv = real(v), rw = real(w);
  const Real near = tau * shape.size;
  if (!calls.within(abs(cross(rv, rw)) / length(rv - rw), near, "opposite vertices")) return false;
  for (const RealVec& u : {rv, rw})  // a vertex at C has no direction
    if (calls.within(length(u), near, "vertex at the centre of mass")) return false;
  return true;
}

/// The chord at the end of a range, in direction u from C or away from it. If it meets or nearly
/// meets a vertex of the other edge that is opposite to a vertex there, the result is the chord
/// between the two; g stays that of the section.
Section section_end(const ExactShape& shape, const ExactVec& u, const Edge& a, const Edge& b,
                    Calls& calls) {
  Section seen = section_at(u, a, b);
  const bool on_a = u == a.p || u == a.q;
  const ExactVec &w = on_a ? seen.on_a : seen.on_b, &hit = on_a ? seen.on_b : seen.on_a;
  const Edge& other = on_a ? b : a;
  const ExactVec* v = nullptr;
  Real least = sqrt(tau) * shape.size;
  for (const ExactVec* end : {&other.p, &other.q}) {
    const Real gap = length(real(*end) - real(hit));
    if (!calls.within(gap, least, "chord beside a vertex") || !opposite(shape, *end, w, calls))
      continue;
    if (v && gap >= length(real(*v) - real(hit))) continue;
    v = end;
  }
  if (!v) return seen;
  const Real ratio = ratio_of(length(real(*v)) / length(real(w)));
  const bool even = calls.within(1 - ratio, tau, "even chord between vertices");
  return {on_a ? w : *v, on_a ? *v : w, seen.g, true, even};
}
bool are_one_chord(const Section& one, const Section& two) {
  return one.between_vertices && two.between_vertices && one.on_a == two.on_a &&
         one.on_b == two.on_b;
}

/// Where the line of a meets the line of b mirrored through C.
ExactVec bisecting_point(const Edge& a, const Edge& b) {
  const ExactVec da = a.q - a.p, db = b.q - b.p;
  const Exact ka = cross(a.p, da), kb = -cross(b.p, db);  // r x da = ka, r x db = kb
  const Exact det = cross(da, db);
  return {(kb * da.x - ka * db.x) / det, (kb * da.y - ka * db.y) / det};
}

/// The direction in which |C on_b| / |C on_a| is the geometric mean of its values at the ends;
/// between parallel edges, towards both sections' middles. Roots have 100 digits.
ExactVec middle_of(const Range& range, const Edge& a, const Edge& b) {
  const Section first = section_at(range.first, a, b), last = section_at(range.last, a, b);
  return first.on_a * Exact(sqrt(first.g)) + last.on_a * Exact(sqrt(last.g));
}

/// If even within the tolerance, it is a bisecting chord.
Kind kind_of_vertex_chord(const Real& ratio, Calls& calls) {
  return calls.within(1 - ratio, tau, "even vertex-chord") ? Kind::bisecting : Kind::vertex;
}

/// With the ratio of its arms.
ExactChord chord_between(const ExactVec& v, const ExactVec& w, Calls& calls) {
  const Real ratio = ratio_of(length(real(w)) / length(real(v)));
  ExactChord chord = exact_chord(v, w, kind_of_vertex_chord(ratio, calls), ratio);
  chord.between_vertices = true;
  return chord;
}

/// Of the pair {a, b}, if it has one.
std::optional<ExactChord> candidate_of(const ExactShape& shape, const Edge& a, const Edge& b,
                                       const Range& range, const Real& least_ratio,
                                       CandidateList& list, Calls& calls) {
  const Section one = section_end(shape, range.first, a, b, calls),
                two = section_end(shape, range.last, a, b, calls);
  for (const Real& g : {one.g, two.g})
    if (g != 1)
      list.nearest_unit_g =
          std::min(list.nearest_unit_g, std::fabs(static_cast<double>(Real(g - 1))));

  const auto even_enough = [&](const Real& ratio) {
    calls.note(1 + static_cast<double>((ratio - least_ratio) / tau), "minimum load ratio");
    return ratio >= least_ratio;
  };
  const auto chord_at = [&](const Section& end) {
    if (end.between_vertices) return chord_between(end.on_a, end.on_b, calls);
    const Real ratio = ratio_of(end.g);
    return exact_chord(end.on_a, end.on_b, kind_of_vertex_chord(ratio, calls), ratio);
  };
  if (calls.within(abs(one.g - two.g), tau * std::max(one.g, two.g), "parallel pair")) {
    if (are_one_chord(one, two)) {
      const ExactChord chord = chord_at(one);
      return even_enough(chord.ratio) ? std::optional(chord) : std::nullopt;
    }
    const Section chord = section_at(middle_of(range, a, b), a, b);
    const Real ratio = ratio_of(chord.g);
    if (!even_enough(ratio)) return std::nullopt;
    return exact_chord(chord.on_a, chord.on_b, Kind::midpoint, ratio);
  }
  for (const Section& end : {one, two})
    if (end.even) return chord_at(end);
  if ((one.g - 1) * (two.g - 1) <= 0) {
    const ExactVec r = bisecting_point(a, b);
    return exact_chord(r, -r, Kind::bisecting, Real(1));
  }
  const Section& nearer = ratio_of(one.g) >= ratio_of(two.g) ? one : two;
  const ExactChord chord =
      chord_at(nearer);  // if it joins vertices, its ratio differs from the section's
  return even_enough(chord.ratio) ? std::optional(chord) : std::nullopt;
}

/// If the vertices are opposite and the chord meets the minimum ratio.
std::optional<ExactChord> candidate_between(const ExactShape& shape, std::size_t i, std::size_t j,
                                            const Real& least_ratio, Calls& calls) {
  const ExactVec &v = shape.vertices[i], &w = shape.vertices[j];
  if (!opposite(shape, v, w, calls)) return std::nullopt;
  const ExactChord chord = chord_between(v, w, calls);
  calls.note(1 + static_cast<double>((chord.ratio - least_ratio) / tau), "minimum load ratio");
  if (chord.ratio < least_ratio) return std::nullopt;
  return chord;
}

/// The greater distance between the ends of two chords, matched the better way.
double apart_in_doubles(const ExactChord& a, const ExactChord& b) {
  const auto gap = [](const RealVec& p, const RealVec& q) {
    return std::hypot(static_cast<double>(p.x) - static_cast<double>(q.x),
                      static_cast<double>(p.y) - static_cast<double>(q.y));
  };
  return std::min(
      std::max(gap(a.real_ends[0], b.real_ends[0]), gap(a.real_ends[1], b.real_ends[1])),
      std::max(gap(a.real_ends[0], b.real_ends[1]), gap(a.real_ends[1], b.real_ends[0])));
}
Real apart(const ExactChord& a, const ExactChord& b) {
  const auto gap = [](const RealVec& p, const RealVec& q) { return length(p - q); };
  return std::min(
      std::max(gap(a.real_ends[0], b.real_ends[0]), gap(a.real_ends[1], b.real_ends[1])),
      std::max(gap(a.real_ends[0], b.real_ends[1]), gap(a.real_ends[1], b.real_ends[0])));
}
bool same_chord(const ExactChord& a, const ExactChord& b, const Real& size, Calls& calls) {
  // Quick, far above the errors of doubles: ends are relative to C, so at most L in size.
  if (apart_in_doubles(a, b) > 1e-6 * static_cast<double>(size)) return false;
  return calls.within(apart(a, b), tau * size, "duplicate chords");
}

/// Where "agrees" is not transitive, all linked directions count as one.
class Order {
 public:
  Order(const Real& size, Calls& calls) : size_(size), calls_(calls) {}

  void sort(std::vector<ExactChord>& chords) {
    std::stable_sort(chords.begin(), chords.end(), [&](const ExactChord& a, const ExactChord& b) {
      const bool a_vertical = vertical(a.direction), b_vertical = vertical(b.direction);
      if (a_vertical || b_vertical) return b_vertical && !a_vertical;
      return cross(a.direction, b.direction) > 0;
    });
    by_class(
        chords.begin(), chords.end(),
        [&](const ExactChord& a, const ExactChord& b) { return one_line(a, b); },
        [&](Iterator first, Iterator last) { sort_line(first, last); });
  }

 private:
  using Iterator = std::vector<ExactChord>::iterator;
  /// Visits the classes of a sorted list: each element linked to the preceding one joins its class.
  template <class Linked, class Visit>
  static void by_class(Iterator first, Iterator last, Linked linked, Visit visit) {
    while (first != last) {
      Iterator end = first + 1;
      while (end != last && linked(*(end - 1), *end)) ++end;
      visit(first, end);
      first = end;
    }
  }
  /// Sorts by a key, the largest first, and visits the classes of chords that tie with their first.
  template <class Key, class Ties, class Visit>
  static void by_ties(Iterator first, Iterator last, Key key, Ties ties, Visit visit) {
    std::stable_sort(first, last,
                     [&](const ExactChord& a, const ExactChord& b) { return key(a) > key(b); });
    while (first != last) {
      Iterator end = first + 1;
      while (end != last && ties(key(*first), key(*end))) ++end;
      visit(first, end);
      first = end;
    }
  }

  /// The longer first, then the one whose right end is farther from C. Two chords of a bent line
  /// can tie in both; then their ends' coordinates decide, if they differ by more than half the
  /// tolerance.
  void sort_line(Iterator begin, Iterator end) {
    const auto length_of = [](const ExactChord& c) { return c.length; };
    const auto right_arm_of = [&](const ExactChord& c) { return right_arm(c); };
    const auto ties = [&](const char* what) {
      return [this, what](const Real& a, const Real& b) {
        return calls_.within(a - b, tau * a, what);
      };
    };
    by_ties(begin, end, length_of, ties("lengths in candidate order"), [&](Iterator i, Iterator j) {
      by_ties(i, j, right_arm_of, ties("arms in candidate order"),
              [&](Iterator first, Iterator last) { sort_by_coordinates(first, last, 0); });
    });
  }
  void sort_by_coordinates(Iterator begin, Iterator end, std::size_t which) {
    if (end - begin == 1) return;
    if (which == 4) {
      std::stable_sort(begin, end, [&](const ExactChord& a, const ExactChord& b) {
        return coordinates(a) < coordinates(b);
      });
      return;
    }
    by_ties(
        begin, end, [&](const ExactChord& c) { return Real(-coordinates(c)[which]); },
        [&](const Real& a, const Real& b) {
          return calls_.within(a - b, tau * size_ / 2, "coordinates in candidate order");
        },
        [&](Iterator first, Iterator last) { sort_by_coordinates(first, last, which + 1); });
  }
  bool vertical(const RealVec& u) {
    return calls_.within(abs(u.x) / length(u), tau, "vertical direction");
  }
  bool one_line(const ExactChord& a, const ExactChord& b) {
    const bool a_vertical = vertical(a.direction), b_vertical = vertical(b.direction);
    if (a_vertical || b_vertical) return a_vertical && b_vertical;
    const Real sine = abs(cross(a.direction, b.direction)) / (a.length * b.length);
    return calls_.within(sine, tau, "equal directions");
  }
  /// The right end, or the upper one of a vertical chord.
  std::size_t right_end(const ExactChord& c) {
    const ExactVec &e0 = c.ends[0], &e1 = c.ends[1];
    return vertical(c.direction) ? e1.y > e0.y : e1.x > e0.x;
  }
  Real right_arm(const ExactChord& c) { return length(c.real_ends[right_end(c)]); }
  /// Of the left end, then of the right one.
  std::array<Exact, 4> coordinates(const ExactChord& c) {
    const std::size_t right = right_end(c);
    const ExactVec &p = c.ends[1 - right], &q = c.ends[right];
    return {p.x, p.y, q.x, q.y};
  }
  Real size_;
  Calls& calls_;
};

/// Of duplicate chords: one between opposite vertices, else the largest ratio, then the first in
/// order. A chord between vertices keeps its kind; otherwise precedence decides it.
ExactChord standing_one(std::vector<ExactChord> same, const Real& size, Calls& calls) {
  Order(size, calls).sort(same);
  ExactChord best = same.front();
  for (const ExactChord& c : same)
    if (c.between_vertices != best.between_vertices ? c.between_vertices : c.ratio > best.ratio)
      best = c;
  for (const ExactChord& c : same) {
    if (!best.between_vertices) best.kind = std::min(best.kind, c.kind);
    best.ratio_slack = std::max<Real>(best.ratio_slack, abs(best.ratio - c.ratio));
    best.ends_slack = std::max<Real>(best.ends_slack, apart(best, c));
  }
  return best;
}

std::vector<ExactChord> merged(const std::vector<ExactChord>& chords, const Real& size,
                               Calls& calls) {
  std::vector<ExactChord> result;
  std::vector<bool> used(chords.size(), false);
  for (std::size_t i = 0; i < chords.size(); ++i) {
    if (used[i]) continue;
    used[i] = true;
    std::vector<std::size_t> group{i};
    for (std::size_t k = 0; k < group.size(); ++k)
      for (std::size_t j = 0; j < chords.size(); ++j)
        if (!used[j] && same_chord(chords[group[k]], chords[j], size, calls)) {
          used[j] = true;
          group.push_back(j);
        }
    std::vector<ExactChord> same;
    for (std::size_t k : group) {
      same.push_back(chords[k]);
      for (std::size_t j : group)
        if (!same_chord(chords[k], chords[j], size, calls))
          calls.either_is_right("chain of duplicate chords");
    }
    result.push_back(standing_one(same, size, calls));
  }
  return result;
}

Point rounded(const ExactShape& shape, const ExactVec& v) {
  return {nearest_double(shape.centre.x + v.x), nearest_double(shape.centre.y + v.y)};
}

CandidateList packed(CandidateList list, std::vector<ExactChord> chords) {
  for (const ExactChord& c : chords)
    list.candidates.push_back({{rounded(*list.shape, c.ends[0]), rounded(*list.shape, c.ends[1])},
                               static_cast<double>(c.ratio),
                               c.kind,
                               static_cast<double>(c.ratio_slack),
                               static_cast<double>(c.ends_slack)});
  list.chords = std::make_shared<ExactChords>(ExactChords{std::move(chords)});
  return list;
}

}  // namespace

ExactChord exact_chord(const ExactVec& end0, const ExactVec& end1, Kind kind, const Real& ratio) {
  ExactChord c{{end0, end1}, {real(end0), real(end1)}, ratio, 0, {0, 0}, kind, 0, 0, false};
  c.direction = c.real_ends[1] - c.real_ends[0];
  if (c.direction.x < 0 || (c.direction.x == 0 && c.direction.y < 0)) c.direction = -c.direction;
  c.length = length(c.direction);
  return c;
}

CandidateList find_candidates(const Problem& problem) {
  CandidateList list;
  Calls calls;
  list.shape = exact_shape(problem);
  const std::size_t n = list.shape->vertices.size();
  std::vector<Edge> edges;
  for (std::size_t i = 0; i < n; ++i)
    if (const std::optional<Edge> e = seen_edge(*list.shape, i, calls)) edges.push_back(*e);

  const Real least_ratio = Real(problem.min_ratio) - tau;
  std::vector<ExactChord> chords;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    for (std::size_t j = i + 1; j < edges.size(); ++j) {
      const std::optional<Range> range = common_range(edges[i], edges[j]);
      if (!range) continue;
      ++list.pairs;
      const RealVec first = real(range->first), last = real(range->last);
      list.thinnest_range =
          std::min(list.thinnest_range,
                   static_cast<double>(cross(first, last) / (length(first) * length(last))));
      if (const auto c =
              candidate_of(*list.shape, edges[i], edges[j], *range, least_ratio, list, calls))
        chords.push_back(*c);
    }
  }
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 1; j < n; ++j)
      if (const auto c = candidate_between(*list.shape, i, j, least_ratio, calls))
        chords.push_back(*c);
  chords = merged(chords, list.shape->size, calls);
  Order(list.shape->size, calls).sort(chords);
  list.closest_call = calls.closest();
  return packed(std::move(list), std::move(chords));
}

CandidateList given_candidates(const Problem& problem, const std::vector<Candidate>& given) {
  CandidateList list;
  list.shape = exact_shape(problem);
  std::vector<ExactChord> chords;
  for (const Candidate& c : given)
    chords.push_back(exact_chord(exact(c.ends[0]) - list.shape->centre,
                                 exact(c.ends[1]) - list.shape->centre, c.kind, Real(c.ratio)));
  return packed(std::move(list), std::move(chords));
}

std::vector<std::array<Point, 2>> vertex_chords(const Problem& problem) {
  const auto shape = exact_shape(problem);
  const std::vector<ExactVec>& v = shape->vertices;
  const std::size_t n = v.size();
  Calls calls;
  std::vector<std::array<Point, 2>> result;
  for (std::size_t i = 0; i < n; ++i) {
    if (v[i] == ExactVec{0, 0}) continue;
    const ExactVec u = -v[i];
    for (std::size_t j = 0; j < n; ++j)  // a hit at a vertex counts once for two
      if (j > i && cross(u, v[j]) == 0 && dot(u, v[j]) > 0)
        result.push_back({rounded(*shape, v[i]), rounded(*shape, v[j])});
    for (std::size_t j = 0; j < n; ++j)
      if (const auto e = seen_edge(*shape, j, calls); e && in_cone(u, *e, false, false))
        result.push_back({rounded(*shape, v[i]), rounded(*shape, u * reach(u, *e))});
  }
  return result;
}

}  // namespace oracle
