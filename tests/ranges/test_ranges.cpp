// Ranges of edge pairs: their ends in exact rationals, and their candidates.
#include <algorithm>
#include <cmath>
#include <string>

#include "candidates/pair_candidate.h"
#include "evenlift/candidates.h"
#include "evenlift/placement.h"
#include "evenlift/random.h"
#include "evenlift/tolerance.h"
#include "kit/catch.h"
#include "kit/corpus.h"
#include "kit/placed.h"
#include "kit/polygons.h"
#include "oracle/rational.h"
#include "oracle/vec.h"
#include "shapes/problem_document.h"
#include "shapes/small_polygons.h"

using namespace evenlift;
using evenlift::testing::placed;
using Exact = oracle::Rational;
using ExactVec = oracle::Vec<Exact>;

namespace {

ExactVec exact(const Vec2& p) { return {Exact(p.x), Exact(p.y)}; }

// Relative to C: where the line through C and p meets an edge's line.
ExactVec on_line(const ExactVec& p, const ExactVec& a, const ExactVec& b) {
  return p * Exact(oracle::cross(a, b) / oracle::cross(p, ExactVec(b - a)));
}

// p| / |q| on one line through the origin.
Exact ratio_of(const ExactVec& p, const ExactVec& q) {
  const Exact value = q.x != 0 ? Exact(p.x / q.x) : Exact(p.y / q.y);
  return value < 0 ? Exact(-value) : value;
}

// Exactly: the ends of an edge pair's section on edge a, and q there.
struct ExactSection {
  ExactVec a[2];
  Exact q[2];
};

ExactSection section(const Polygon& polygon, const Vec2& centre, const EdgePair& pair) {
  const ExactVec c = exact(centre);
  const auto from_centre = [&](const Vec2& v) { return exact(v) - c; };
  const ExactVec a0 = from_centre(polygon.edge_start(pair.a)),
                 a1 = from_centre(polygon.edge_end(pair.a));
  const ExactVec b0 = from_centre(polygon.edge_start(pair.b)),
                 b1 = from_centre(polygon.edge_end(pair.b));
  ExactSection section;
  const std::uint32_t ends[2][2] = {{pair.begin_a, pair.begin_b}, {pair.end_a, pair.end_b}};
  for (int i = 0; i < 2; ++i) {
    const bool on_a = ends[i][0] != inside_edge;
    const ExactVec vertex = from_centre(polygon.vertex(on_a ? ends[i][0] : ends[i][1]));
    section.a[i] = on_a ? vertex : on_line(vertex, a0, a1);
    section.q[i] = ratio_of(section.a[i], on_line(section.a[i], b0, b1));
  }
  return section;
}

double number(const Exact& value) { return static_cast<double>(value); }

struct Prepared {
  Polygon polygon;
  Vec2 centre;
  std::vector<EdgePair> pairs;
};

std::optional<Prepared> prepared(const Document& document) {
  auto polygon = Polygon::create(document.vertices);
  if (!polygon) return std::nullopt;
  const auto centre = check_centre_of_mass(*polygon, document.centre_of_mass);
  if (!centre) return std::nullopt;
  auto pairs = edge_pairs(*polygon, *centre);
  return Prepared{*std::move(polygon), *centre, *std::move(pairs)};
}

// Whether q has the value at x, within rounding.
bool reaches(const ExactSection& section, double x, double q) {
  const Exact at = section.q[0] + (section.q[1] - section.q[0]) * Exact(x);
  return std::fabs(number(at) - q) <=
         1e-11 * std::max({number(section.q[0]), number(section.q[1]), q});
}

void check_range(const PairRange& range, const ExactSection& section, double min_ratio) {
  const double q0 = number(section.q[0]), q1 = number(section.q[1]);
  CHECK(range.q0 == Approx(q0).epsilon(1e-11));
  CHECK(range.q1 == Approx(q1).epsilon(1e-11));
  REQUIRE(range.first >= 0);
  REQUIRE(range.first <= range.last);
  REQUIRE(range.last <= 1);
  for (const double x : {range.first, range.last}) {
    const bool at_end = x == 0 || x == 1;
    CHECK((at_end || reaches(section, x, min_ratio) || reaches(section, x, 1 / min_ratio)));
  }
  // The chord's ratio is too low only beyond a range end that is not an end of the section.
  const auto ratio_at = [&](double x) {
    const double q = number(section.q[0] + (section.q[1] - section.q[0]) * Exact(x));
    return std::min(q, 1 / q);
  };
  const double slack = 1e-9;
  for (const double s : {0.0, 0.25, 0.5, 1.0})
    CHECK(ratio_at(range.first + s * (range.last - range.first)) >= min_ratio - slack);
  const double beyond = 1e-6;
  if (range.first > beyond) CHECK(ratio_at(range.first - beyond) < min_ratio + slack);
  if (range.last < 1 - beyond) CHECK(ratio_at(range.last + beyond) < min_ratio + slack);
}

}  // namespace

TEST_CASE("the range of an edge pair ends where exact rationals say", "[ranges][thorough]") {
  int ranges = 0, none = 0;
  for (std::uint64_t number_of_case = 0; number_of_case < 1500; ++number_of_case) {
    const Document document =
        testing::document_of(small_polygons::make_plain_case(number_of_case).problem);
    const auto object = prepared(document);
    if (!object) continue;
    const double min_ratio = document.settings.min_ratio;
    for (const EdgePair& pair : object->pairs) {
      INFO("case " << number_of_case << ", edges " << pair.a << " and " << pair.b);
      const ExactSection exact_section = section(object->polygon, object->centre, pair);
      const auto range = range_of(object->polygon, object->centre, pair, min_ratio);
      const double q0 = number(exact_section.q[0]), q1 = number(exact_section.q[1]);
      if (range) {
        ++ranges;
        check_range(*range, exact_section, min_ratio);
        continue;
      }
      ++none;
      const double low = std::min(q0, q1), high = std::max(q0, q1);
      CHECK((high < min_ratio + 1e-9 || low * min_ratio > 1 - 1e-9));
    }
  }
  CHECK(ranges > 5000);
  CHECK(none > 1000);
}

TEST_CASE("a chord of a range passes through the centre of mass, as even as its place says",
          "[ranges][slow]") {
  Rng rng(3);
  int chords = 0;
  for (std::uint64_t number_of_case = 0; number_of_case < 600; ++number_of_case) {
    const Document document =
        testing::document_of(small_polygons::make_plain_case(number_of_case).problem);
    const auto object = prepared(document);
    if (!object) continue;
    const double near = 1e-9 * object->polygon.diagonal();
    for (const EdgePair& pair : object->pairs) {
      const auto range =
          range_of(object->polygon, object->centre, pair, document.settings.min_ratio);
      if (!range) continue;
      const double x = range->first + rng.uniform() * (range->last - range->first);
      const Chord chord = chord_at(object->centre, *range, x);
      INFO("case " << number_of_case << ", edges " << pair.a << " and " << pair.b);
      ++chords;
      CHECK(chord.ratio >= document.settings.min_ratio - 2e-9);
      CHECK(chord.ratio ==
            Approx(std::min(chord.arm1, chord.arm2) / std::max(chord.arm1, chord.arm2))
                .epsilon(1e-9));
      const Vec2 r1 = chord.r1.position - object->centre, r2 = chord.r2.position - object->centre;
      CHECK(std::fabs(cross(r1, r2)) <= near * length(r2 - r1));
      CHECK(dot(r1, r2) < 0);
      for (const LiftingPoint& point : {chord.r1, chord.r2}) {
        const Vec2 &p = object->polygon.edge_start(point.edge),
                   &q = object->polygon.edge_end(point.edge);
        CHECK(std::fabs(cross(q - p, point.position - p)) <= near * length(q - p));
      }
      // Which edge is called a does not matter.
      Chord turned = chord;
      std::swap(turned.r1, turned.r2);
      const auto one =
                     range_of(object->polygon, object->centre, chord, document.settings.min_ratio),
                 other =
                     range_of(object->polygon, object->centre, turned, document.settings.min_ratio);
      REQUIRE(one);
      REQUIRE(other);
      for (const double s : range_places) {
        const Chord first = chord_at(object->centre, *one, place_at(*one, s)),
                    second = chord_at(object->centre, *other, place_at(*other, s));
        CHECK(length(first.r1.position - second.r1.position) <= near);
        CHECK(length(first.r2.position - second.r2.position) <= near);
      }
    }
  }
  CHECK(chords > 3000);
}

TEST_CASE("ranges add candidates and leave the others as they are", "[ranges]") {
  std::size_t added = 0, with_teams = 0;
  for (const std::string& name : corpus::polygon_names()) {
    INFO(name);
    Document document = corpus::polygon(name);
    const Placement best = placed(document);
    document.settings.positions = Positions::range;
    const Placement range = placed(document);
    REQUIRE(range.candidates.size() >= best.candidates.size());
    added += range.candidates.size() - best.candidates.size();
    std::size_t next = 0;
    for (const Candidate& candidate : range.candidates) {
      CHECK(candidate.chord.ratio >= document.settings.min_ratio - tau);
      if (candidate.kind == CandidateKind::range) continue;
      REQUIRE(next < best.candidates.size());
      CHECK(candidate.kind == best.candidates[next].kind);
      CHECK(candidate.chord.r1.position == best.candidates[next].chord.r1.position);
      CHECK(candidate.chord.r2.position == best.candidates[next].chord.r2.position);
      ++next;
    }
    CHECK(next == best.candidates.size());
    // The first team takes the longest chord.
    if (range.teams.empty()) continue;
    ++with_teams;
    const Candidate& first = range.candidates[range.team_candidates[0]];
    for (const Candidate& candidate : range.candidates)
      CHECK(candidate.length <= first.length * (1 + 2e-9));
  }
  CHECK(added > 1000);
  CHECK(with_teams > 90);
}

TEST_CASE("a square's parallel sides offer a sixteenth from either end", "[ranges]") {
  Document document;
  document.vertices = {{0, 0}, {16, 0}, {16, 16}, {0, 16}};
  document.settings.positions = Positions::range;
  const Placement placement = placed(document);
  std::vector<Vec2> ends;
  for (const Candidate& candidate : placement.candidates)
    if (candidate.kind == CandidateKind::range) {
      CHECK(candidate.chord.ratio == Approx(1).epsilon(1e-12));
      ends.push_back(candidate.chord.r1.position);
    }
  REQUIRE(ends.size() == 4);
  for (const Vec2& end : {Vec2(0, 1), Vec2(0, 15), Vec2(1, 16), Vec2(1, 0)})
    CHECK(std::any_of(ends.begin(), ends.end(),
                      [&](const Vec2& e) { return length(e - end) < 1e-9; }));
}

TEST_CASE("a range is one place only if its chords agree on both edges", "[ranges]") {
  PairRange range;
  range.a0 = {1, 0};
  range.a1 = {1, 1e-10};
  CHECK(is_one_place(range, 1e-9));
  // The other ends are a hundred times as far from C, and from each other.
  range.q0 = range.q1 = 0.01;
  CHECK_FALSE(is_one_place(range, 1e-9));
  // And the other way round.
  range.a1 = {1, 1e-8};
  range.q0 = range.q1 = 100;
  CHECK_FALSE(is_one_place(range, 1e-9));
}

TEST_CASE("the clear part of a range keeps off the corners of both its edges", "[ranges]") {
  for (const double top : {1.0, 1.2}) {
    const double bottom = 2.2 - top;  // once the corners of one edge are nearer, once the other's
    const Polygon polygon = testing::polygon({{-bottom, -1}, {bottom, -1}, {top, 1}, {-top, 1}});
    const Corners corners(polygon);
    PairRange range;
    range.a = 2;
    range.b = 0;
    range.a0 = {-1, 1};
    range.a1 = {1, 1};
    const auto part = clear_part({polygon, corners, 0.5, nullptr}, {0, 0}, range);
    REQUIRE(part);
    CHECK(chord_at({0, 0}, *part, part->first).r1.position.x == Approx(-0.5));
    CHECK(chord_at({0, 0}, *part, part->last).r2.position.x == Approx(0.5));
  }
}

TEST_CASE("the place towards a direction is where C sees it, or the nearest end of the range",
          "[ranges]") {
  PairRange range;
  range.a0 = Vec2(1, -1);
  range.a1 = Vec2(1, 1);
  CHECK(place_towards(range, Vec2(1, 0.5)) == Approx(0.75));
  CHECK(place_towards(range, Vec2(1, -3)) == 0);
  // Behind C: 100 degrees from one end, 55 from the other.
  CHECK(place_towards(range, Vec2(-1, 0.1)) == 1);
  CHECK(place_towards(range, Vec2(-1, -0.1)) == 0);
  CHECK(place_towards(range, Vec2(-0.17, 0.98)) == 1);
}
