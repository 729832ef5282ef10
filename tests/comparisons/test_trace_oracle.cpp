// The steps' claims, in exact arithmetic and against the oracle.
#include <algorithm>
#include <cmath>

#include "evenlift/placement.h"
#include "evenlift/trace.h"
#include "kit/catch.h"
#include "oracle/oracle.h"
#include "oracle/rational.h"
#include "oracle/vec.h"
#include "shapes/problem_document.h"
#include "shapes/small_polygons.h"

using namespace evenlift;

namespace {

using Exact = oracle::Rational;
using ExactVec = oracle::Vec<Exact>;
using small_polygons::Case;

oracle::Point point(const Vec2& v) { return {v.x, v.y}; }
ExactVec exact(const Vec2& v) { return {v.x, v.y}; }
double rounded(const Exact& v) { return static_cast<double>(v); }

std::optional<Trace> trace_of(const Case& c) {
  const Result<Placement> placement = place(evenlift::testing::document_of(c.problem));
  REQUIRE(placement.ok());
  const Result<Trace> trace = make_trace(*placement);
  if (!trace) return std::nullopt;  // too small to be shown
  return *trace;
}

// Whether coordinates are far from the origin: then positions lose digits, but not decisions.
bool far_away(const Trace& trace) {
  double largest = 0;
  for (const Vec2& v : trace.polygon().vertices()) largest = std::max(largest, max_norm(v));
  return largest > 1e4 * trace.polygon().diagonal();
}

// Where the ray from vertex w through C meets an edge's line, as a multiple of |C w|.
Exact across(const Trace& trace, std::uint32_t w, std::uint32_t edge) {
  const ExactVec c = exact(trace.centre), u = c - exact(trace.polygon().vertex(w));
  const ExactVec p = exact(trace.polygon().edge_start(edge)) - c,
                 q = exact(trace.polygon().edge_end(edge)) - c;
  return oracle::cross(p, q) / oracle::cross(u, q - p);
}

// C r_b| / |C r_a| at an end of the pair's range, from the vertices there.
Exact exact_g(const Trace& trace, const EdgePair& pair, std::uint32_t on_a, std::uint32_t on_b) {
  if (on_a != inside_edge) return across(trace, on_a, pair.b);
  return 1 / across(trace, on_b, pair.a);
}

bool joins_vertices(const Trace& trace, const Chord& chord) {
  const Points& v = trace.polygon().vertices();
  const auto is_vertex = [&](const LiftingPoint& p) {
    return std::find(v.begin(), v.end(), p.position) != v.end();
  };
  return is_vertex(chord.r1) && is_vertex(chord.r2);
}

// The ratio of the arms.
double ratio_of_ends(const Trace& trace, const Chord& chord) {
  const auto squared_arm = [&](const LiftingPoint& p) {
    const ExactVec u = exact(p.position) - exact(trace.centre);
    return oracle::dot(u, u);
  };
  const Exact square1 = squared_arm(chord.r1), square2 = squared_arm(chord.r2);
  return std::sqrt(rounded(square1 < square2 ? square1 / square2 : square2 / square1));
}

void check_pair(const Trace& trace, std::uint32_t index, int& certain) {
  const PairDetail detail = look_at_pair(trace, index);
  const EdgePair& pair = detail.pair;
  const Exact g0 = exact_g(trace, pair, pair.begin_a, pair.begin_b);
  const Exact g1 = exact_g(trace, pair, pair.end_a, pair.end_b);
  REQUIRE(g0 > 0);
  REQUIRE(g1 > 0);
  CHECK(std::fabs(detail.verdict.g0 / rounded(g0) - 1) < 1e-12);
  CHECK(std::fabs(detail.verdict.g1 / rounded(g1) - 1) < 1e-12);
  const Exact r0 = g0 < 1 ? g0 : 1 / g0, r1 = g1 < 1 ? g1 : 1 / g1;
  CHECK(std::fabs(detail.ends[0].ratio - rounded(r0)) < 1e-12);
  CHECK(std::fabs(detail.ends[1].ratio - rounded(r1)) < 1e-12);

  const double least = trace.placement.settings.min_ratio;
  const double gap = std::fabs(rounded(g0 - g1)) / std::max(rounded(g0), rounded(g1));
  if (gap > 0.99e-9 && gap < 1.01e-9) return;
  const double best = rounded(std::max(r0, r1));
  const bool hard = std::fabs(best - (least - 1e-9)) < 1e-12;
  if (hard) return;
  ++certain;
  if (gap <= 1e-9) {
    CHECK((detail.outcome == Outcome::midpoint) == (best >= least - 1e-9));
    CHECK((detail.outcome == Outcome::midpoint || detail.outcome == Outcome::parallel_low));
    return;
  }
  REQUIRE(detail.meeting);
  // The bisecting chord is in the sections exactly if 1 is between g0 and g1. Otherwise only an
  // even chord between vertices, at a section end, counts as one.
  const bool in_sections = (g0 - 1) * (g1 - 1) <= 0;
  if (detail.outcome == Outcome::bisecting) {
    const double ratio = detail.chosen.ratio;
    CHECK((joins_vertices(trace, detail.chosen) ? ratio >= 1 - 1e-9 : in_sections && ratio == 1));
    return;
  }
  CHECK(!in_sections);
  CHECK((detail.outcome == Outcome::nearer_end) == (best >= least - 1e-9));
  CHECK(detail.nearer == (r0 > r1 ? 0 : 1));
  const bool between = joins_vertices(trace, detail.chosen);
  CHECK(std::fabs(detail.chosen.ratio - (between ? ratio_of_ends(trace, detail.chosen) : best)) <
        1e-12);
}

// From only the preceding teams and the candidate: a team that won against all wins against fewer.
double oracle_score(const Case& c, const Trace& trace, std::uint32_t team, std::uint32_t candidate,
                    bool& in_order) {
  std::vector<std::uint32_t> chosen;
  for (std::uint32_t i = 0; i < team; ++i) chosen.push_back(trace.placement.team_candidates[i]);
  chosen.push_back(candidate);
  std::vector<oracle::Candidate> chords;
  for (const std::uint32_t i : chosen) {
    const Candidate& mine = trace.placement.candidates[i];
    chords.push_back({.ends = {point(mine.chord.r1.position), point(mine.chord.r2.position)},
                      .ratio = mine.chord.ratio,
                      .kind = static_cast<oracle::Kind>(mine.kind)});
  }
  oracle::Problem problem = c.problem;
  problem.teams = static_cast<int>(chosen.size());
  const oracle::Selection selection =
      oracle::select(problem, oracle::given_candidates(problem, chords));
  in_order = selection.teams.size() == chosen.size();
  for (std::size_t i = 0; in_order && i < chosen.size(); ++i) in_order = selection.teams[i] == i;
  return in_order ? selection.scores.back() : 0;
}

}  // namespace

TEST_CASE("each edge pair's step says what exact arithmetic says", "[trace][oracle][thorough]") {
  int certain = 0;
  for (std::uint64_t i = 0; i < 270; ++i) {
    const Case c = small_polygons::make_case(i);
    const auto trace = trace_of(c);
    if (!trace) continue;
    INFO(c.name << ' ' << i);
    const oracle::CandidateList list = oracle::find_candidates(c.problem);
    // Where C is within tolerance of an edge's line, the oracle counts pairs as the core does.
    if (list.closest_call.distance > 1e-3) CHECK(trace->pairs.size() == list.pairs);
    for (std::uint32_t pair = 0; pair < trace->pairs.size(); ++pair)
      check_pair(*trace, pair, certain);
  }
  CHECK(certain > 3000);
}

TEST_CASE("the rays' steps hold the oracle's vertex-chords", "[trace][oracle][slow]") {
  std::size_t compared = 0;
  for (std::uint64_t i = 0; i < 270; ++i) {
    const Case c = small_polygons::make_case(i);
    const auto trace = trace_of(c);
    if (!trace) continue;
    INFO(c.name << ' ' << i);
    std::size_t own = 0;
    for (std::uint32_t ray = 0; ray < trace->rays.vertices.size(); ++ray) {
      const std::uint32_t vertex = trace->rays.vertices[ray];
      for (std::uint32_t k = trace->rays.begins[ray]; k < trace->rays.begins[ray + 1]; ++k) {
        const VertexChord& chord = trace->rays.chords[k];
        REQUIRE((chord.vertex == vertex || chord.hit_vertex == vertex));
        own += chord.vertex == vertex;
      }
    }
    CHECK(own == oracle::vertex_chords(c.problem).size());
    CHECK(chords_by_slope(*trace).size() == own);
    compared += own;
  }
  CHECK(compared > 2000);
}

TEST_CASE("chords in order of slope rise", "[trace][oracle][slow]") {
  int compared = 0;
  for (std::uint64_t i = 0; i < 270; ++i) {
    const Case c = small_polygons::make_case(i);
    const auto trace = trace_of(c);
    if (!trace) continue;
    INFO(c.name << ' ' << i);
    std::optional<ExactVec> before;
    for (const std::uint32_t k : chords_by_slope(*trace)) {
      const VertexChord& chord = trace->rays.chords[k];
      ExactVec u = exact(trace->centre) - exact(trace->polygon().vertex(chord.vertex));
      if (u.x < 0) u = -u;
      // A direction within tolerance of the vertical is vertical, and last.
      if (abs(u.x) * 500000000 < abs(u.y)) break;
      if (before) CHECK(oracle::sign(oracle::cross(*before, u)) >= 0);
      compared += before.has_value();
      before = u;
    }
  }
  CHECK(compared > 1000);
}

TEST_CASE("every candidate's score at every team is the oracle's", "[trace][oracle][thorough]") {
  int compared = 0;
  for (std::uint64_t i = 0; i < 240; ++i) {
    Case c = small_polygons::make_case(i);
    c.problem.teams = 3;
    c.problem.metric = static_cast<oracle::Metric>(i / 9 % 3);
    const auto trace = trace_of(c);
    if (!trace || trace->placement.candidates.size() > 14 || far_away(*trace)) continue;
    INFO(c.name << ' ' << i);
    const double size = trace->polygon().diagonal();
    const double unit = c.problem.metric == oracle::Metric::distance ? size : size * size;
    for (std::uint32_t team = 1; team < trace->placement.teams.size(); ++team) {
      const TeamScores scores = look_at_scores(*trace, team);
      for (const std::uint32_t candidate : scores.ranking) {
        REQUIRE(scores.of_candidate[candidate].exact);
        bool in_order = false;
        const double exact_score = oracle_score(c, *trace, team, candidate, in_order);
        if (!in_order) continue;
        ++compared;
        INFO("team " << team << ", candidate " << candidate);
        CHECK(std::fabs(scores.of_candidate[candidate].value - exact_score) <= 1e-10 * unit);
      }
    }
  }
  CHECK(compared > 1000);
}

TEST_CASE("after the contacts of so many robots the regions are the oracle's",
          "[trace][oracle][thorough]") {
  int compared = 0;
  for (std::uint64_t i = 0; i < 120; ++i) {
    Case c = small_polygons::make_case(i);
    c.problem.teams = 3;
    const auto trace = trace_of(c);
    if (!trace || far_away(*trace)) continue;
    INFO(c.name << ' ' << i);
    std::vector<oracle::Point> points;
    for (std::uint32_t robot = 0; robot < 2 * trace->placement.teams.size(); ++robot) {
      const Chord chord = chord_of(trace->placement.teams[robot / 2]);
      const Vec2& p = robot % 2 == 0 ? chord.r1.position : chord.r2.position;
      points.push_back(point(p));
      const oracle::Closure closure = oracle::immobilization(c.problem, points);
      if (closure.closest_call.distance < 1e-3) continue;
      std::uint32_t contacts = 0;
      while (contacts < trace->contacts.size() && trace->contacts[contacts].point <= robot)
        ++contacts;
      CHECK(contacts == closure.contacts);
      if (contacts == 0) continue;
      const auto k = trace->find(StepKind::cut, contacts - 1);
      REQUIRE(k);
      const StepDetail detail = look_at(*trace, *k);
      CHECK(detail.clockwise.exists == closure.clockwise);
      CHECK(detail.counterclockwise.exists == closure.counterclockwise);
      ++compared;
    }
  }
  CHECK(compared > 300);
}
