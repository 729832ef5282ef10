// Candidates, their merging and order, in cases solved by hand.
#include "evenlift/candidates.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "candidates/candidate_order.h"
#include "evenlift/tolerance.h"
#include "kit/catch.h"
#include "shapes/problem_document.h"
#include "shapes/small_polygons.h"

using namespace evenlift;

namespace {

std::vector<Candidate> candidates(Points vertices, const std::optional<Vec2>& given,
                                  double min_ratio) {
  const auto polygon = Polygon::create(std::move(vertices));
  REQUIRE(polygon.ok());
  const auto centre = check_centre_of_mass(*polygon, given);
  REQUIRE(centre.ok());
  auto found = find_candidates(*polygon, *centre, min_ratio);
  REQUIRE(found.ok());
  return *std::move(found);
}

void is(const Candidate& c, const Vec2& r1, const Vec2& r2, CandidateKind kind, double ratio) {
  CHECK(length(c.chord.r1.position - r1) <= 1e-14);
  CHECK(length(c.chord.r2.position - r2) <= 1e-14);
  CHECK(c.kind == kind);
  CHECK(c.chord.ratio == Approx(ratio).epsilon(1e-15));
}

constexpr auto bisecting = CandidateKind::bisecting, midpoint = CandidateKind::midpoint,
               vertex = CandidateKind::vertex;

}  // namespace

TEST_CASE("a square's candidates are its diagonals and the midpoint chords, the vertical one last",
          "[candidates]") {
  const auto found = candidates({{0, 0}, {2, 0}, {2, 2}, {0, 2}}, {}, 0.8);
  REQUIRE(found.size() == 4);
  is(found[0], {0, 2}, {2, 0}, bisecting, 1);
  is(found[1], {0, 1}, {2, 1}, midpoint, 1);
  is(found[2], {0, 0}, {2, 2}, bisecting, 1);
  is(found[3], {1, 0}, {1, 2}, midpoint, 1);
}

TEST_CASE("the chord between two opposite vertices is a candidate if it is even enough",
          "[candidates]") {
  // C is on the kite's long diagonal, nearer to one end.
  const Points kite{{0, -4}, {1, 0}, {0, 3}, {-1, 0}};
  const auto found = candidates(kite, Vec2(0, 0), 0.75);
  REQUIRE(found.size() >= 2);
  is(found.back(), {0, -4}, {0, 3}, vertex, 0.75);
  CHECK(found.back().between_vertices);
  const auto even = candidates(kite, Vec2(0, 0), 0.76);
  CHECK(std::none_of(even.begin(), even.end(),
                     [](const Candidate& c) { return is_vertical(c.direction); }));
  const auto has_level = [](const Candidate& c) {
    return c.between_vertices && c.direction.y == 0 && c.kind == bisecting;
  };
  CHECK(std::any_of(even.begin(), even.end(), has_level));
}

TEST_CASE("vertices within tolerance of a line through C are opposite, beyond it they are not",
          "[candidates]") {
  for (const double off : {0.0, 1e-10, 1e-7}) {
    const auto polygon = Polygon::create({{0, -4}, {1, 0}, {off, 3}, {-1, 0}});
    REQUIRE(polygon.ok());
    const auto opposite = opposite_vertices(*polygon, {0, 0});
    REQUIRE(opposite.ok());
    INFO(off);
    CHECK(opposite->size() == (off < 1e-8 ? 2u : 1u));
  }
}

TEST_CASE("a vertex at the centre of mass is opposite to none", "[candidates]") {
  for (const double off : {0.0, 1e-12}) {
    const auto polygon =
        Polygon::create({{0, 0}, {6, 0}, {6, 4}, {4, 4}, {4, 2}, {2, 2}, {2, 4}, {0, 4}});
    REQUIRE(polygon.ok());
    const auto opposite = opposite_vertices(*polygon, {2 + off, 2 + off});
    REQUIRE(opposite.ok());
    for (const OppositeVertices& two : *opposite) {
      CHECK(two.v != 5);
      CHECK(two.w != 5);
    }
  }
}

TEST_CASE("a triangle's candidates about its centroid are parallel to its sides", "[candidates]") {
  const auto found = candidates({{0, 0}, {3, 0}, {0, 3}}, {}, 1);
  REQUIRE(found.size() == 3);
  is(found[0], {0, 2}, {2, 0}, bisecting, 1);
  is(found[1], {0, 1}, {2, 1}, bisecting, 1);
  is(found[2], {1, 0}, {1, 2}, bisecting, 1);
}

TEST_CASE("a regular hexagon's candidates are its diameters and the midpoint chords of its sides",
          "[candidates]") {
  const double h = std::sqrt(3.0) / 2;
  const auto found =
      candidates({{1, 0}, {0.5, h}, {-0.5, h}, {-1, 0}, {-0.5, -h}, {0.5, -h}}, Vec2(0, 0), 0.8);
  REQUIRE(found.size() == 6);
  for (const Candidate& c : found) {
    CHECK(c.kind == (c.between_vertices ? bisecting : midpoint));
    CHECK(c.length == Approx(c.between_vertices ? 2 : 2 * h).epsilon(1e-14));
  }
  CHECK(found[5].direction.y > 0);  // the vertical one
  CHECK(std::fabs(found[5].direction.x) <= 1e-9);
}

TEST_CASE("a pair has a bisecting, midpoint or vertex chord, or none below the ratio",
          "[candidates]") {
  const Points rectangle{{-4, -2}, {5, -2}, {5, 3}, {-4, 3}};
  const auto all = candidates(rectangle, Vec2(0, 0), 0.5);
  REQUIRE(all.size() == 4);
  is(all[0], {-4, 2}, {4, -2}, bisecting, 1);
  is(all[1], {-4, -0.2}, {5, 0.25}, midpoint, 0.8);
  is(all[2], {-4, -2}, {5, 2.5}, vertex, 0.8);
  is(all[3], {-1.0 / 3, -2}, {0.5, 3}, midpoint, 2.0 / 3);
  CHECK(candidates(rectangle, Vec2(0, 0), 0.8).size() == 3);  // the minimum itself counts
  CHECK(candidates(rectangle, Vec2(0, 0), 0.8 + 2e-9).size() == 1);
  CHECK(candidates(rectangle, Vec2(0, 0), 1).size() == 1);
}

TEST_CASE("a vertex-chord that misses the minimum load ratio by less than the tolerance counts",
          "[candidates]") {
  // The vertex-chord and the midpoint chord have the ratio 0.8. Estimates decide the first where
  // certain.
  const Points rectangle{{-4, -2}, {5, -2}, {5, 3}, {-4, 3}};
  for (const double above : {0.5e-9, 0.9e-9, 0.97e-9}) {
    INFO(above);
    const auto found = candidates(rectangle, Vec2(0, 0), 0.8 + above);
    REQUIRE(found.size() == 3);
    is(found[2], {-4, -2}, {5, 2.5}, vertex, 0.8);
  }
}

TEST_CASE("a verdict says how a pair came by its candidate", "[candidates]") {
  const auto polygon = Polygon::create({{-4, -2}, {5, -2}, {5, 3}, {-4, 3}});
  REQUIRE(polygon.ok());
  const auto pairs = edge_pairs(*polygon, {0, 0});
  REQUIRE(pairs.ok());
  int parallel = 0, bisected = 0, neither = 0;
  for (const EdgePair& pair : *pairs) {
    const PairVerdict verdict = examine_pair(*polygon, {0, 0}, pair, 0.9);
    CHECK(verdict.candidate.has_value() == verdict.bisected);
    CHECK(verdict.parallel == (std::fabs(verdict.g0 - verdict.g1) < 1e-9));
    if (!verdict.parallel) CHECK(verdict.bisected == ((verdict.g0 - 1) * (verdict.g1 - 1) <= 0));
    ++(verdict.parallel ? parallel : verdict.bisected ? bisected : neither);
  }
  CHECK(parallel == 2);
  CHECK(bisected == 1);
  CHECK(neither >= 1);
}

TEST_CASE("a section end that C bisects exactly is a bisecting chord", "[candidates]") {
  const auto found = candidates({{-4, -2}, {4, -2}, {4, 3}, {-4, 3}}, Vec2(0, 0), 0.9);
  REQUIRE(found.size() == 3);
  is(found[0], {-4, 2}, {4, -2}, bisecting, 1);
  is(found[1], {-4, 0}, {4, 0}, midpoint, 1);
  is(found[2], {-4, -2}, {4, 2}, bisecting, 1);
}

TEST_CASE("a lower minimum load ratio only adds candidates", "[candidates][slow]") {
  int more = 0;
  for (std::uint64_t i = 0; i < 600; ++i) {
    const small_polygons::Case c = small_polygons::make_case(i);
    const Document document = testing::document_of(c.problem);
    const Points& vertices = document.vertices;
    const auto few = candidates(vertices, document.centre_of_mass, 0.9),
               many = candidates(vertices, document.centre_of_mass, 0.3);
    more += many.size() > few.size();
    // Within the tolerance, a merged chord may represent one with a lower ratio.
    const auto polygon = Polygon::create(vertices);
    for (const Candidate& candidate : few) {
      CHECK(std::any_of(many.begin(), many.end(), [&](const Candidate& other) {
        const double near = 4 * near_distance(polygon->diameter());
        return length(candidate.chord.r1.position - other.chord.r1.position) <= near &&
               length(candidate.chord.r2.position - other.chord.r2.position) <= near;
      }));
    }
  }
  CHECK(more > 200);
}

namespace {

Candidate made(const Vec2& r1, const Vec2& r2, CandidateKind kind, double ratio = 1) {
  Candidate c;
  c.chord.r1.position = r1;
  c.chord.r2.position = r2;
  c.chord.arm1 = length(r1);
  c.chord.arm2 = length(r2);
  c.chord.ratio = ratio;
  c.kind = kind;
  c.direction = r2 - r1;
  c.length = c.chord.arm1 + c.chord.arm2;
  return c;
}

void sort_by_slope(std::vector<Candidate>& list) {
  std::vector<SlopeKey> keys;
  for (const Candidate& c : list) {
    const bool right = is_vertical(c.direction) ? c.direction.y > 0 : c.direction.x > 0;
    REQUIRE(right);
    keys.push_back(slope_key(c.direction, static_cast<std::uint32_t>(keys.size())));
  }
  sort_keys(keys);
  std::vector<Candidate> sorted;
  for (const SlopeKey key : keys) sorted.push_back(list[number_of(key)]);
  settle_order(sorted, 1e-9);
  list.swap(sorted);
}

}  // namespace

TEST_CASE(
    "candidate order is by slope, and on one line the longer first, then the farther right end",
    "[candidates]") {
  const std::vector<Candidate> in_order{
      made({-1, 9}, {1, -9}, vertex),         made({-1, 1}, {1, -1}, vertex),
      made({-3, 0}, {3, 0}, vertex),          made({-1, 0}, {4, 0}, vertex),
      made({-2, 0}, {3, 0}, vertex),          made({-2, 0}, {2, 0}, vertex),
      made({-1, -1}, {1, 1}, vertex),         made({-1e-7, -9}, {1e-7, 9}, vertex),
      made({1e-17, -5}, {-1e-17, 5}, vertex), made({0, -1}, {0, 4}, vertex),
  };
  std::mt19937_64 engine(11);
  for (int i = 0; i < 200; ++i) {
    std::vector<Candidate> shuffled = in_order;
    std::shuffle(shuffled.begin(), shuffled.end(), engine);
    sort_by_slope(shuffled);
    for (std::size_t k = 0; k < in_order.size(); ++k) {
      CHECK(shuffled[k].chord.r1.position == in_order[k].chord.r1.position);
      CHECK(shuffled[k].chord.r2.position == in_order[k].chord.r2.position);
    }
  }
}

TEST_CASE("of chords equally long and equally far to the right, rounding does not tip the order",
          "[candidates]") {
  // Within tolerance of one line; only rounding separates the left ends in x.
  const auto low = [](double rounding) { return made({-3 + rounding, 0}, {3, -2e-9}, vertex); };
  const auto high = [](double rounding) { return made({-3 + rounding, 2e-9}, {3, 0}, vertex); };
  for (const double rounding : {-1e-17, -5e-16, 0.0, 5e-16}) {
    std::vector<Candidate> one_way{high(rounding), low(0)}, other_way{low(0), high(rounding)};
    sort_by_slope(one_way);
    sort_by_slope(other_way);
    CHECK(one_way[0].chord.r1.position.y == 0);
    CHECK(other_way[0].chord.r1.position.y == 0);
  }
}

TEST_CASE("of duplicates the most even stands, under the first kind that occurs", "[candidates]") {
  const double hair = 1e-10;
  std::vector<Candidate> list{
      made({-1, 0}, {1, 0}, vertex, 0.9), made({-1, hair}, {1, -hair}, midpoint, 0.95),
      made({-1, 2 * hair}, {1, 0}, bisecting, 0.93), made({-1, 1}, {1, -1}, vertex, 0.8)};
  list = merge_duplicates(list, 1e-9).candidates;
  REQUIRE(list.size() == 2);
  CHECK(list[0].chord.ratio == 0.95);
  CHECK(list[0].kind == bisecting);
  CHECK(list[0].chord.r1.position == Vec2(-1, hair));
  CHECK(list[1].kind == vertex);
}

TEST_CASE("of duplicates one between two vertices stands and keeps its kind", "[candidates]") {
  const double hair = 1e-10;
  std::vector<Candidate> list{made({-1, hair}, {1, -hair}, midpoint, 0.95),
                              made({-1, 0}, {1, 0}, vertex, 0.9)};
  list[1].between_vertices = true;
  list = merge_duplicates(list, 1e-9).candidates;
  REQUIRE(list.size() == 1);
  CHECK(list[0].chord.ratio == 0.9);
  CHECK(list[0].kind == vertex);
}

TEST_CASE("chords whose ends agree within tolerance are duplicates, however their slopes differ",
          "[candidates]") {
  // Each end turns by 0.99 tau of the half chord, so the slope grows by twice that.
  const double half = std::sqrt(0.5), turn = 0.99e-9 * half;
  std::vector<Candidate> list{
      made({-half, -half}, {half, half}, vertex),
      made({turn - half, -turn - half}, {half - turn, half + turn}, vertex)};
  list = merge_duplicates(list, 1e-9).candidates;
  CHECK(list.size() == 1);
}

TEST_CASE("chords that share one end only are not duplicates", "[candidates]") {
  std::vector<Candidate> list{made({-1, 0}, {1, 0}, vertex), made({-1, 0}, {2, 0}, vertex),
                              made({-1, 0}, {1, 2e-9}, vertex)};
  list = merge_duplicates(list, 1e-9).candidates;
  CHECK(list.size() == 3);
}

TEST_CASE("many candidates of many slopes come in exact order of slope", "[candidates]") {
  std::mt19937_64 engine(12);
  std::vector<Candidate> list;
  for (int i = 0; i < 3000; ++i) {
    // Few coordinates, so that equal and nearly vertical slopes occur.
    const double x = static_cast<double>(1 + engine() % 40),
                 y = static_cast<double>(engine() % 81) - 40;
    list.push_back(made({-x, -y}, {x, y}, vertex));
  }
  sort_by_slope(list);
  for (std::size_t i = 1; i < list.size(); ++i) {
    const Vec2 &before = list[i - 1].direction, &after = list[i].direction;
    const double side = cross(before, after);
    CHECK(side >= 0);
    if (side == 0) CHECK(list[i - 1].length >= list[i].length);
  }
}

TEST_CASE("duplicates are found beside a chord that rounding made a point", "[candidates]") {
  std::vector<Candidate> list{made({0, 0}, {0, 0}, vertex), made({-1, 0}, {1, 0}, vertex),
                              made({-1, 0}, {1, 0}, vertex)};
  list = merge_duplicates(list, 1e-9).candidates;
  CHECK(list.size() == 2);
}

TEST_CASE("duplicates are found whichever end is called the right one", "[candidates]") {
  std::vector<Candidate> list{made({0, -1}, {0, 1}, vertex, 0.9),
                              made({0, 1}, {1e-10, -1}, midpoint, 0.8)};
  list = merge_duplicates(list, 1e-9).candidates;
  REQUIRE(list.size() == 1);
  CHECK(list[0].kind == midpoint);
  CHECK(list[0].chord.ratio == 0.9);
}
