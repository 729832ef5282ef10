#include "evenlift/candidates.h"

#include <algorithm>
#include <cmath>

#include "candidate_list.h"
#include "double_double.h"
#include "evenlift/predicates.h"
#include "evenlift/tolerance.h"
#include "radial_view.h"
#include "section.h"

namespace evenlift {
namespace {

// An edge with its ends in the counter-clockwise order in which C sees them.
struct Seen {
  std::uint32_t edge;
  const Vec2& first;
  const Vec2& last;
};

Seen see(const Polygon& polygon, const Vec2& centre, std::uint32_t edge) {
  const Vec2 &p = polygon.edge_start(edge), &q = polygon.edge_end(edge);
  if (orient(centre, p, q) > 0) return {edge, p, q};
  return {edge, q, p};
}

// One end of a pair's range: the vertex-chord there.
struct SectionEnd {
  std::uint32_t vertex;    // at which the range ends
  std::uint32_t opposite;  // the vertex across C, if both edges end here, else inside_edge
  bool on_a;               // the vertex is a's
  Across across;           // from the vertex to the other edge
  double g;                // |C r_b| / |C r_a|
  int excess;              // exact sign of g - 1
};

SectionEnd section_end(const Polygon& polygon, const Vec2& centre, const Seen& a, const Seen& b,
                       std::uint32_t vertex_a, std::uint32_t vertex_b) {
  const bool on_a = vertex_a != inside_edge;
  const std::uint32_t vertex = on_a ? vertex_a : vertex_b;
  const Seen& other = on_a ? b : a;
  const Across across = look_across(centre, polygon.vertex(vertex), other.first, other.last);
  return {vertex,
          on_a ? vertex_b : inside_edge,
          on_a,
          across,
          on_a ? across.factor : 1.0 / across.factor,
          on_a ? across.excess : -across.excess};
}

Candidate make_candidate(const Chord& chord, CandidateKind kind, const Vec2& direction) {
  return {chord, kind, points_right(direction) ? direction : Vec2(-direction),
          chord.arm1 + chord.arm2};
}

Candidate vertex_candidate(const Polygon& polygon, const Vec2& centre, const Seen& a, const Seen& b,
                           const SectionEnd& end, CandidateKind kind) {
  const Chord chord = chord_from_vertex(polygon, centre, end.vertex, end.on_a ? a.edge : b.edge,
                                        end.across, end.on_a ? b.edge : a.edge, end.opposite);
  return make_candidate(chord, kind, centre - polygon.vertex(end.vertex));
}

// C r_a at a section end.
Vec2 offset_on_a(const Polygon& polygon, const Vec2& centre, const SectionEnd& end) {
  const Vec2 offset = polygon.vertex(end.vertex) - centre;
  return end.on_a ? offset : Vec2(-end.across.factor * offset);
}

Candidate midpoint_candidate(const Polygon& polygon, const Vec2& centre, const Seen& a,
                             const Seen& b, const SectionEnd& begin, const SectionEnd& end) {
  const Vec2 offset =
      0.5 * (offset_on_a(polygon, centre, begin) + offset_on_a(polygon, centre, end));
  // 1 / g is linear along a.
  const double g = 2.0 / (1.0 / begin.g + 1.0 / end.g);
  const double arm = length(offset);
  Chord chord =
      order_ends({centre + offset, a.edge}, arm, {centre - g * offset, b.edge}, g * arm, offset);
  chord.ratio = g < 1.0 ? g : 1.0 / g;
  return make_candidate(chord, CandidateKind::midpoint, offset);
}

// C r_a for the chord that C bisects: where the line of a meets the line of b reflected through C,
// which is equation 3.6 without trigonometry. With d the edges' vectors and h twice the areas that
// they span with C it is -(h_b d_a + h_a d_b) / (d_a x d_b). The sum cancels for nearly parallel
// edges; then it is taken in double-double.
Vec2 bisecting_offset(const Vec2& centre, const Seen& a, const Seen& b) {
  const Vec2 da = a.last - a.first, db = b.last - b.first;
  const double ha = orient(centre, a.first, a.last), hb = orient(centre, b.first, b.last);
  const Vec2 sum = hb * da + ha * db;
  const double size = hb * length(da) + ha * length(db);
  constexpr double enough = 0x1p-5;
  if (length(sum) > enough * size) {
    return -sum / cross_of_differences(a.first, a.last, b.first, b.last);
  }

  const auto difference = [](const Vec2& p, const Vec2& q) {
    return std::pair(two_difference(q.x(), p.x()), two_difference(q.y(), p.y()));
  };
  const auto area = [](const auto& u, const auto& v) {
    return u.first * v.second - u.second * v.first;
  };
  const auto fine_da = difference(a.first, a.last), fine_db = difference(b.first, b.last);
  const auto fine_ha = area(difference(centre, a.first), difference(centre, a.last));
  const auto fine_hb = area(difference(centre, b.first), difference(centre, b.last));
  const DoubleDouble divisor = area(fine_da, fine_db);
  const DoubleDouble x = (fine_hb * fine_da.first + fine_ha * fine_db.first) / divisor;
  const DoubleDouble y = (fine_hb * fine_da.second + fine_ha * fine_db.second) / divisor;
  return {-x.to_double(), -y.to_double()};
}

Candidate bisecting_candidate(const Vec2& centre, const Seen& a, const Seen& b) {
  const Vec2 offset = bisecting_offset(centre, a, b);
  const double arm = length(offset);
  const Chord chord =
      order_ends({centre + offset, a.edge}, arm, {centre - offset, b.edge}, arm, offset);
  return make_candidate(chord, CandidateKind::bisecting, offset);
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
  }
  return {};
}

bool is_even(const Chord& chord) { return chord.ratio >= 1.0 - tau; }

PairVerdict examine_pair(const Polygon& polygon, const Vec2& centre, const EdgePair& pair,
                         double min_ratio) {
  const Seen a = see(polygon, centre, pair.a), b = see(polygon, centre, pair.b);
  const SectionEnd begin = section_end(polygon, centre, a, b, pair.begin_a, pair.begin_b);
  const SectionEnd end = section_end(polygon, centre, a, b, pair.end_a, pair.end_b);
  const double least = min_ratio - tau;

  PairVerdict verdict;
  verdict.g0 = begin.g;
  verdict.g1 = end.g;
  verdict.parallel = std::fabs(begin.g - end.g) <= tau * std::max(begin.g, end.g);
  if (verdict.parallel) {
    const Candidate candidate = midpoint_candidate(polygon, centre, a, b, begin, end);
    if (candidate.chord.ratio >= least) verdict.candidate = candidate;
    return verdict;
  }
  verdict.bisected = begin.excess * end.excess <= 0;
  if (verdict.bisected) {
    // At the very end of the section the bisecting chord is the vertex-chord, known more precisely.
    if (begin.excess == 0) {
      verdict.candidate = vertex_candidate(polygon, centre, a, b, begin, CandidateKind::bisecting);
    } else if (end.excess == 0) {
      verdict.candidate = vertex_candidate(polygon, centre, a, b, end, CandidateKind::bisecting);
    } else {
      verdict.candidate = bisecting_candidate(centre, a, b);
    }
    return verdict;
  }
  // g is monotonic and does not pass 1: the end nearer to 1 is the nearer to the bisecting chord.
  const bool begin_is_nearer = load_ratio(1.0, begin.g) > load_ratio(1.0, end.g);
  const SectionEnd& nearer = begin_is_nearer ? begin : end;
  const Candidate candidate =
      vertex_candidate(polygon, centre, a, b, nearer, CandidateKind::vertex);
  if (candidate.chord.ratio >= least) verdict.candidate = candidate;
  return verdict;
}

Result<std::vector<Candidate>> find_candidates(const Polygon& polygon, const Vec2& centre,
                                               double min_ratio) {
  const RadialView view(polygon, centre);
  if (auto error = check_number(count_edge_pairs(polygon, view), "edge-pairs")) return *error;
  std::vector<Candidate> candidates;
  for_each_edge_pair(polygon, view, [&](const EdgePair& pair) {
    PairVerdict verdict = examine_pair(polygon, centre, pair, min_ratio);
    if (verdict.candidate) candidates.push_back(*verdict.candidate);
  });
  sort_by_slope(candidates);
  merge_duplicates(candidates, near_distance(polygon.diagonal()));
  return candidates;
}

}  // namespace evenlift
