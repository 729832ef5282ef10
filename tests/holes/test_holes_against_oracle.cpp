// Refusals, area, centroid, the coverage in all its forms, the metric area, and whole placements.
#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "balanced/search.h"
#include "comparisons/against_oracle.h"
#include "evenlift/balanced.h"
#include "evenlift/generate.h"
#include "evenlift/hull.h"
#include "evenlift/optimum.h"
#include "evenlift/placed_robots.h"
#include "evenlift/placement.h"
#include "evenlift/random.h"
#include "evenlift/selection.h"
#include "evenlift/swaps.h"
#include "evenlift/tolerance.h"
#include "kit/catch.h"
#include "kit/placed.h"
#include "shapes/holed_polygons.h"
#include "shapes/problem_document.h"

using namespace evenlift;
using evenlift::testing::document_of;
using evenlift::testing::placed;
using evenlift::testing::point_of;
using evenlift::testing::points_of;
using evenlift::testing::problem_of;
using evenlift::testing::ring_of;
using oracle::Refusal;
using oracle::Ring;

namespace {

PolygonWithHoles object_with(const Points& outline, const std::vector<Points>& holes) {
  Document document;
  document.vertices = outline;
  document.holes = holes;
  auto object = object_of(document);
  REQUIRE(object.ok());
  return *std::move(object);
}

PolygonWithHoles object_with(const oracle::Problem& problem) {
  return object_with(points_of(problem.vertices), points_of(problem.holes));
}

// With up to this number of holes.
PolygonWithHoles generated(Family family, std::size_t n, std::uint64_t seed, std::size_t holes) {
  const auto outline = generate(family, n, seed);
  REQUIRE(outline.ok());
  return object_with(*outline, points_of(holed_polygons::holes_in(ring_of(*outline), seed, holes)));
}

Document document_of(const PolygonWithHoles& object, Method method) {
  Document document;
  document.vertices = object.outline().vertices();
  document.holes = object.rings_of_holes();
  document.settings.method = method;
  return document;
}

LiftingPoint any_robot(const Polygon& polygon, Rng& rng) {
  LiftingPoint robot;
  robot.edge = static_cast<std::uint32_t>(rng.below(polygon.size()));
  const Vec2 &a = polygon.edge_start(robot.edge), &b = polygon.edge_end(robot.edge);
  robot.position = a + rng.uniform() * (b - a);
  return robot;
}

std::vector<LiftingPoint> any_robots(const Polygon& polygon, Rng& rng) {
  std::vector<LiftingPoint> robots;
  for (std::uint64_t i = 3 + rng.below(5); i > 0; --i) robots.push_back(any_robot(polygon, rng));
  return robots;
}

Points hull_of(const Polygon& polygon, const Points& robots) {
  return convex_hull(robots, near_distance(polygon.diameter()));
}

double exact_coverage(const oracle::Problem& problem, const Points& hull) {
  return hull.size() < 3 ? 0 : oracle::covered_share(problem, ring_of(hull));
}

// Of a coverage: more for thin objects.
double rounding_of(const PolygonWithHoles& object) {
  const double size = object.outline().diameter();
  return 1e-13 * std::max(1.0, size * size / object.area());
}

bool well_inside(const Points& hull, const Vec2& centre, double size) {
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Vec2 &a = hull[i], &b = hull[(i + 1) % hull.size()];
    if (cross(b - a, centre - a) <= 1e-6 * size * length(b - a)) return false;
  }
  return hull.size() > 2;
}

// "hole 2, edge 3 and the outline's edge 5", with both numbers counted from 1.
std::string pair_in_words(const Place& place, const std::string& kind) {
  const std::string other =
      place.other_ring == 0 ? "the outline's " : "hole " + std::to_string(place.other_ring) + ", ";
  return "hole " + std::to_string(place.ring) + ", " + kind + " " +
         std::to_string(place.index + 1) + " and " + other + kind + " " +
         std::to_string(place.other + 1);
}

const oracle::Point& vertex(const Ring& ring, std::size_t i) { return ring[i % ring.size()]; }

// Ring 0 is the outline.
using RingsAround = std::vector<Ring>;

// The first ring that is no polygon is refused as if alone.
void check_bad_hole(const InputError& error, const RingsAround& rings) {
  const std::size_t ring = error.place.ring;
  REQUIRE((ring > 0 && ring < rings.size()));
  CHECK(error.place.other_ring == ring);
  for (std::size_t i = 1; i < ring; ++i) CHECK(oracle::refusal_of_ring(rings[i]) == Refusal::none);
  const auto alone = Polygon::create(points_of(rings[ring]));
  REQUIRE_FALSE(alone.ok());
  CHECK(error.code == alone.error().code);
  CHECK(error.message == alone.error().message);
  CHECK(error.place.index == alone.error().place.index);
  CHECK(error.place.other == alone.error().place.other);
  CHECK(describe(error.place).find("hole " + std::to_string(ring)) == 0);
}

// The vertices or edges that the error names do meet.
void check_meeting(const InputError& error, const RingsAround& rings) {
  const Place& at = error.place;
  CHECK(error.code == ErrorCode::edges_cross);
  REQUIRE((at.ring > at.other_ring && at.ring < rings.size()));
  const Ring &one = rings[at.ring], &other = rings[at.other_ring];
  REQUIRE((at.index < one.size() && at.other < other.size()));
  const bool at_vertices = at.kind == Place::Kind::vertex;
  CHECK(describe(at) == pair_in_words(at, at_vertices ? "vertex" : "edge"));
  if (at_vertices) {
    CHECK(one[at.index] == other[at.other]);
    return;
  }
  CHECK(at.kind == Place::Kind::edge);
  CHECK(oracle::segments_meet(one[at.index], vertex(one, at.index + 1), other[at.other],
                              vertex(other, at.other + 1)));
}

// The number of rings around it, if no two meet.
std::size_t depth_of(const RingsAround& rings, std::size_t of) {
  std::size_t depth = 0;
  for (std::size_t i = 0; i < rings.size(); ++i)
    depth += i != of && oracle::contains(rings[i], rings[of].front());
  return depth;
}

// The innermost: the deepest of all around it.
std::optional<std::size_t> ring_around(const RingsAround& rings, std::size_t of) {
  std::optional<std::size_t> around;
  for (std::size_t i = 0; i < rings.size(); ++i)
    if (i != of && oracle::contains(rings[i], rings[of].front()) &&
        (!around || depth_of(rings, i) > depth_of(rings, *around)))
      around = i;
  return around;
}

// The error names the first hole that is not directly within the outline.
void check_outside(const InputError& error, const RingsAround& rings) {
  const std::size_t ring = error.place.ring;
  CHECK(error.code == ErrorCode::hole_outside);
  CHECK(error.place.kind == Place::Kind::hole);
  CHECK(describe(error.place) == "hole " + std::to_string(ring));
  REQUIRE((ring > 0 && ring < rings.size()));
  for (std::size_t i = 1; i < ring; ++i) CHECK(ring_around(rings, i) == std::size_t{0});
  const std::optional<std::size_t> around = ring_around(rings, ring);
  CHECK(around != std::size_t{0});
  CHECK(error.message == (around ? "the hole lies in hole " + std::to_string(*around)
                                 : "the hole lies outside the polygon"));
}

}  // namespace

TEST_CASE("holes are refused by definition, and the error names the rings at fault",
          "[holes][oracle][slow]") {
  int accepted = 0, bad = 0, meeting = 0, outside = 0, at_vertices = 0, nested = 0;
  for (std::uint64_t number = 0; number < 8000; ++number) {
    const RingsAround rings = holed_polygons::careless_rings(number);
    const std::vector<Ring> holes(rings.begin() + 1, rings.end());
    const auto object =
        PolygonWithHoles::create(*Polygon::create(points_of(rings[0])), points_of(holes));
    const Refusal expected = oracle::refusal_of_holes(rings[0], holes);
    INFO("rings number " << number);
    REQUIRE(object.ok() == (expected == Refusal::none));
    switch (expected) {
      case Refusal::bad_hole:
        ++bad;
        check_bad_hole(object.error(), rings);
        break;
      case Refusal::rings_meet:
        ++meeting;
        at_vertices += object.error().place.kind == Place::Kind::vertex;
        check_meeting(object.error(), rings);
        break;
      case Refusal::hole_outside:
        ++outside;
        nested += object.error().message.find("in hole") != std::string::npos;
        check_outside(object.error(), rings);
        break;
      default:
        ++accepted;
    }
  }
  CHECK(accepted > 200);
  CHECK(bad > 200);
  CHECK(meeting > 3000);
  CHECK(at_vertices > 500);
  CHECK(outside > 500);
  CHECK(nested > 100);
}

TEST_CASE("the area and the centroid without the holes are the nearest doubles",
          "[holes][oracle][slow]") {
  std::size_t holes = 0;
  for (std::uint64_t number = 0; number < 400; ++number) {
    const small_polygons::Case c =
        holed_polygons::with_holes(small_polygons::make_case(number), number);
    const PolygonWithHoles object = object_with(c.problem);
    INFO(against_oracle::text(c));
    CHECK(object.area() == oracle::area(c.problem));
    CHECK(point_of(object.centroid()) == oracle::centroid(c.problem));
    holes += c.problem.holes.size();
  }
  CHECK(holes > 700);
}

TEST_CASE("the area and the centroid of objects with dozens of holes are the nearest doubles",
          "[holes][oracle][slow]") {
  std::size_t most = 0;
  for (const Family family : all_families)
    for (std::uint64_t seed = 0; seed < 3; ++seed) {
      const PolygonWithHoles object = generated(family, 20 + 10 * seed, seed, 40);
      const oracle::Problem problem = problem_of(object);
      CHECK(object.area() == oracle::area(problem));
      CHECK(point_of(object.centroid()) == oracle::centroid(problem));
      most = std::max(most, object.holes().size());
    }
  CHECK(most >= 36);
}

TEST_CASE("coverage leaves the holes out, whatever lifting base", "[holes][oracle][slow]") {
  Rng rng(5);
  int partial = 0, balanced = 0;
  for (std::uint64_t number = 0; number < 250; ++number) {
    const oracle::Problem problem = holed_polygons::make_case(number).problem;
    const PolygonWithHoles object = object_with(problem);
    const Points& outline = object.outline().vertices();
    const CoverageWithin within(object, object.outline().hull());
    Settings settings;
    settings.method = Method::balanced;
    const Vec2 centre = object.centroid();
    const BalancedProblem search(object, centre, settings);
    const balanced::CoarseCover coarse(object, centre);
    for (int i = 0; i < 4; ++i) {
      const std::vector<LiftingPoint> robots = any_robots(object, rng);
      Points points = positions(robots);
      if (i == 0) points = outline;
      const Points hull = hull_of(object, points);
      const double exact = exact_coverage(problem, hull), rounding = rounding_of(object);
      INFO("case " << number << ", hull " << i);
      CHECK(coverage(object, hull) == Approx(exact).margin(rounding));
      CHECK(within.of(hull) == Approx(exact).margin(rounding));
      partial += exact > 0.01 && exact < 0.99;
      if (i == 0 || !well_inside(hull, centre, object.outline().diameter())) continue;
      CHECK(coarse.most(balanced::small_hull(robots, centre)) >= exact - 10 * rounding);
      CHECK(balanced_keys(search, robots).coverage == Approx(exact).margin(10 * rounding));
      ++balanced;
    }
  }
  CHECK(partial > 400);
  CHECK(balanced > 150);
}

TEST_CASE("objects with holes are placed as the oracle places them", "[holes][oracle][thorough]") {
  int knife_edges = 0;
  for (std::uint64_t number = 0; number < 450; ++number) {
    small_polygons::Case c = holed_polygons::make_case(number);
    if (number % 2 == 0) c.problem.metric = oracle::Metric::area;
    const auto finding = against_oracle::compare_placement(c);
    knife_edges += finding.passed_over;
    INFO(against_oracle::text(c));
    CHECK(finding.differences == "");
  }
  CHECK(knife_edges <= 8);
}

TEST_CASE("the metric area counts what each end adds without the holes", "[holes][oracle][slow]") {
  int convex = 0, reflex = 0, less = 0;
  for (std::uint64_t number = 0; number < 400; ++number) {
    oracle::Problem problem = holed_polygons::make_case(number).problem;
    problem.metric = oracle::Metric::area;
    const Placement placement = placed(document_of(problem));
    if (placement.team_candidates.empty() || problem.holes.empty()) continue;
    std::vector<oracle::Candidate> given;
    for (const Candidate& c : placement.candidates)
      given.push_back(
          {{point_of(c.chord.r1.position), point_of(c.chord.r2.position)}, c.chord.ratio});
    const oracle::CandidateList list = oracle::given_candidates(problem, given);
    const std::vector<std::uint32_t> first{placement.team_candidates.front()};
    const oracle::Scores exact = oracle::scores(problem, list, {first.front()});
    if (exact.closest_call.distance < 1e-3) continue;
    const auto scores_of = [&](const PolygonWithHoles& object) {
      return scores(object, placement.centre_of_mass, placement.candidates, first, Metric::area);
    };
    const std::vector<double> mine = scores_of(placement.object);
    const std::vector<double> of_outline = scores_of(PolygonWithHoles(placement.polygon()));
    const double size = placement.polygon().diameter();
    INFO("case " << number);
    REQUIRE(mine.size() == exact.values.size());
    for (std::size_t i = 0; i < mine.size(); ++i) {
      CHECK(mine[i] == Approx(exact.values[i]).margin(1e-12 * size * size));
      less += mine[i] < of_outline[i] - 1e-9 * size * size;
    }
    ++(placement.polygon().convex() ? convex : reflex);
  }
  CHECK(convex > 60);
  CHECK(reflex > 100);
  CHECK(less > 500);
}

TEST_CASE("bounds of the metric area find the greatest score in spite of holes",
          "[holes][selection][slow]") {
  int compared = 0;
  for (const Family family : {Family::star, Family::convex, Family::random, Family::comb})
    for (std::uint64_t seed = 0; seed < 4; ++seed) {
      const PolygonWithHoles object = generated(family, 150, seed, 30);
      Document document = document_of(object, Method::area);
      document.settings.teams = 6;
      document.settings.min_ratio = 0.6;
      const Placement p = placed(document);
      const double tie = 1e-9 * object.outline().diameter() * object.outline().diameter();
      for (std::size_t i = 1; i < p.team_candidates.size(); ++i) {
        const std::vector<std::uint32_t> before(
            p.team_candidates.begin(), p.team_candidates.begin() + static_cast<std::ptrdiff_t>(i));
        const auto all = scores(object, p.centre_of_mass, p.candidates, before, Metric::area);
        CHECK(all[p.team_candidates[i]] >= *std::max_element(all.begin(), all.end()) - tie);
        ++compared;
      }
    }
  CHECK(compared > 40);
}

TEST_CASE("every method reports the coverage without the holes", "[holes][oracle][slow]") {
  int placements = 0;
  for (const Family family : all_families)
    for (std::uint64_t seed = 0; seed < 3; ++seed) {
      const PolygonWithHoles object = generated(family, 12 + 6 * seed, seed, 4 + 8 * seed);
      const oracle::Problem problem = problem_of(object);
      for (const Method method : all_methods)
        for (const Goal goal : all_goals) {
          if (goal == Goal::hold && (method == Method::distributed || method == Method::random))
            continue;
          Document document = document_of(object, method);
          document.settings.goal = goal;
          const Placement p = placed(document);
          INFO(name(family) << " " << seed << " by " << name(method));
          CHECK(p.coverage == Approx(exact_coverage(problem, p.lifting_base)).margin(1e-11));
          placements += p.lifting_base.size() > 2;
          if (p.team_candidates.empty() ||
              !well_inside(p.lifting_base, p.centre_of_mass, p.polygon().diameter()))
            continue;
          const HoldKeys keys = hold_keys(p.object, p.centre_of_mass, p.candidates,
                                          p.team_candidates, hold_requirements(p));
          CHECK(keys.coverage == Approx(p.coverage).margin(1e-11));
        }
    }
  CHECK(placements > 100);
}

TEST_CASE("the widest choice among holes is that of brute force", "[holes][optimum][slow]") {
  int compared = 0;
  for (std::uint64_t number = 0; number < 500 && compared < 120; ++number) {
    oracle::Problem problem = holed_polygons::make_case(number).problem;
    problem.min_ratio = 0.7;
    problem.teams = static_cast<int>(1 + number % 3);
    const Placement p = placed(document_of(problem));
    const std::size_t all = p.candidates.size(), teams = p.teams.size();
    if (teams < p.requested_teams || teams == 0 || all > (teams < 3 ? 12u : 8u)) continue;
    double widest = 0;
    for (std::uint32_t taken = 0; taken < 1u << all; ++taken) {
      Points ends;
      for (std::size_t i = 0; i < all; ++i)
        if ((taken >> i & 1) != 0)
          for (const LiftingPoint& end : {p.candidates[i].chord.r1, p.candidates[i].chord.r2})
            ends.push_back(end.position);
      if (ends.size() == 2 * teams)
        widest = std::max(widest, exact_coverage(problem, hull_of(p.polygon(), ends)));
    }
    const Optimum optimum =
        widest_choice(p.object, p.centre_of_mass, p.candidates, teams, p.team_candidates);
    INFO("case " << number);
    CHECK(optimum.proved);
    CHECK(optimum.coverage == Approx(widest).margin(1e-9));
    CHECK(optimum.bound >= widest - 1e-9);
    ++compared;
  }
  CHECK(compared >= 60);
}

TEST_CASE("after a failure the rest covers what it covers without the holes",
          "[holes][failures][slow]") {
  int compared = 0;
  for (std::uint64_t number = 0; number < 200; ++number) {
    const oracle::Problem problem = holed_polygons::make_case(number).problem;
    const Placement p = placed(document_of(problem));
    const auto failures = single_failures(p);
    for (std::size_t robot = 0; robot < failures.size(); ++robot) {
      if (!failures[robot]) continue;
      Points rest = positions(lifting_points(p.teams));
      rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(robot));
      const double exact = exact_coverage(problem, hull_of(p.polygon(), rest));
      INFO("case " << number << ", robot " << robot);
      CHECK(failures[robot]->coverage == Approx(exact).margin(10 * rounding_of(p.object)));
      compared += exact > 0;
    }
  }
  CHECK(compared > 200);
}
