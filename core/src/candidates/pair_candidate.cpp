#include "candidates/pair_candidate.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "chords/radial_view.h"
#include "evenlift/predicates.h"
#include "evenlift/tolerance.h"
#include "exact/pseudo_angle.h"

namespace evenlift {
namespace {

// The ends of an edge, counter-clockwise as C sees them.
struct SeenEnds {
  std::uint32_t first, last;
};

// The open range of directions in which C sees edge `a` ahead and edge `b` behind, if any. C sees
// `a` and the mirror image of `b` at less than 180 degrees, so the signs of the turns between their
// ends decide everything.
std::optional<EdgePair> common_range(const Polygon& polygon, const Vec2& centre, std::uint32_t a,
                                     SeenEnds of_a, std::uint32_t b, SeenEnds of_b) {
  const Vec2 &p = polygon.vertex(of_a.first), &q = polygon.vertex(of_a.last);
  const Vec2 &r = polygon.vertex(of_b.first), &s = polygon.vertex(of_b.last);
  // Positive if the first point comes before the second; r and s are mirrored in C.
  const double p_r = -orient(centre, p, r), p_s = -orient(centre, p, s),
               r_q = -orient(centre, r, q), q_s = -orient(centre, q, s);
  const bool begins_at_p = p_r <= 0 && p_s > 0, begins_at_r = p_r >= 0 && r_q > 0;
  if (!begins_at_p && !begins_at_r) return std::nullopt;
  EdgePair pair;
  pair.a = a;
  pair.b = b;
  if (begins_at_p) pair.begin_a = of_a.first;
  if (begins_at_r) pair.begin_b = of_b.first;
  if (q_s >= 0) pair.end_a = of_a.last;
  if (q_s <= 0) pair.end_b = of_b.last;
  return pair;
}

// The edge as C sees it, unless it is radial.
std::optional<SeenEnds> ends_of(const Polygon& polygon, const Vec2& centre, std::uint32_t edge,
                                double near) {
  const Vec2 &p = polygon.edge_start(edge), &q = polygon.edge_end(edge);
  const double side = orient(centre, p, q);
  if (std::fabs(side) <= near * length(q - p)) return std::nullopt;
  const auto next = static_cast<std::uint32_t>(polygon.next(edge));
  return side > 0 ? SeenEnds{edge, next} : SeenEnds{next, edge};
}

}  // namespace

std::optional<EdgePair> pair_of_edges(const Polygon& polygon, const Vec2& centre, std::uint32_t a,
                                      std::uint32_t b, double near) {
  const auto of_a = ends_of(polygon, centre, a, near), of_b = ends_of(polygon, centre, b, near);
  if (!of_a || !of_b) return std::nullopt;
  return common_range(polygon, centre, a, *of_a, b, *of_b);
}

namespace {

// A corner of an edge of the range, and the direction away from it.
struct EdgeCorner {
  std::uint32_t edge;
  bool on_a;
  Vec2 at, away;
};

Vec2 end_of(const Vec2& centre, const PairRange& range, double x, bool on_a) {
  const Vec2 offset = (1 - x) * range.a0 + x * range.a1;
  return on_a ? Vec2(centre + offset) : Vec2(centre - offset / range.q(x));
}

class Part {
 public:
  Part(const FromCorners& from, const Vec2& centre, const PairRange& range)
      : from_(from), centre_(centre), range_(range), part_(range) {}

  std::optional<PairRange> find() {
    const Polygon& polygon = from_.polygon;
    for (const bool on_a : {true, false}) {
      const std::uint32_t edge = on_a ? range_.a : range_.b;
      const Vec2 along = polygon.edge_end(edge) - polygon.edge_start(edge);
      const Vec2 unit = along / length(along);
      if (const auto corner = from_.corners.before(edge))
        keep_off({edge, on_a, polygon.vertex(*corner), unit});
      if (const auto corner = from_.corners.after(edge))
        keep_off({edge, on_a, polygon.vertex(*corner), -unit});
    }
    if (part_.first > part_.last || !clear_) return std::nullopt;
    return evenlift::is_one_place(part_, near_distance(polygon.diameter())) ? std::nullopt
                                                                            : std::optional(part_);
  }

 private:
  // Narrows the part to places far enough from a corner.
  void keep_off(const EdgeCorner& corner) {
    const Vec2 at = lifting_point(corner.at, corner.edge);
    const auto is_clear = [&](double x) {
      const double distance = dot(end_of(centre_, range_, x, corner.on_a) - at, corner.away);
      return distance >= from_.clear - near_distance(from_.polygon.diameter());
    };
    const bool first = is_clear(range_.first), last = is_clear(range_.last);
    if (!first && !last) clear_ = false;
    if (first == last) return;
    const Vec2 nearest = at + from_.clear * corner.away;
    const Vec2 direction = corner.on_a ? Vec2(nearest - centre_) : Vec2(centre_ - nearest);
    const double x = place_towards(range_, direction);
    if (last)
      part_.first = std::max(part_.first, x);
    else
      part_.last = std::min(part_.last, x);
  }

  Vec2 lifting_point(const Vec2& contact, std::uint32_t edge) const {
    return from_.stands ? from_.stands->lifting_point({contact, edge}).position : contact;
  }

  const FromCorners& from_;
  Vec2 centre_;
  const PairRange& range_;
  PairRange part_;
  bool clear_ = true;
};

}  // namespace

std::optional<PairRange> clear_part(const FromCorners& from, const Vec2& centre,
                                    const PairRange& range) {
  return from.clear > 0 ? Part(from, centre, range).find() : std::nullopt;
}

double clear_place_at(const PairRange& range, const std::optional<PairRange>& clear, double s) {
  const double x = place_at(range, s);
  return clear ? std::clamp(x, clear->first, clear->last) : x;
}

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

namespace {

// An even vertex-chord counts as bisecting: rounding decides whether its arms are equal to the last
// bit.
CandidateKind kind_of_vertex_chord(const Chord& chord) {
  return is_even(chord) ? CandidateKind::bisecting : CandidateKind::vertex;
}

Candidate make_candidate(const Chord& chord, CandidateKind kind, const Vec2& direction) {
  return {chord, kind, false, 0, rightward(direction), chord.arm1 + chord.arm2};
}

// Edges that count as parallel are rarely parallel to the last bit, so the middles of their
// sections do not quite face each other. The chord where g is the geometric mean of its values at
// the ends lies between the two middles, whichever edge is `a`.
Candidate midpoint_candidate(const Polygon& polygon, const Vec2& centre, const SeenEdge& a,
                             const SeenEdge& b, const SectionEnd& begin, const SectionEnd& end) {
  const double root0 = std::sqrt(begin.g), root1 = std::sqrt(end.g), sum = root0 + root1;
  const Vec2 offset = (root0 / sum) * offset_on_a(polygon, centre, begin) +
                      (root1 / sum) * offset_on_a(polygon, centre, end);
  const double g = std::sqrt(begin.g * end.g);
  const double arm = length(offset);
  Chord chord =
      order_ends({centre + offset, a.edge}, arm, {centre - g * offset, b.edge}, g * arm, offset);
  chord.ratio = load_ratio(1.0, g);
  return make_candidate(chord, CandidateKind::midpoint, offset);
}

bool joins_opposite_vertices(const SectionEnd& end) { return end.opposite != inside_edge; }

Candidate end_candidate(const Polygon& polygon, const Vec2& centre, const SeenEdge& a,
                        const SeenEdge& b, const SectionEnd& end) {
  const Chord chord = chord_from_vertex(polygon, centre, end.vertex, end.on_a ? a.edge : b.edge,
                                        end.across, end.on_a ? b.edge : a.edge, end.opposite);
  const bool between_vertices = joins_opposite_vertices(end);
  const Vec2& target = between_vertices ? polygon.vertex(end.opposite) : centre;
  Candidate candidate =
      make_candidate(chord, kind_of_vertex_chord(chord), target - polygon.vertex(end.vertex));
  candidate.between_vertices = between_vertices;
  return candidate;
}

// An estimate of g at a section end, with a relative error below 2^-32.
std::optional<double> estimate_g(const Polygon& polygon, const Vec2& centre, const SeenEdge& a,
                                 const SeenEdge& b, std::uint32_t vertex_a,
                                 std::uint32_t vertex_b) {
  if (vertex_a != inside_edge)
    return estimate_across(centre, polygon.vertex(vertex_a), b.first, b.last, b.doubled_area);
  const auto factor =
      estimate_across(centre, polygon.vertex(vertex_b), a.first, a.last, a.doubled_area);
  if (factor) return 1.0 / *factor;
  return std::nullopt;
}

// The vertex of the edge `other` that is opposite to the end's vertex and within sqrt(tau) L of the
// point where the chord meets the edge, or inside_edge. That distance is too small to see, but
// rounding moves the point far less, even where C sees the edge at a grazing angle.
std::uint32_t missed_vertex(const Polygon& polygon, const Vec2& centre, const SectionEnd& end,
                            std::uint32_t other) {
  const double diameter = polygon.diameter(), near = near_distance(diameter);
  const Vec2 w = polygon.vertex(end.vertex) - centre, hit = -end.across.factor * w;
  std::uint32_t missed = inside_edge;
  double least = std::sqrt(tau) * diameter;
  for (const std::size_t index : {std::size_t{other}, polygon.next(other)}) {
    const Vec2 v = polygon.vertex(index) - centre;
    const double gap = length(v - hit);
    if (gap > least || !are_opposite(v, w, near)) continue;
    least = gap;
    missed = static_cast<std::uint32_t>(index);
  }
  return missed;
}

// The section end that decisions use. A chord that joins opposite vertices, or misses the second by
// rounding, counts as the chord between the two and, if that is even, as bisected by C. `g` keeps
// the section's value.
SectionEnd settled(const Polygon& polygon, const Vec2& centre, const SeenEdge& a, const SeenEdge& b,
                   SectionEnd end) {
  if (!joins_opposite_vertices(end))
    end.opposite = missed_vertex(polygon, centre, end, end.on_a ? b.edge : a.edge);
  if (!joins_opposite_vertices(end)) return end;
  const double arm = length(polygon.vertex(end.vertex) - centre),
               other_arm = length(polygon.vertex(end.opposite) - centre);
  const int longer = (other_arm > arm) - (other_arm < arm);
  end.across = {other_arm / arm, longer};
  if (load_ratio(arm, other_arm) >= 1.0 - tau) end.compare_to_one = 0;
  return end;
}

// Whether both ends are the chord between the same opposite vertices. Such an edge pair exists only
// by rounding.
bool are_one_chord(const SectionEnd& begin, const SectionEnd& end) {
  return joins_opposite_vertices(begin) && joins_opposite_vertices(end) &&
         std::minmax(begin.vertex, begin.opposite) == std::minmax(end.vertex, end.opposite);
}

}  // namespace

SectionEnd section_end(const Polygon& polygon, const Vec2& centre, const SeenEdge& a,
                       const SeenEdge& b, std::uint32_t vertex_a, std::uint32_t vertex_b) {
  const bool on_a = vertex_a != inside_edge;
  const std::uint32_t vertex = on_a ? vertex_a : vertex_b;
  const SeenEdge& other = on_a ? b : a;
  const Across across =
      look_across(centre, polygon.vertex(vertex), other.first, other.last, other.doubled_area);
  return {vertex,
          on_a ? vertex_b : inside_edge,
          on_a,
          across,
          on_a ? across.factor : 1.0 / across.factor,
          on_a ? across.compare_to_one : -across.compare_to_one};
}

Vec2 offset_on_a(const Polygon& polygon, const Vec2& centre, const SectionEnd& end) {
  const Vec2 offset = polygon.vertex(end.vertex) - centre;
  return end.on_a ? offset : Vec2(-end.across.factor * offset);
}

SeenEdge see(const Polygon& polygon, const Vec2& centre, std::uint32_t edge) {
  const Vec2 &p = polygon.edge_start(edge), &q = polygon.edge_end(edge);
  const double doubled_area = orient(centre, p, q);
  if (doubled_area > 0) return {edge, p, q, doubled_area};
  return {edge, q, p, -doubled_area};
}

Vec2 rightward(const Vec2& direction) {
  return points_right(direction) ? direction : Vec2(-direction);
}

// r_a is where the line of `a` meets the line of `b` reflected through C (equation 3.6 without
// trigonometry). If d are the edges' vectors and h twice the areas that they span with C, r_a - C
// is -(h_b d_a + h_a d_b) / (d_a x d_b). For nearly parallel edges the sum cancels, so it is
// computed in double-double.
Vec2 bisecting_offset(const Vec2& centre, const SeenEdge& a, const SeenEdge& b) {
  const Vec2 da = a.last - a.first, db = b.last - b.first;
  const double ha = a.doubled_area, hb = b.doubled_area;
  const Vec2 sum = hb * da + ha * db;
  const double size = hb * length(da) + ha * length(db);
  constexpr double filter_threshold = 0x1p-5;
  if (length(sum) > filter_threshold * size) {
    return -sum / cross_of_differences(a.first, a.last, b.first, b.last);
  }

  const auto difference = [](const Vec2& p, const Vec2& q) {
    return std::pair(two_difference(q.x, p.x), two_difference(q.y, p.y));
  };
  const auto fine_cross = [](const auto& u, const auto& v) {
    return u.first * v.second - u.second * v.first;
  };
  const auto fine_da = difference(a.first, a.last), fine_db = difference(b.first, b.last);
  const auto fine_ha = fine_cross(difference(centre, a.first), difference(centre, a.last));
  const auto fine_hb = fine_cross(difference(centre, b.first), difference(centre, b.last));
  const DoubleDouble divisor = fine_cross(fine_da, fine_db);
  const DoubleDouble x = (fine_hb * fine_da.first + fine_ha * fine_db.first) / divisor;
  const DoubleDouble y = (fine_hb * fine_da.second + fine_ha * fine_db.second) / divisor;
  return {-x.to_double(), -y.to_double()};
}

Candidate bisecting_candidate(const Vec2& centre, std::uint32_t edge_a, std::uint32_t edge_b,
                              const Vec2& offset) {
  const double arm = length(offset);
  const Chord chord =
      order_ends({centre + offset, edge_a}, arm, {centre - offset, edge_b}, arm, offset);
  return make_candidate(chord, CandidateKind::bisecting, offset);
}

Candidate vertex_candidate(const Polygon& polygon, const Vec2& centre, std::uint32_t vertex,
                           std::uint32_t edge, const SeenEdge& other, std::uint32_t opposite) {
  const Across across =
      look_across(centre, polygon.vertex(vertex), other.first, other.last, other.doubled_area);
  const Chord chord =
      chord_from_vertex(polygon, centre, vertex, edge, across, other.edge, opposite);
  Candidate candidate =
      make_candidate(chord, kind_of_vertex_chord(chord), centre - polygon.vertex(vertex));
  candidate.between_vertices = opposite != inside_edge;
  return candidate;
}

Candidate opposite_chord(const Polygon& polygon, const Vec2& centre,
                         const OppositeVertices& opposite) {
  const Vec2 &v = polygon.vertex(opposite.v), &w = polygon.vertex(opposite.w);
  const Vec2 direction = w - v;
  const Chord chord = order_ends({w, opposite.w}, length(w - centre), {v, opposite.v},
                                 length(v - centre), direction);
  Candidate candidate = make_candidate(chord, kind_of_vertex_chord(chord), direction);
  candidate.between_vertices = true;
  return candidate;
}

bool reaches(const Chord& chord, double min_ratio) { return chord.ratio >= min_ratio - tau; }

SectionRim section_rim(const Polygon& polygon, const Vec2& centre, const SeenEdge& a,
                       const SeenEdge& b, std::uint32_t vertex_a, std::uint32_t vertex_b) {
  const SectionEnd end = section_end(polygon, centre, a, b, vertex_a, vertex_b);
  const Chord chord = end_candidate(polygon, centre, a, b, end).chord;
  // The chord's ends are in the order of the slope, not of `a` and `b`.
  const bool vertex_is_right = !points_right(centre - polygon.vertex(end.vertex));
  const bool a_is_right = vertex_is_right == end.on_a;
  return {chord, a_is_right ? chord.r2.position : chord.r1.position,
          a_is_right ? chord.r1.position : chord.r2.position};
}

PairVerdict examine(const Polygon& polygon, const Vec2& centre, const SeenEdge& a,
                    const SeenEdge& b, const EdgePair& pair, double min_ratio) {
  const SectionEnd begin_as_seen = section_end(polygon, centre, a, b, pair.begin_a, pair.begin_b);
  const SectionEnd end_as_seen = section_end(polygon, centre, a, b, pair.end_a, pair.end_b);
  const SectionEnd begin = settled(polygon, centre, a, b, begin_as_seen);
  const SectionEnd end = settled(polygon, centre, a, b, end_as_seen);

  PairVerdict verdict;
  verdict.g0 = begin.g;
  verdict.g1 = end.g;
  verdict.parallel = are_parallel(begin.g, end.g);
  if (verdict.parallel) {
    const Candidate candidate =
        are_one_chord(begin, end)
            ? end_candidate(polygon, centre, a, b, begin)
            : midpoint_candidate(polygon, centre, a, b, begin_as_seen, end_as_seen);
    if (reaches(candidate.chord, min_ratio)) verdict.candidate = candidate;
    return verdict;
  }
  verdict.bisected = begin.compare_to_one * end.compare_to_one <= 0;
  if (verdict.bisected) {
    // At a section's end, the vertex-chord is more precise.
    if (begin.compare_to_one == 0) {
      verdict.candidate = end_candidate(polygon, centre, a, b, begin);
    } else if (end.compare_to_one == 0) {
      verdict.candidate = end_candidate(polygon, centre, a, b, end);
    } else {
      verdict.candidate =
          bisecting_candidate(centre, a.edge, b.edge, bisecting_offset(centre, a, b));
    }
    return verdict;
  }
  // g is monotonic and does not pass 1, so the best chord is at the end where g is nearer to 1.
  const bool begin_is_nearer = load_ratio(1.0, begin.g) > load_ratio(1.0, end.g);
  const SectionEnd& nearer = begin_is_nearer ? begin : end;
  const Candidate candidate = end_candidate(polygon, centre, a, b, nearer);
  if (reaches(candidate.chord, min_ratio)) verdict.candidate = candidate;
  return verdict;
}

// Makes the tests of examine() in order. Returns `unsure` where errors of the estimates could
// change the verdict.
QuickVerdict examine_quickly(const Polygon& polygon, const Vec2& centre, const SeenEdge& a,
                             const SeenEdge& b, const EdgePair& pair, double min_ratio) {
  const auto g0 = estimate_g(polygon, centre, a, b, pair.begin_a, pair.begin_b);
  const auto g1 = estimate_g(polygon, centre, a, b, pair.end_a, pair.end_b);
  if (!g0 || !g1) return QuickVerdict::unsure;
  constexpr double error_bound = 0x1p-30;
  const double e0 = *g0 - 1, e1 = *g1 - 1;
  if (std::fabs(*g0 - *g1) <= (tau + error_bound) * std::max(*g0, *g1))
    return QuickVerdict::unsure;  // perhaps parallel
  if (std::fabs(e0) <= error_bound || std::fabs(e1) <= error_bound) return QuickVerdict::unsure;
  if ((e0 < 0) != (e1 < 0)) return QuickVerdict::bisecting;
  const double ratio0 = load_ratio(1.0, *g0), ratio1 = load_ratio(1.0, *g1);
  const double larger = std::max(ratio0, ratio1), least = min_ratio - tau;
  if (larger < least - error_bound) return QuickVerdict::none;
  if (larger < least + error_bound) return QuickVerdict::unsure;
  return ratio0 > ratio1 ? QuickVerdict::at_begin : QuickVerdict::at_end;
}

}  // namespace evenlift
