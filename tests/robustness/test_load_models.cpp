// The loads by each model, against linear programs and least squares in exact arithmetic, and by
// their defining conditions.
#include "evenlift/load_models.h"

#include <algorithm>
#include <cmath>

#include "evenlift/angles.h"
#include "evenlift/failures.h"
#include "evenlift/hull.h"
#include "kit/catch.h"
#include "oracle/rational.h"
#include "oracle/vec.h"
#include "robustness/robot_sets.h"
#include "robustness/simplex.h"
#include "robustness/support.h"

using namespace evenlift;
using Exact = oracle::Rational;
using ExactVec = oracle::Vec<Exact>;
using robot_sets::RobotSet;

namespace {

std::optional<SpringLoads> springs(const RobotSet& set, double weight = 1) {
  return spring_loads(set.robots, set.centre, set.diameter, weight);
}
std::optional<double> best(const RobotSet& set, double weight = 1) {
  return best_load(set.robots, set.centre, set.diameter, weight);
}
std::optional<std::vector<double>> worst(const RobotSet& set, double weight = 1) {
  return worst_loads(set.robots, set.centre, set.diameter, weight);
}

RobotSet by_hand(Points robots, const Vec2& centre) {
  return {"by hand", std::move(robots), centre, 10};
}

double greatest(const std::vector<double>& loads) {
  return *std::max_element(loads.begin(), loads.end());
}

// Robots at whole coordinates, often collinear or at one place, and C anywhere on the grid; or a
// set with C well inside.
RobotSet small_set(std::uint64_t number) {
  if (number % 3 == 0) return robot_sets::make_steady_set(number, 4);
  return robot_sets::make_grid(number, 7);
}

std::vector<ExactVec> seen(const RobotSet& set) {
  std::vector<ExactVec> robots;
  for (const Vec2& p : set.robots)
    robots.push_back({Exact(p.x) - Exact(set.centre.x), Exact(p.y) - Exact(set.centre.y)});
  return robots;
}

// For a weight of 1, with room for more variables.
std::vector<simplex::Row> equilibrium(const std::vector<ExactVec>& robots, std::size_t variables) {
  std::vector<simplex::Row> rows(3, simplex::Row(variables, 0));
  for (std::size_t i = 0; i < robots.size(); ++i) {
    rows[0][i] = 1;
    rows[1][i] = robots[i].x;
    rows[2][i] = robots[i].y;
  }
  return rows;
}

std::optional<double> exact_best(const RobotSet& set) {
  const std::vector<ExactVec> robots = seen(set);
  const std::size_t m = robots.size();
  // The variables: the loads, their differences from the greatest, and the greatest.
  std::vector<simplex::Row> rows = equilibrium(robots, 2 * m + 1);
  simplex::Row right{1, 0, 0}, cost(2 * m + 1, 0);
  for (std::size_t i = 0; i < m; ++i) {
    simplex::Row row(2 * m + 1, 0);
    row[i] = row[m + i] = 1;
    row[2 * m] = -1;
    rows.push_back(row);
    right.push_back(0);
  }
  cost[2 * m] = 1;
  const auto value = simplex::least(rows, right, cost);
  if (!value) return std::nullopt;
  return static_cast<double>(*value);
}

std::optional<double> exact_worst(const RobotSet& set, std::size_t robot) {
  const std::vector<ExactVec> robots = seen(set);
  simplex::Row cost(robots.size(), 0);
  cost[robot] = -1;
  const auto value = simplex::least(equilibrium(robots, robots.size()), {1, 0, 0}, cost);
  if (!value) return std::nullopt;
  return static_cast<double>(-*value);
}

// With the least sum of squares for a weight of 1 on a subset alone, if possible; some may pull.
// Dependent equations are eliminated.
std::optional<std::vector<Exact>> least_squares(const std::vector<ExactVec>& robots,
                                                std::uint32_t subset) {
  std::vector<simplex::Row> rows = equilibrium(robots, robots.size());
  for (simplex::Row& row : rows) {
    for (std::size_t i = 0; i < robots.size(); ++i)
      if ((subset >> i & 1) == 0) row[i] = 0;
  }
  rows[0].push_back(1);
  rows[1].push_back(0);
  rows[2].push_back(0);
  // Makes the rows orthogonal, so that each contributes separately.
  const std::size_t m = robots.size();
  const auto product = [&](const simplex::Row& a, const simplex::Row& b) {
    Exact sum = 0;
    for (std::size_t i = 0; i < m; ++i) sum += a[i] * b[i];
    return sum;
  };
  std::vector<Exact> loads(m, 0);
  for (std::size_t r = 0; r < rows.size(); ++r) {
    for (std::size_t s = 0; s < r; ++s) {
      const Exact square = product(rows[s], rows[s]);
      if (square == 0) continue;
      const Exact factor = product(rows[r], rows[s]) / square;
      for (std::size_t i = 0; i <= m; ++i) rows[r][i] -= factor * rows[s][i];
    }
    const Exact square = product(rows[r], rows[r]);
    if (square == 0) {
      if (rows[r][m] != 0) return std::nullopt;
      continue;
    }
    for (std::size_t i = 0; i < m; ++i) loads[i] += rows[r][i] * (rows[r][m] / square);
  }
  return loads;
}

// The least sum of squares over all subsets that balance the weight by pushing.
std::optional<std::vector<double>> exact_springs(const RobotSet& set) {
  const std::vector<ExactVec> robots = seen(set);
  std::optional<std::vector<Exact>> best;
  Exact least = 0;
  for (std::uint32_t subset = 1; subset < 1u << robots.size(); ++subset) {
    const auto loads = least_squares(robots, subset);
    if (!loads || *std::min_element(loads->begin(), loads->end()) < 0) continue;
    Exact squares = 0;
    for (const Exact& load : *loads) squares += load * load;
    if (best && squares >= least) continue;
    best = loads;
    least = squares;
  }
  if (!best) return std::nullopt;
  std::vector<double> loads;
  for (const Exact& load : *best) loads.push_back(static_cast<double>(load));
  return loads;
}

// About C, in units of L.
double moment(const RobotSet& set, const std::vector<double>& loads) {
  Vec2 sum;
  for (std::size_t i = 0; i < loads.size(); ++i)
    sum += loads[i] * (set.robots[i] - set.centre) / set.diameter;
  return length(sum);
}

}  // namespace

TEST_CASE("the loads of springs balance the weight, whatever the robots", "[robustness][models]") {
  int carried = 0;
  for (std::uint64_t number = 0; number < 6000; ++number) {
    const RobotSet set = robot_sets::make_set(number, 30);
    const auto result = springs(set, 48);
    INFO(number << ", " << set.kind << ", " << set.robots.size() << " robots");
    CHECK(result.has_value() == (failures_carried(set.robots, set.centre, set.diameter) >= 0));
    if (!result) continue;
    ++carried;
    double sum = 0;
    for (const double load : result->loads) {
      sum += load;
      CHECK(load >= 0);
    }
    CHECK(std::fabs(sum - 48) <= 1e-9 * 48);
    CHECK(moment(set, result->loads) <= 1e-9 * 48);
  }
  CHECK(carried > 4000);
}

TEST_CASE("the loads of springs have the least sum of squares of all that push",
          "[robustness][models][thorough]") {
  int let_go = 0;
  for (std::uint64_t number = 0; number < 1500; ++number) {
    const RobotSet set = small_set(number);
    const auto expected = exact_springs(set);
    const auto result = springs(set);
    INFO(number << ", " << set.kind << ", " << set.robots.size() << " robots");
    REQUIRE(result.has_value() == expected.has_value());
    if (!result) continue;
    for (std::size_t i = 0; i < set.robots.size(); ++i)
      CHECK(std::fabs(result->loads[i] - (*expected)[i]) <= 1e-9);
    let_go += *std::min_element(expected->begin(), expected->end()) == 0;
  }
  CHECK(let_go > 200);
}

TEST_CASE("equally stiff robots whose centroid is the centre of mass share evenly",
          "[robustness][models]") {
  const auto result = springs(by_hand({{3, 1}, {-2, 3}, {-4, -3}, {1, -2}, {2, 1}}, {0, 0}), 50);
  REQUIRE(result);
  for (const double load : result->loads) CHECK(load == Approx(10).epsilon(1e-14));
}

TEST_CASE("a spring that would have to pull lets go", "[robustness][models]") {
  // C is above the left end; the far right robot would pull.
  const auto result = springs(by_hand({{-1, 0}, {1, 0}, {10, 0}}, {-0.5, 0}), 4);
  REQUIRE(result);
  CHECK(result->loads[0] == Approx(3));
  CHECK(result->loads[1] == Approx(1));
  CHECK(result->loads[2] == 0);
  CHECK(result->per_length[2] == 0);
}

TEST_CASE("loads change in proportion until a spring that is free takes hold",
          "[robustness][models]") {
  // The third robot takes a load when C is 0.45 farther right. The second goes slack when C is 0.5
  // farther left.
  const auto result = springs(by_hand({{-1, 0}, {1, 0}, {20, 0}}, {-0.5, 0}));
  REQUIRE(result);
  CHECK(result->loads[2] == 0);
  CHECK(result->same_within == Approx(0.45));
}

TEST_CASE("the least possible greatest load is that of the linear program",
          "[robustness][models][slow]") {
  int uneven = 0;
  for (std::uint64_t number = 0; number < 900; ++number) {
    const RobotSet set = small_set(number);
    const auto expected = exact_best(set);
    const auto result = best(set);
    INFO(number << ", " << set.kind << ", " << set.robots.size() << " robots");
    REQUIRE(result.has_value() == expected.has_value());
    if (!result) continue;
    CHECK(std::fabs(*result - *expected) <= 1e-9);
    uneven += *result * static_cast<double>(set.robots.size()) > 1.01;
  }
  CHECK(uneven > 300);
}

TEST_CASE("the greatest load that a robot can come to carry is that of the linear program",
          "[robustness][models][slow]") {
  int carried = 0;
  for (std::uint64_t number = 0; number < 400; ++number) {
    const RobotSet set = small_set(number);
    const auto result = worst(set);
    carried += result.has_value();
    INFO(number << ", " << set.kind << ", " << set.robots.size() << " robots");
    for (std::size_t i = 0; i < set.robots.size(); ++i) {
      const auto expected = exact_worst(set, i);
      REQUIRE(result.has_value() == expected.has_value());
      if (result) CHECK(std::fabs((*result)[i] - *expected) <= 1e-9);
    }
  }
  CHECK(carried > 100);
}

TEST_CASE("cutting planes find the same least greatest load as all pairs of robots",
          "[robustness][models][slow]") {
  for (std::uint64_t number = 0; number < 400; ++number) {
    RobotSet set = robot_sets::make_steady_set(number, 120);
    INFO(number << ", " << set.kind << ", " << set.robots.size() << " robots");
    if (number % 5 == 0)  // long and thin
      for (Vec2& p : set.robots) p.y = set.centre.y + 1e-6 * (p.y - set.centre.y);
    Points at;
    for (const Vec2& p : set.robots) at.push_back(p - set.centre);
    const double by_pairs = best_share_by_pairs(at);
    CHECK(best_share_by_cuts(at, convex_hull(at)) == Approx(by_pairs).epsilon(1e-11));
  }
}

TEST_CASE("no model has less than the best, and no robot carries more than its worst",
          "[robustness][models]") {
  for (std::uint64_t number = 0; number < 3000; ++number) {
    const RobotSet set = robot_sets::make_set(number, 40);
    const auto by_springs = springs(set);
    const auto at_best = best(set);
    const auto at_worst = worst(set);
    INFO(number << ", " << set.kind << ", " << set.robots.size() << " robots");
    REQUIRE(at_best.has_value() == by_springs.has_value());
    REQUIRE(at_worst.has_value() == by_springs.has_value());
    if (!by_springs) continue;
    CHECK(*at_best >= 1.0 / static_cast<double>(set.robots.size()));
    CHECK(greatest(by_springs->loads) >= *at_best - 1e-9);
    CHECK(*at_best <= 1);
    for (std::size_t i = 0; i < set.robots.size(); ++i) {
      CHECK((*at_worst)[i] >= by_springs->loads[i] - 1e-9);
      CHECK((*at_worst)[i] <= 1);
    }
  }
}

TEST_CASE("loads balance the weight however near C is to an edge", "[robustness][models][slow]") {
  int within = 0;
  for (std::uint64_t number = 0; number < 3000; ++number) {
    const RobotSet set = robot_sets::make_near_edge(number, number % 2 == 0 ? 10 : 150);
    const auto by_springs = springs(set);
    INFO(number << ", " << set.kind << ", " << set.robots.size() << " robots");
    if (!by_springs) continue;  // beyond another edge of a thin set
    ++within;
    double sum = 0;
    for (const double load : by_springs->loads) sum += load;
    CHECK(std::fabs(sum - 1) <= 1e-9);
    CHECK(moment(set, by_springs->loads) <= 2e-9);  // C may be off by the tolerance
    CHECK(greatest(by_springs->loads) >= *best(set) - 1e-9);
    const auto at_worst = worst(set);
    REQUIRE(at_worst);
    for (std::size_t i = 0; i < set.robots.size(); ++i)
      CHECK((*at_worst)[i] >= by_springs->loads[i] - 1e-9);
  }
  CHECK(within > 2500);
}

TEST_CASE("two robots carry by the lever in every model", "[robustness][models]") {
  const RobotSet set = by_hand({{-1, -1}, {3, 3}}, {0, 0});
  CHECK(springs(set, 100)->loads[0] == Approx(75));
  CHECK(springs(set, 100)->loads[1] == Approx(25));
  CHECK(*best(set, 100) == Approx(75));
  CHECK((*worst(set, 100))[0] == Approx(75));
  CHECK((*worst(set, 100))[1] == Approx(25));
  // C moves 4 of the 4 sqrt 2 from one robot to the other.
  CHECK(springs(set, 100)->per_length[0] == Approx(100 / std::sqrt(32)));
  CHECK(springs(set, 100)->same_within == Approx(std::sqrt(2)));
}

TEST_CASE("two robots carry what lies within tolerance beyond the line between them",
          "[robustness][models]") {
  const auto carried = [](const Vec2& centre) {
    const RobotSet set{"by hand", {{0, 0}, {1, 0}}, centre, 1};
    CHECK(springs(set).has_value() == best(set).has_value());
    CHECK(worst(set).has_value() == best(set).has_value());
    return best(set).has_value();
  };
  const double within = 5e-10, beyond = 2e-9;
  CHECK(carried({-within, 0}));
  CHECK(carried({1 + within, 0}));
  CHECK(carried({0.5, within}));
  CHECK_FALSE(carried({-beyond, 0}));
  CHECK_FALSE(carried({1 + beyond, 0}));
  CHECK_FALSE(carried({0.5, beyond}));
}

TEST_CASE("robots beside the line on which the centre of mass lies carry nothing",
          "[robustness][models]") {
  // C is between the first two, on the edge of H.
  const RobotSet set = by_hand({{-1, 0}, {3, 0}, {0, 5}, {1, 2}}, {0, 0});
  for (const auto& loads : {springs(set, 4)->loads, *worst(set, 4)}) {
    CHECK(loads[0] == Approx(3));
    CHECK(loads[1] == Approx(1));
    CHECK(loads[2] == 0);
    CHECK(loads[3] == 0);
  }
  CHECK(*best(set, 4) == Approx(3));
  // C is at a corner of H, where two robots stand.
  const RobotSet corner = by_hand({{0, 0}, {0, 0}, {3, 0}, {0, 5}}, {0, 0});
  const std::vector<double> loads = springs(corner, 4)->loads;
  CHECK(loads[0] == Approx(2));
  CHECK(loads[1] == Approx(2));
  CHECK(loads[2] + loads[3] == 0);
  CHECK(*best(corner, 4) == 2);
  CHECK(*worst(corner, 4) == std::vector<double>{4, 4, 0, 0});
  CHECK(springs(corner, 4)->same_within == 0);
}

TEST_CASE("without robots below the centre of mass no robot carries anything",
          "[robustness][models]") {
  for (const RobotSet& set : {by_hand({}, {0, 0}), by_hand({{1, 0}}, {0, 0}),
                              by_hand({{1, 0}, {2, 0}, {1, 1}}, {0, 0})}) {
    CHECK_FALSE(springs(set));
    CHECK_FALSE(best(set));
    CHECK_FALSE(worst(set));
  }
  const RobotSet one_leg = by_hand({{1, 0}}, {1, 0});
  CHECK(springs(one_leg, 7)->loads == std::vector<double>{7});
  CHECK(*best(one_leg, 7) == 7);
  CHECK(*worst(one_leg, 7) == std::vector<double>{7});
}

TEST_CASE("loads stay when the robots are turned, moved and scaled", "[robustness][models][slow]") {
  for (std::uint64_t number = 0; number < 1500; ++number) {
    const RobotSet set = number % 2 == 0 ? robot_sets::make_steady_set(number, 90)
                                         : robot_sets::make_pairs(number, 1 + number % 9);
    const RobotSet copy = robot_sets::moved(set, number);
    INFO(number << ", " << set.kind << ", " << set.robots.size() << " robots");
    const auto a = springs(set), b = springs(copy);
    const auto worst_a = worst(set), worst_b = worst(copy);
    REQUIRE((a && b && worst_a && worst_b));
    CHECK(*best(set) == Approx(*best(copy)).margin(1e-9));
    for (std::size_t i = 0; i < set.robots.size(); ++i) {
      CHECK(a->loads[i] == Approx(b->loads[i]).margin(1e-9));
      CHECK((*worst_a)[i] == Approx((*worst_b)[i]).margin(1e-9));
    }
  }
}

TEST_CASE("loads change at most as said for each length that the centre of mass moves",
          "[robustness][models]") {
  constexpr int directions = 64;
  int moved = 0;
  for (std::uint64_t number = 0; number < 500; ++number) {
    const RobotSet set = robot_sets::make_steady_set(number, 12);
    const auto at_rest = springs(set);
    REQUIRE(at_rest);
    const double distance = 0.99 * at_rest->same_within;
    if (distance < 1e-4 * set.diameter) continue;
    ++moved;
    INFO(number << ", " << set.kind << ", " << set.robots.size() << " robots");
    std::vector<double> most(set.robots.size(), 0);
    for (int k = 0; k < directions; ++k) {
      const double angle = 2 * pi * k / directions;
      RobotSet copy = set;
      copy.centre += distance * Vec2(cosine(angle), sine(angle));
      const auto there = springs(copy);
      REQUIRE(there);
      for (std::size_t i = 0; i < most.size(); ++i) {
        CHECK((there->loads[i] > 0) == (at_rest->loads[i] > 0));
        most[i] = std::max(most[i], std::fabs(there->loads[i] - at_rest->loads[i]));
      }
    }
    for (std::size_t i = 0; i < most.size(); ++i) {
      const double said = distance * at_rest->per_length[i];
      CHECK(most[i] <= said + 1e-9);
      CHECK(most[i] >= said * cosine(pi / directions) - 1e-9);
    }
  }
  CHECK(moved > 300);
}

TEST_CASE("load models have names", "[robustness][models]") {
  for (const LoadModel model : all_load_models)
    CHECK(load_model_from_name(evenlift::name(model)) == model);
  CHECK_FALSE(load_model_from_name("Springs"));
  CHECK_FALSE(load_model_from_name(""));
}
