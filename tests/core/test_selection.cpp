// Lazy evaluation against the greedy choice written out, metrics by hand, equal angles and random
// teams.
#include "evenlift/selection.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <string>

#include "evenlift/angles.h"
#include "evenlift/generate.h"
#include "evenlift/hull.h"
#include "evenlift/placement.h"
#include "evenlift/random.h"
#include "evenlift/tolerance.h"
#include "kit/catch.h"
#include "kit/corpus.h"
#include "kit/metrics.h"
#include "kit/solid.h"
#include "selection/greedy_selector.h"
#include "shapes/problem_document.h"
#include "shapes/small_polygons.h"

using namespace evenlift;

namespace {

struct Shape {
  Polygon polygon;
  Vec2 centre;
  std::vector<Candidate> candidates;
};

Shape shape(Points vertices, const std::optional<Vec2>& given, double min_ratio) {
  auto polygon = Polygon::create(std::move(vertices));
  REQUIRE(polygon.ok());
  const auto centre = check_centre_of_mass(*polygon, given);
  REQUIRE(centre.ok());
  auto candidates = find_candidates(*polygon, *centre, min_ratio);
  REQUIRE(candidates.ok());
  return {*std::move(polygon), *centre, *std::move(candidates)};
}

Shape small_shape(std::uint64_t number) {
  const small_polygons::Case c = small_polygons::make_case(number);
  const Document d = testing::document_of(c.problem);
  return shape(d.vertices, d.centre_of_mass, d.settings.min_ratio);
}

const std::vector<Method> metrics = testing::metrics();
constexpr double tie = 1e-9;

// Scores always tie within this; for `distance` it is larger where an edge of H is short.
double floor_of(const Shape& s, Method method, const std::vector<std::uint32_t>& taken) {
  const double size = s.polygon.diameter();
  if (method != Method::distance) return 1e-12 * size * size;
  Points ends;
  for (const std::uint32_t i : taken)
    for (const LiftingPoint* end : {&s.candidates[i].chord.r1, &s.candidates[i].chord.r2})
      ends.push_back(end->position - s.centre);
  const Points hull = convex_hull(std::move(ends), near_distance(size));
  double shortest = size / 1000;
  for (std::size_t i = 0; i < hull.size(); ++i)
    shortest = std::min(shortest, length(hull[(i + 1) % hull.size()] - hull[i]));
  return 1e-15 * size * size / shortest;
}

// Word for word: all scores, then key after key.
std::vector<std::uint32_t> greedy(const Shape& s, Method method, std::size_t teams) {
  std::vector<std::uint32_t> taken, left(s.candidates.size());
  std::iota(left.begin(), left.end(), 0u);
  while (taken.size() < teams && !left.empty()) {
    std::vector<std::uint32_t> best = left;
    const auto keep = [&](auto key, auto slack) {
      double most = -1e300;
      for (const auto i : best) most = std::max(most, key(i));
      std::erase_if(best, [&](auto i) { return !(key(i) >= most - slack(most)); });
    };
    const auto ratio = [&](std::uint32_t i) { return s.candidates[i].chord.ratio; };
    const auto length_of = [&](std::uint32_t i) { return s.candidates[i].length; };
    const auto absolute = [](double) { return tie; };
    const auto relative = [](double most) { return tie * most; };
    if (taken.empty()) {
      std::vector<std::uint32_t> even;
      for (const auto i : left)
        if (ratio(i) >= 1 - tie) even.push_back(i);
      if (!even.empty()) {
        best = even;
        keep(length_of, relative);
        keep(ratio, absolute);
      } else {
        keep(ratio, absolute);
        keep(length_of, relative);
      }
    } else {
      const std::vector<double> score =
          scores(solid(s.polygon), s.centre, s.candidates, taken, *metric_of(method));
      const double floor = floor_of(s, method, taken);
      keep([&](std::uint32_t i) { return score[i]; },
           [&](double most) { return std::max(tie * std::fabs(most), floor); });
      keep(ratio, absolute);
      keep(length_of, relative);
    }
    taken.push_back(best.front());
    std::erase(left, best.front());
  }
  return taken;
}

}  // namespace

TEST_CASE("lazy selection takes what comparing all scores takes", "[selection][thorough]") {
  std::size_t rounds = 0, none_even = 0;
  for (std::uint64_t number = 0; number < 2000; ++number) {
    const Shape s = small_shape(number);
    none_even += !s.candidates.empty() &&
                 std::all_of(s.candidates.begin(), s.candidates.end(),
                             [](const Candidate& c) { return c.chord.ratio < 1 - tie; });
    const Method method = metrics[number / 9 % metrics.size()];
    const std::size_t teams = std::min<std::size_t>(s.candidates.size(), 12);
    const auto lazy =
        select_teams(solid(s.polygon), s.centre, s.candidates, *metric_of(method), teams);
    const auto expected = greedy(s, method, teams);
    rounds += teams;
    if (lazy == expected) continue;
    INFO("case " << number << ", " << small_polygons::make_case(number).name << ", "
                 << name(method));
    CHECK(lazy == expected);
  }
  CHECK(rounds > 8000);
  CHECK(none_even > 50);  // the rule for the first team has two halves
}

TEST_CASE("lazy selection takes all candidates of larger polygons in the right order",
          "[selection]") {
  for (const char* file : {"puzzle-piece", "gear", "letter-e", "star", "spanner-moved"}) {
    const Document d = corpus::polygon(file);
    for (const Method method : metrics) {
      const Shape s = shape(d.vertices, d.centre_of_mass, 0.8);
      const std::size_t teams = std::min<std::size_t>(s.candidates.size(), 60);
      INFO(file << ", " << name(method) << ", " << teams << " teams");
      CHECK(select_teams(solid(s.polygon), s.centre, s.candidates, *metric_of(method), teams) ==
            greedy(s, method, teams));
    }
  }
}

TEST_CASE("a team more leaves the teams before it as they were", "[selection][slow]") {
  std::size_t compared = 0;
  for (std::uint64_t number = 0; number < 1200; ++number) {
    const Shape s = small_shape(number);
    const Method method = metrics[number % metrics.size()];
    const auto all = select_teams(solid(s.polygon), s.centre, s.candidates, *metric_of(method),
                                  s.candidates.size());
    CHECK(all.size() == s.candidates.size());
    for (std::size_t teams = 1; teams < std::min<std::size_t>(all.size(), 9); ++teams) {
      const auto some =
          select_teams(solid(s.polygon), s.centre, s.candidates, *metric_of(method), teams);
      CHECK(some == std::vector(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(teams)));
      ++compared;
    }
  }
  CHECK(compared > 3000);
}

TEST_CASE("the three metrics score a triangle's chords as worked out by hand", "[selection]") {
  const Shape s = shape({{0, 0}, {3, 0}, {0, 3}}, {}, 0.8);
  REQUIRE(s.candidates.size() == 3);
  const auto second = [&](Metric metric) {
    const std::vector<double> score = scores(solid(s.polygon), s.centre, s.candidates, {0}, metric);
    CHECK(score[0] == Approx(0).margin(1e-14));
    CHECK(score[1] == Approx(score[2]).epsilon(1e-13));  // mirrored at the diagonal
    CHECK(select_teams(solid(s.polygon), s.centre, s.candidates, metric, 3) ==
          std::vector<std::uint32_t>{0, 1, 2});
    return score[1];
  };
  CHECK(second(Metric::area) == Approx(2).epsilon(1e-14));
  // Two triangles of area 1 with sides 1, sqrt(5), sqrt(8).
  const double radius = 2 / (1 + std::sqrt(5.0) + std::sqrt(8.0));
  CHECK(second(Metric::circle) == Approx(2 * pi * radius * radius).epsilon(1e-13));
  // (0,0) gains sqrt(2) - 2/sqrt(5); (3,0) and (0,3) lose by longer arms about the new edges.
  const double half = std::sqrt(0.5), fifth = 2 / std::sqrt(5.0);
  CHECK(second(Metric::distance) ==
        Approx(std::sqrt(2.0) - fifth + (half - 1) + (half - fifth)).epsilon(1e-13));
}

TEST_CASE("area counts what belongs to the polygon, circle the whole triangle", "[selection]") {
  // A plus, with the first team from tip to tip.
  const Shape s = shape({{-1, -3},
                         {1, -3},
                         {1, -1},
                         {3, -1},
                         {3, 1},
                         {1, 1},
                         {1, 3},
                         {-1, 3},
                         {-1, 1},
                         {-3, 1},
                         {-3, -1},
                         {-1, -1}},
                        {}, 1);
  const auto find = [&](const Vec2& r1, const Vec2& r2) {
    for (std::uint32_t i = 0; i < s.candidates.size(); ++i)
      if (length(s.candidates[i].chord.r1.position - r1) +
              length(s.candidates[i].chord.r2.position - r2) <
          1e-12)
        return i;
    FAIL("no such candidate");
    return 0u;
  };
  const std::uint32_t level = find({-3, 0}, {3, 0}), upright = find({0, -3}, {0, 3});
  // The triangle (-3,0), (3,0), (0,3) has area 9. Its part in the plus, below y = 3 - |x| and above
  // 0, is 3 + 2 in the stem and 1.5 in each arm.
  const std::vector<double> area =
      scores(solid(s.polygon), s.centre, s.candidates, {level}, Metric::area);
  CHECK(area[upright] == Approx(2 * (5 + 2 * 1.5)).epsilon(1e-13));
  const std::vector<double> circle =
      scores(solid(s.polygon), s.centre, s.candidates, {level}, Metric::circle);
  const double radius = 2 * 9 / (6 + 2 * std::sqrt(18.0));
  CHECK(circle[upright] == Approx(2 * pi * radius * radius).epsilon(1e-13));
}

namespace {

double length_between(const Vec2& p, const Vec2& q) { return length(p - q); }

// In either direction.
bool runs_between(const Chord& chord, const Vec2& p, const Vec2& q) {
  const Vec2 &r1 = chord.r1.position, &r2 = chord.r2.position;
  return std::min(std::max(length_between(r1, p), length_between(r2, q)),
                  std::max(length_between(r1, q), length_between(r2, p))) < 1e-12;
}

}  // namespace

TEST_CASE("the first team is the longest even one, though a longer chord is uneven",
          "[selection]") {
  const Shape s = shape({{0, 0}, {12, 0}, {12, 2}, {4, 2}, {4, 8}, {0, 8}}, Vec2(3, 1.5), 0);
  int shorter_even = 0, longer_uneven = 0;
  const double longest_even = std::sqrt(45.0);
  for (const Candidate& c : s.candidates) {
    const bool even = c.chord.ratio >= 1 - tie;
    shorter_even += even && c.length < longest_even - 0.1;
    longer_uneven += !even && c.length > longest_even + 0.1;
  }
  REQUIRE(shorter_even >= 2);
  REQUIRE(longer_uneven >= 2);
  for (const Method method : metrics) {
    const auto first =
        select_teams(solid(s.polygon), s.centre, s.candidates, *metric_of(method), 1);
    REQUIRE(first.size() == 1);
    CHECK(runs_between(s.candidates[first[0]].chord, {0, 3}, {6, 0}));
  }
}

TEST_CASE("with no even candidate the first team is the most even, though another is longer",
          "[selection]") {
  // C is in an arrowhead's hollow, nearer to its left arm, so that no chord is even. (A convex
  // polygon always has one.)
  const Shape s = shape({{-3, 4}, {0, -2}, {3, 4}, {0, 1}}, Vec2(-1, 3.5), 0);
  const double best = 5.0 / 7;
  int less_even_and_longer = 0;
  for (const Candidate& c : s.candidates) {
    CHECK(c.chord.ratio < best + 1e-12);
    less_even_and_longer += c.chord.ratio < best - 0.1 && c.length > 5;
  }
  REQUIRE(less_even_and_longer >= 1);
  for (const Method method : metrics) {
    const auto first =
        select_teams(solid(s.polygon), s.centre, s.candidates, *metric_of(method), 1);
    REQUIRE(first.size() == 1);
    CHECK(s.candidates[first[0]].chord.ratio == Approx(best).epsilon(1e-13));
    CHECK(runs_between(s.candidates[first[0]].chord, {-3, 4}, {1.8, 2.8}));
  }
}

TEST_CASE("distributed teams stand at equal angles around a convex polygon", "[selection]") {
  for (const char* file : {"hexagon", "round-table", "convex-20", "stone-slab-moved"}) {
    const Document d = corpus::polygon(file);
    const Shape s = shape(d.vertices, d.centre_of_mass, 0.8);
    for (const std::size_t teams : {1u, 2u, 5u, 16u}) {
      INFO(file << ", " << teams << " teams");
      const auto chords = distributed_teams(s.polygon, s.centre, teams);
      REQUIRE(chords.size() == teams);
      for (std::size_t k = 0; k < teams; ++k) {
        // Every direction counts, so team k is at (k + 1/2) / t of the half turn.
        const double angle = pi * (static_cast<double>(k) + 0.5) / static_cast<double>(teams);
        Vec2 u = chords[k].r2.position - chords[k].r1.position;
        u /= length(u);
        CHECK(std::fabs(cross(u, Vec2(std::cos(angle), std::sin(angle)))) <= 1e-12);
      }
    }
  }
}

TEST_CASE("distributed teams keep to directions that meet the boundary on both sides",
          "[selection]") {
  // In the hollow of the U, only lines through the bottom or both legs count.
  const Shape s =
      shape({{0, 0}, {6, 0}, {6, 4}, {4, 4}, {4, 2}, {2, 2}, {2, 4}, {0, 4}}, Vec2(3, 3), 0);
  const auto chords = distributed_teams(s.polygon, s.centre, 7);
  REQUIRE(chords.size() == 7);
  for (const Chord& c : chords) {
    CHECK(c.r1.position.x <= 2);
    CHECK(c.r2.position.x >= 4);
    // The farthest points are on the outer walls, the top or the bottom.
    for (const Vec2& q : {c.r1.position, c.r2.position}) {
      const bool outer = std::fabs(q.x) <= 1e-12 || std::fabs(q.x - 6) <= 1e-12 ||
                         std::fabs(q.y) <= 1e-12 || std::fabs(q.y - 4) <= 1e-12;
      CHECK(outer);
    }
  }
}

TEST_CASE("a centre of mass on a side of a square leaves distributed selection nothing",
          "[selection]") {
  // C is inside by a hair, within tolerance of the side.
  const Shape s = shape({{0, 0}, {2, 0}, {2, 2}, {0, 2}}, Vec2(1, 0x1p-60), 0);
  CHECK(distributed_teams(s.polygon, s.centre, 3).empty());
}

TEST_CASE("the same seed draws the same teams, another seed others", "[selection]") {
  const Document d = corpus::polygon("horseshoe");
  const Shape s = shape(d.vertices, d.centre_of_mass, 0.8);
  const auto positions = [&](std::uint64_t seed, std::size_t teams) {
    Points points;
    for (const Chord& c : random_teams(s.polygon, s.centre, teams, seed)) {
      points.push_back(c.r1.position);
      points.push_back(c.r2.position);
    }
    return points;
  };
  const Points some = positions(1, 5), more = positions(1, 9);
  CHECK(some == positions(1, 5));
  CHECK(some == Points(more.begin(), more.begin() + 10));
  CHECK(some != positions(2, 5));
  CHECK(some != positions(std::uint64_t{1} << 63, 5));
}

TEST_CASE("random first ends are spread evenly along the perimeter", "[selection]") {
  // About a square's centre both ends are random: each side has a quarter of them.
  const Shape s = shape({{0, 0}, {2, 0}, {2, 2}, {0, 2}}, {}, 0.8);
  const auto chords = random_teams(s.polygon, s.centre, 4000, 3);
  REQUIRE(chords.size() == 4000);
  int on_side[4] = {}, in_first_half = 0;
  for (const Chord& c : chords) {
    for (const LiftingPoint* r : {&c.r1, &c.r2}) {
      ++on_side[r->edge];
      in_first_half += r->edge == 0 && r->position.x < 1;
    }
    CHECK(c.ratio == Approx(1).epsilon(1e-12));
  }
  for (const int number : on_side) CHECK(std::abs(number - 2000) < 200);
  CHECK(std::abs(in_first_half - 1000) < 150);
}

TEST_CASE("a random second end is any of the points across, each as likely", "[selection]") {
  // Level lines through C meet both walls of both legs, the outer ones three times as far away.
  // Within one angle, 3/4 of the perimeter is outer, 1/4 inner.
  const Shape s =
      shape({{0, 0}, {6, 0}, {6, 4}, {4, 4}, {4, 2}, {2, 2}, {2, 4}, {0, 4}}, Vec2(3, 3.5), 0);
  const auto chords = random_teams(s.polygon, s.centre, 6000, 4);
  REQUIRE(chords.size() == 6000);
  int level = 0, between_inner = 0;
  for (const Chord& c : chords) {
    const Vec2 d = c.r2.position - c.r1.position;
    if (std::fabs(d.y) > 0.15 * std::fabs(d.x)) continue;
    ++level;
    between_inner += c.r1.position.x == Approx(2) && c.r2.position.x == Approx(4);
  }
  REQUIRE(level > 500);
  // The first end is on an inner wall, the second on one of two.
  CHECK(static_cast<double>(between_inner) / level == Approx(1.0 / 8).margin(0.04));
}

TEST_CASE("fewer teams are the first of more, also where thousands of candidates tie",
          "[selection]") {
  const Points comb = *generate(Family::comb, 120, 1);
  for (const double min_ratio : {0.0, 0.8}) {
    const Shape s = shape(comb, std::nullopt, min_ratio);
    for (const Method method : metrics) {
      const auto all = select_teams(solid(s.polygon), s.centre, s.candidates, *metric_of(method),
                                    s.candidates.size());
      REQUIRE(all.size() == s.candidates.size());
      REQUIRE(all.size() > 500);
      for (const std::size_t teams : {1u, 2u, 3u, 7u, 20u, 60u, 200u, 499u}) {
        INFO(name(method) << ", " << teams << " teams");
        const auto few =
            select_teams(solid(s.polygon), s.centre, s.candidates, *metric_of(method), teams);
        CHECK(few == std::vector<std::uint32_t>(all.begin(),
                                                all.begin() + static_cast<std::ptrdiff_t>(teams)));
      }
    }
  }
}

TEST_CASE("no team is placed where none is asked for", "[selection]") {
  const Shape s = shape({{0, 0}, {2, 0}, {2, 2}, {0, 2}}, {}, 0.8);
  CHECK(random_teams(s.polygon, s.centre, 0, 1).empty());
  CHECK(distributed_teams(s.polygon, s.centre, 0).empty());
  CHECK(select_teams(solid(s.polygon), s.centre, s.candidates, Metric::area, 0).empty());
}

TEST_CASE("candidates that tie are taken as if the keys were compared anew each time",
          "[core][selection]") {
  Rng rng(7);
  const PolygonWithHoles square = solid(shape({{0, 0}, {2, 0}, {2, 2}, {0, 2}}, {}, 0.8).polygon);
  int chains = 0;  // where the order differs from that of classes formed once
  for (int round = 0; round < 2000; ++round) {
    std::vector<Candidate> candidates(1 + rng.below(24));
    for (Candidate& c : candidates) {
      // All ends are the same, so that after one team no other widens the base.
      c.chord.r1.position = {0, 1};
      c.chord.r2.position = {2, 1};
      c.chord.ratio = 1 - 0.31e-9 * static_cast<double>(rng.below(9));
      c.length = 5 * (1 + 0.31e-9 * static_cast<double>(rng.below(9)));
    }
    std::vector<std::uint32_t> left(candidates.size());
    std::iota(left.begin(), left.end(), 0u);
    std::vector<std::uint32_t> expected;
    double ratio_before = 0;
    bool chain = false;
    while (!left.empty()) {
      std::vector<std::uint32_t> best = left;
      const auto keep = [&](auto key, auto ties) {
        double most = 0;
        for (const auto i : best) most = std::max(most, key(i));
        std::erase_if(best, [&](auto i) { return !ties(most, key(i)); });
        return most;
      };
      const double ratio = keep([&](auto i) { return candidates[i].chord.ratio; }, ratios_tie);
      keep([&](auto i) { return candidates[i].length; }, lengths_tie);
      expected.push_back(best.front());
      std::erase(left, best.front());
      chain = chain || (ratio < ratio_before && ratios_tie(ratio, ratio_before));
      ratio_before = ratio;
    }
    chains += chain;
    const auto first = static_cast<std::uint32_t>(candidates.size());
    candidates.push_back(candidates.front());
    Selector selector(square, {1, 1}, candidates, Metric::area);
    selector.take(first);
    while (selector.take_next()) {
    }
    CHECK(std::vector(selector.taken().begin() + 1, selector.taken().end()) == expected);
  }
  CHECK(chains > 1000);
}

// Pairs of points in opposite directions. If `nearly` is above 0, many are nearly on one side or
// nearly at one place, so that rounding decides which of them are corners.
std::vector<std::pair<Vec2, Vec2>> opposite_points(Rng& rng, double nearly) {
  std::vector<std::pair<Vec2, Vec2>> pairs(300);
  const double sides = 3 + static_cast<double>(rng.below(200));
  for (auto& [p, q] : pairs) {
    const double along = nearly == 0 || rng.uniform() < 0.3 ? 0 : rng.uniform();
    const double side = rng.uniform() * sides, first = nearly == 0 ? side : std::floor(side);
    const auto corner = [&](double k) {
      const double angle = 2 * std::numbers::pi * k / sides;
      return Vec2{std::cos(angle), std::sin(angle)};
    };
    p = (1 - along) * corner(first) + along * corner(first + 1);
    p = (1 + (rng.uniform() - 0.5) * nearly * static_cast<double>(rng.below(4))) * p;
    q = -(0.8 + 0.2 * rng.uniform()) * p;
    if (rng.below(2) == 0) std::swap(p, q);
  }
  return pairs;
}

TEST_CASE("a base that grows edge by edge is the convex hull", "[core][selection]") {
  Rng rng(8);
  constexpr double flat = 2e-9;
  std::size_t changes = 0, large = 0;
  for (int round = 0; round < 300; ++round) {
    GrowingBase base(flat);
    Points hull, points;
    std::map<GrowingBase::Corner, Vec2> ends;  // of the edge that begins at each corner
    const double nearly = round % 2 == 0 ? 0 : flat;
    for (const auto& [p, q] : opposite_points(rng, nearly)) {
      points.insert(points.end(), {p, q});
      // The edge through which C sees a point, as the selector knows it.
      const auto added = [&](const Vec2& point) -> GrowingBase::Added {
        for (const auto& [start, end] : ends)
          if (cross(base.position(start), point) >= 0 && cross(point, end) > 0)
            return {point, start};
        return {point, {}};
      };
      const auto starts = base.add(added(p), added(q));
      const Points before = std::exchange(hull, base.positions());
      CHECK(starts.empty() == (before == hull));
      changes += starts.size();
      large += hull.size() > 64;
      // The edges that are not named as new are the same as before.
      for (const auto start : starts) ends[start] = base.position(base.next(start));
      std::erase_if(ends, [&](const auto& edge) { return !base.has(edge.first); });
      REQUIRE(ends.size() == hull.size());
      for (const auto& [start, end] : ends) REQUIRE(base.position(base.next(start)) == end);
    }
    if (nearly == 0) {
      CHECK(hull == convex_hull(points, flat));
      continue;
    }
    CHECK(hull == convex_hull(hull));
    double outside = 0;
    for (const Vec2& point : points)
      for (std::size_t i = 0; i < hull.size(); ++i) {
        const Vec2& h1 = hull[i];
        const Vec2 edge = hull[(i + 1) % hull.size()] - h1;
        outside = std::max(outside, -cross(edge, point - h1) / length(edge));
      }
    CHECK(outside <= 2 * flat);
  }
  CHECK(changes > 20000);
  CHECK(large > 10000);
}
