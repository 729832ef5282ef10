// The oracle, used in test_core_against_oracle.cpp, against cases solved by hand.
#include "kit/catch.h"
#include "oracle/oracle.h"

#include <algorithm>
#include <cmath>

using namespace oracle;

namespace {

struct Answer {
  CandidateList list;
  Selection selection;
  Judgement judgement;
};

Answer solve(const Problem& problem) {
  Answer a;
  a.list = find_candidates(problem);
  a.selection = select(problem, a.list);
  a.judgement = judge(problem, a.list, a.selection.teams);
  return a;
}

/// On chords given by hand, all of which are teams.
Judgement judge_all(const Problem& problem, const std::vector<std::array<Point, 2>>& chords) {
  std::vector<Candidate> given;
  std::vector<std::size_t> teams;
  for (const auto& ends : chords) {
    given.push_back({.ends = ends, .ratio = 1, .kind = Kind::midpoint});
    teams.push_back(teams.size());
  }
  return judge(problem, given_candidates(problem, given), teams);
}

bool has_ends(const Candidate& c, const Point& p, const Point& q) {
  return (c.ends[0] == p && c.ends[1] == q) || (c.ends[0] == q && c.ends[1] == p);
}

const std::vector<Point> square{{0, 0}, {2, 0}, {2, 2}, {0, 2}};
const std::vector<Point> right_triangle{{0, 0}, {3, 0}, {0, 3}};
const std::vector<Point> thesis_sample{{539, 220}, {403, 115}, {386, 219}, {278, 306},
                                       {149, 187}, {263, 124}, {88, 101},  {82, 320},
                                       {133, 437}, {546, 446}, {665, 426}};

}  // namespace

TEST_CASE("the oracle finds the square's diagonals, midpoint chords and second-order hold",
          "[oracle]") {
  const Answer a = solve({.vertices = square, .teams = 4});
  REQUIRE(a.list.candidates.size() == 4);
  CHECK(has_ends(a.list.candidates[0], {0, 2}, {2, 0}));
  CHECK(has_ends(a.list.candidates[1], {0, 1}, {2, 1}));
  CHECK(has_ends(a.list.candidates[2], {0, 0}, {2, 2}));
  CHECK(has_ends(a.list.candidates[3], {1, 0}, {1, 2}));  // the vertical one is last
  CHECK(a.list.candidates[0].kind == Kind::bisecting);
  CHECK(a.list.candidates[1].kind == Kind::midpoint);
  CHECK(a.selection.teams == std::vector<std::size_t>{0, 2, 1, 3});
  CHECK(a.selection.scores[1] == 4);
  CHECK(a.judgement.hull.size() == 4);
  CHECK(a.judgement.coverage == 1);
  REQUIRE(a.judgement.loads);
  CHECK(a.judgement.loads->max == 12.5);
  CHECK(a.judgement.loads->spread == 0);
  const Closure& c = a.judgement.closure;
  CHECK(c.contacts == 4);
  CHECK(c.clockwise);
  CHECK(c.counterclockwise);
  CHECK_FALSE(c.translation);
  CHECK_FALSE(c.form_closure);
  CHECK(c.second_order);
  CHECK(std::fabs(*c.margin) < 1e-30);
}

TEST_CASE(
    "the oracle finds the chords that a triangle's centroid bisects, and scores them by each "
    "metric",
    "[oracle]") {
  const CandidateList list = find_candidates({.vertices = right_triangle});
  REQUIRE(list.candidates.size() == 3);
  CHECK(has_ends(list.candidates[0], {2, 0}, {0, 2}));
  CHECK(has_ends(list.candidates[1], {0, 1}, {2, 1}));
  CHECK(has_ends(list.candidates[2], {1, 0}, {1, 2}));
  for (const Candidate& c : list.candidates) CHECK((c.kind == Kind::bisecting && c.ratio == 1));

  const auto second_score = [&](Metric metric) {
    const Selection s = select({.vertices = right_triangle, .metric = metric}, list);
    CHECK(s.teams ==
          std::vector<std::size_t>{0, 1, 2});  // the longest, then a tie that order decides
    return s.scores[1];
  };
  CHECK(second_score(Metric::area) == 2);
  // Two triangles of area 1 with sides 1, sqrt(5), sqrt(8).
  const double radius = 2 / (1 + std::sqrt(5.0) + std::sqrt(8.0));
  CHECK(second_score(Metric::circle) ==
        Approx(2 * std::acos(-1.0) * radius * radius).epsilon(1e-13));
  // (0,0) gains sqrt(2) - 2/sqrt(5); (3,0) and (0,3) lose by longer arms about the new edges.
  const double half = std::sqrt(0.5), fifth = 2 / std::sqrt(5.0);
  CHECK(second_score(Metric::distance) ==
        Approx(std::sqrt(2.0) - fifth + (half - 1) + (half - fifth)).epsilon(1e-13));

  CHECK(solve({.vertices = right_triangle}).judgement.coverage == Approx(2.0 / 3).epsilon(1e-15));
}

TEST_CASE("the oracle follows the three cases of a pair", "[oracle]") {
  const std::vector<Point> rectangle{{-4, -2}, {5, -2}, {5, 3}, {-4, 3}};
  const CandidateList list =
      find_candidates({.vertices = rectangle, .centre_of_mass = Point{0, 0}, .min_ratio = 0.5});
  REQUIRE(list.candidates.size() == 4);
  const auto is = [&](std::size_t i, const Point& p, const Point& q, Kind kind, double ratio) {
    const Candidate& c = list.candidates[i];
    return has_ends(c, p, q) && c.kind == kind && c.ratio == ratio;
  };
  CHECK(is(0, {4, -2}, {-4, 2}, Kind::bisecting, 1));        // base and left: g from 3/2 to 4/5
  CHECK(is(1, {5, 0.25}, {-4, -0.2}, Kind::midpoint, 0.8));  // left and right: g is 4/5 throughout
  CHECK(is(2, {-4, -2}, {5, 2.5}, Kind::vertex, 0.8));       // base and right: g from 5/4 to 3/2
  CHECK(is(3, {-1.0 / 3, -2}, {0.5, 3}, Kind::midpoint,
           2.0 / 3));  // base and top: g is 3/2 throughout
}

TEST_CASE("a section end that C bisects exactly is a bisecting chord in the oracle", "[oracle]") {
  const std::vector<Point> rectangle{{-4, -2}, {4, -2}, {4, 3}, {-4, 3}};
  const CandidateList list =
      find_candidates({.vertices = rectangle, .centre_of_mass = Point{0, 0}, .min_ratio = 0.9});
  REQUIRE(list.candidates.size() == 3);
  CHECK((has_ends(list.candidates[0], {4, -2}, {-4, 2}) &&
         list.candidates[0].kind == Kind::bisecting));
  CHECK(
      (has_ends(list.candidates[1], {4, 0}, {-4, 0}) && list.candidates[1].kind == Kind::midpoint));
  CHECK((has_ends(list.candidates[2], {4, 2}, {-4, -2}) &&
         list.candidates[2].kind == Kind::bisecting));
}

TEST_CASE("the oracle agrees with what is known of the thesis's sample", "[oracle]") {
  const Answer offset = solve({.vertices = thesis_sample, .centre_of_mass = Point{278, 227}});
  CHECK(offset.list.candidates.size() == 3);
  CHECK(offset.judgement.coverage == Approx(0.082).margin(0.0005));
  CHECK_FALSE(offset.judgement.closure.form_closure);

  const Answer even = solve({.vertices = thesis_sample});
  CHECK(even.list.candidates.size() == 9);
  CHECK(even.selection.teams.size() == 3);
  CHECK(even.judgement.coverage == Approx(0.80).margin(0.01));
}

TEST_CASE("the midpoints of an equilateral triangle hold it to second order in the oracle",
          "[oracle]") {
  const double h = std::sqrt(3.0);
  const std::vector<Point> triangle{{-1, 0}, {1, 0}, {0, h}};
  const Judgement j = judge_all({.vertices = triangle}, {{Point{0, 0}, Point{0, h}},
                                                         {Point{0.5, h / 2}, Point{-1, 0}},
                                                         {Point{-0.5, h / 2}, Point{1, 0}}});
  CHECK(j.closure.contacts == 3);
  CHECK(j.closure.clockwise);
  CHECK(j.closure.counterclockwise);
  CHECK_FALSE(j.closure.translation);
  CHECK_FALSE(j.closure.form_closure);
  CHECK(j.closure.second_order);
  CHECK(j.closure.margin.value() == Approx(0).margin(1e-15));
}

TEST_CASE("a rectangle held on two parallel sides slides in the oracle", "[oracle]") {
  const std::vector<Point> rectangle{{0, 0}, {4, 0}, {4, 2}, {0, 2}};
  const Judgement j =
      judge_all({.vertices = rectangle}, {{Point{1, 0}, Point{3, 2}}, {Point{3, 0}, Point{1, 2}}});
  CHECK_FALSE(j.closure.clockwise);
  CHECK_FALSE(j.closure.counterclockwise);
  CHECK(j.closure.translation);
  CHECK_FALSE(j.closure.form_closure);
  CHECK_FALSE(j.closure.second_order);
  CHECK(j.closure.margin.value() == Approx(0).margin(1e-15));
}

TEST_CASE("two pinwheels hold a square in form closure in the oracle, one alone does not",
          "[oracle]") {
  const std::array<Point, 2> a{Point{0.5, 0}, Point{1.5, 2}}, b{Point{2, 0.5}, Point{0, 1.5}};
  const std::array<Point, 2> c{Point{1.5, 0}, Point{0.5, 2}}, d{Point{2, 1.5}, Point{0, 0.5}};
  const Closure one = judge_all({.vertices = square}, {a, b}).closure;
  CHECK(one.clockwise);
  CHECK_FALSE(one.counterclockwise);
  CHECK_FALSE(one.second_order);
  // All wrenches have the torque -0.5 / sqrt(2): the hull misses the origin by that.
  CHECK(one.margin.value() == Approx(-0.5 / std::sqrt(2.0)).epsilon(1e-14));
  const Closure both = judge_all({.vertices = square}, {a, b, c, d}).closure;
  CHECK(both.form_closure);
  CHECK_FALSE(both.second_order);
  CHECK(both.margin.value() == Approx(0.5 / std::sqrt(2.0)).epsilon(1e-14));
}

TEST_CASE("everything is free in the oracle with no contact", "[oracle]") {
  const Closure none = judge_all({.vertices = square}, {}).closure;
  CHECK((none.clockwise && none.counterclockwise && none.translation && !none.margin));
  const Closure corners = judge_all({.vertices = square}, {{Point{0, 0}, Point{2, 2}}}).closure;
  CHECK(corners.contacts == 0);
  CHECK((corners.clockwise && corners.counterclockwise && corners.translation && !corners.margin));
}

TEST_CASE("the oracle names why it refuses a problem", "[oracle]") {
  const auto why = [](std::vector<Point> v) { return refusal({.vertices = std::move(v)}); };
  CHECK(why(square) == Refusal::none);
  CHECK(why({{0, 0}, {1, 0}}) == Refusal::too_few_vertices);
  CHECK(why({{0, 0}, {1e9, 0}, {0, 1.1e9}}) == Refusal::bad_coordinate);
  CHECK(why({{0, 0}, {1, 0}, {0, std::nan("")}}) == Refusal::bad_coordinate);
  CHECK(why({{0, 0}, {1, 0}, {0, 1}, {1, 0}}) == Refusal::repeated_vertex);
  CHECK(why({{0, 0}, {1, 1}, {3, 3}}) == Refusal::no_area);
  CHECK(why({{0, 0}, {2, 2}, {2, 0}, {0, 2}}) == Refusal::not_simple);  // crosses
  CHECK(why({{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}}) ==
        Refusal::not_simple);                                           // a vertex on an edge
  CHECK(why({{0, 0}, {4, 0}, {2, 0}, {2, 3}}) == Refusal::not_simple);  // folds back
  CHECK(why({{0, 0}, {7e-10, 0}, {7e-10, 7e-10}}) == Refusal::too_small);
  CHECK(why({{0, 0}, {8e-10, 0}, {8e-10, 8e-10}}) == Refusal::none);
  CHECK(refusal({.vertices = square, .centre_of_mass = Point{2, 1}}) == Refusal::centre_outside);
  CHECK(refusal({.vertices = square, .centre_of_mass = Point{1, 1}, .min_ratio = 1.01}) ==
        Refusal::bad_ratio);
  CHECK(refusal({.vertices = square, .teams = 0}) == Refusal::bad_teams);
}

TEST_CASE("the oracle lists a chord between two vertices once", "[oracle]") {
  CHECK(vertex_chords({.vertices = square}).size() == 2);
  CHECK(vertex_chords({.vertices = right_triangle}).size() == 3);
}

TEST_CASE("the oracle rounds the centroid to the nearest doubles", "[oracle]") {
  CHECK(centroid({{0, 0}, {1, 0}, {0, 1}}) == Point{1.0 / 3, 1.0 / 3});
  CHECK(centroid({{0, 0}, {0, 1}, {1, 0}}) == Point{1.0 / 3, 1.0 / 3});
  CHECK(centroid({{1e9, 0}, {1e9, 1}, {999999999, 0}}) == Point{999999999.0 + 2.0 / 3, 1.0 / 3});
  CHECK(centroid({{-0.1, -0.1}, {0.1, -0.1}, {0.1, 0.1}, {-0.1, 0.1}}) == Point{0, 0});
}
