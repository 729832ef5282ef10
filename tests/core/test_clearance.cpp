// Clearance and tolerance of a hold, by hand and by moving robots.
#include <cmath>
#include <limits>
#include <random>
#include <string>

#include "evenlift/closure.h"
#include "evenlift/placement.h"
#include "evenlift/tolerance.h"
#include "kit/catch.h"
#include "kit/corpus.h"
#include "kit/placed.h"
#include "kit/polygons.h"

using namespace evenlift;
using evenlift::testing::placed;
using evenlift::testing::polygon;
using evenlift::testing::square;
using evenlift::testing::u_shape;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

Points regular(int n) {
  Points vertices;
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * 3.14159265358979323846 * i / n;
    vertices.emplace_back(std::cos(angle), std::sin(angle));
  }
  return vertices;
}

// On a square of side 2, at these distances from the corners.
Closure of_pairs(const Polygon& p, double a, double b) {
  return analyse_closure(p, {1, 1},
                         {{Vec2(a, 0), 0},
                          {Vec2(2 - a, 0), 0},
                          {Vec2(2, b), 1},
                          {Vec2(2, 2 - b), 1},
                          {Vec2(a, 2), 2},
                          {Vec2(2 - a, 2), 2},
                          {Vec2(0, b), 3},
                          {Vec2(0, 2 - b), 3}});
}

}  // namespace

TEST_CASE("a contact's distance from the corners is that along its side, over straight vertices",
          "[closure][clearance]") {
  const auto distances = [](const Polygon& p, const LiftingPoint& at) {
    std::vector<double> all;
    for (const Contact& contact : contacts(p, {at})) all.push_back(contact.to_corner);
    return all;
  };
  CHECK(distances(polygon(square), {Vec2(0.5, 0), 0}) == std::vector{0.5});
  CHECK(distances(polygon(square), {Vec2(1.75, 0), 0}) == std::vector{0.25});
  // An extra vertex on the side changes nothing, even under the robot.
  const Polygon straight = polygon({{0, 0}, {1, 0}, {2, 0}, {2, 2}, {0, 2}});
  CHECK(distances(straight, {Vec2(0.75, 0), 0}) == std::vector{0.75});
  CHECK(distances(straight, {Vec2(1.75, 0), 1}) == std::vector{0.25});
  CHECK(distances(straight, {Vec2(1, 0), 0}) == std::vector{1.0});
  const Polygon clockwise = polygon({{0, 2}, {2, 2}, {2, 0}, {1, 0}, {0, 0}});
  CHECK(distances(clockwise, {Vec2(1.75, 0), 2}) == std::vector{0.25});
  // At a reflex vertex the notch keeps the robot; beside it only the edge's other end counts.
  CHECK(distances(polygon(u_shape), {Vec2(4, 2), 3}) == std::vector{infinity, infinity});
  CHECK(distances(polygon(u_shape), {Vec2(3, 2), 4}) == std::vector{infinity});
}

TEST_CASE("a contact as far from a corner as required counts, within the tolerance",
          "[closure][clearance]") {
  const Polygon p = polygon(square);
  const auto kept = [&](double clear) {
    return clear_contacts(p, contacts(p, {{Vec2(0.5, 0), 0}}), clear).size();
  };
  CHECK(kept(0.5) == 1);
  CHECK(kept(0.5 + 1e-9) == 1);  // tau L is 2.8e-9
  CHECK(kept(0.5 + 1e-8) == 0);
}

TEST_CASE("a flattened curve has no corners: only a turn of more than 15 degrees is one",
          "[polygon][clearance]") {
  for (const int n : {3, 4, 7, 23, 24, 25, 60}) {
    INFO(n);
    const Polygon p = polygon(regular(n));
    for (std::size_t v = 0; v < p.size(); ++v) CHECK(p.is_corner(v) == (n < 24));
  }
  const Polygon u = polygon(u_shape);
  for (std::size_t v = 0; v < u.size(); ++v) CHECK(u.is_corner(v) == (u.turn(v) == Turn::convex));
}

TEST_CASE("the clearance is the greatest distance from corners with which the rest still holds",
          "[closure][clearance]") {
  const Polygon p = polygon(square);
  // Without the robots 0.25 from corners, the object could slide along the two other sides.
  const Closure pairs = of_pairs(p, 0.25, 0.75);
  REQUIRE(pairs.form_closure);
  CHECK(pairs.clearance.distance == 0.25);
  REQUIRE(pairs.clearance.point);
  CHECK(*pairs.clearance.point % 4 < 2);
  // Robots may move until one reaches a corner.
  const double of_all = 0.25;
  CHECK(pairs.clearance.tolerance == Approx(of_all));
  // A ninth robot beside a corner neither reduces the margin nor is needed.
  const Closure more = analyse_closure(p, {1, 1},
                                       {{Vec2(0.25, 0), 0},
                                        {Vec2(1.75, 0), 0},
                                        {Vec2(2, 0.75), 1},
                                        {Vec2(2, 1.25), 1},
                                        {Vec2(0.25, 2), 2},
                                        {Vec2(1.75, 2), 2},
                                        {Vec2(0, 0.75), 3},
                                        {Vec2(0, 1.25), 3},
                                        {Vec2(0.001, 0), 0}});
  CHECK(more.clearance.distance == 0.25);
  CHECK(more.clearance.tolerance == Approx(of_all));
}

TEST_CASE("without form closure both are 0, and without corners the clearance is infinite",
          "[closure][clearance]") {
  const Closure open = analyse_closure(polygon(square), {1, 1}, {{Vec2(0.5, 0), 0}});
  CHECK(open.clearance.distance == 0);
  CHECK(open.clearance.tolerance == 0);
  CHECK_FALSE(open.clearance.point);

  Document document;
  document.vertices = regular(60);
  for (Vec2& v : document.vertices) v.x *= 2;  // a kind of ellipse, which can be held
  document.settings.method = Method::balanced;
  document.settings.robots = 4;
  const Placement placement = placed(document);
  REQUIRE(placement.closure.form_closure);
  CHECK(placement.closure.clearance.distance == infinity);
  CHECK_FALSE(placement.closure.clearance.point);
  // Past a vertex, a robot touches another side, but the outline turns little there.
  CHECK(placement.closure.clearance.tolerance > 0.02);
  CHECK(placement.closure.clearance.tolerance < 0.5);
  CHECK(hold_firmly(placement));
}

TEST_CASE("the tolerance is that of the moments, and of corners along the outline past bends",
          "[closure][clearance]") {
  const auto tolerance = [](const Points& vertices, const Vec2& centre,
                            const std::vector<LiftingPoint>& robots) {
    return analyse_closure(polygon(vertices), centre, robots).clearance.tolerance;
  };
  CHECK(tolerance({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {0.5, 0.5},
                  {{Vec2(0.7, 0), 0}, {Vec2(1, 0.3), 1}, {Vec2(0.3, 1), 2}, {Vec2(0, 0.7), 3}}) ==
        Approx(0.2).epsilon(1e-10));
  // The first robot is 1.5038 from its corner, across a bend of 5 degrees.
  const Points bent{{0, 0}, {100, 0}, {101, 0.0875}, {101, 60}, {0, 60}};
  CHECK(tolerance(bent, {50, 30},
                  {{Vec2(99.5, 0), 0}, {Vec2(101, 15), 2}, {Vec2(20, 60), 3}, {Vec2(0, 45), 4}}) ==
        Approx(0.5 + std::hypot(1, 0.0875)).epsilon(1e-10));
}

TEST_CASE("a hold by robots in notches alone is held however far off they are",
          "[closure][clearance]") {
  // A square with a notch in the middle of each side.
  const Points notched{{0, 0},   {4, 0},  {5, 1}, {6, 0},  {10, 0}, {10, 4}, {9, 5}, {10, 6},
                       {10, 10}, {6, 10}, {5, 9}, {4, 10}, {0, 10}, {0, 6},  {1, 5}, {0, 4}};
  const Closure held = analyse_closure(polygon(notched), {5, 5},
                                       {{Vec2(5, 1), 2}, {Vec2(9, 5), 6}, {Vec2(5, 9), 10}});
  REQUIRE(held.form_closure);
  CHECK(held.clearance.distance == infinity);
  CHECK(held.clearance.tolerance == infinity);
}

TEST_CASE("a hold by a hair is form closure, but none that reaches its goal",
          "[closure][clearance]") {
  const Polygon p = polygon(square);
  const Closure hair = of_pairs(p, 1e-7, 1);
  CHECK(hair.form_closure);
  CHECK(hair.clearance.distance == Approx(1e-7).margin(1e-15));
  CHECK(hair.clearance.tolerance <= 1e-7);
  CHECK_FALSE(is_firm(p, hair.clearance, HoldRequirements{0.05, 0.02, 0.01}));
  CHECK(is_firm(p, hair.clearance, {0.05, 0, 0}));
}

namespace {

// Along the outline, past the ends of its edge, but stops in front of a notch.
LiftingPoint moved_along(const Polygon& p, LiftingPoint robot, double way) {
  const double inside = 1e-7 * p.diameter();
  while (true) {
    const bool ahead = way > 0;
    const std::size_t end = ahead ? p.next(robot.edge) : robot.edge;
    const Vec2 &at = robot.position, &to = p.vertex(end);
    const double left = length(to - at), wanted = std::fabs(way);
    const bool notch = p.is_notch(end);
    if (wanted <= left - (notch ? inside : 0) || notch) {
      const double step = std::min(wanted, std::max(0.0, left - (notch ? inside : 0)));
      return {step > 0 ? Vec2(at + (step / left) * (to - at)) : at, robot.edge};
    }
    way = ahead ? wanted - left : left - wanted;
    robot.position = to;
    robot.edge = static_cast<std::uint32_t>(ahead ? p.next(robot.edge) : p.previous(robot.edge));
  }
}

// Moves all robots by less than the tolerance. They may pass convex vertices; robots in notches
// stay.
std::vector<LiftingPoint> disturbed(const Placement& placement, std::mt19937_64& rng, bool worst) {
  // Less the tolerances that decide closure itself.
  const double tolerance = (1 - 1e-3) * placement.closure.clearance.tolerance -
                           10 * near_distance(placement.polygon().diameter());
  std::vector<LiftingPoint> robots;
  for (const LiftingPoint& robot : contact_points(placement)) {
    const auto touching = contacts(placement.polygon(), {robot});
    if (touching.size() != 1 && (touching.empty() || touching[0].in_notch)) {
      robots.push_back(robot);
      continue;
    }
    const double part = static_cast<double>(rng() % 2001) / 1000 - 1;
    robots.push_back(moved_along(placement.polygon(), {touching[0].position, touching[0].edge},
                                 tolerance * (worst ? (part < 0 ? -1 : 1) : part)));
  }
  return robots;
}

std::vector<Placement> some_holds() {
  std::vector<Placement> holds;
  std::size_t number = 0;
  for (const std::string& name : corpus::polygon_names()) {
    if (++number % 4 != 0) continue;
    for (const Method method : all_methods) {
      Document document = corpus::polygon(name);
      document.settings.method = method;
      document.settings.teams = 3 + number % 2;
      document.settings.robots = 4 + number % 4;
      if (selects_candidates(method)) {
        document.settings.goal = Goal::hold;
        document.settings.positions = method == Method::area ? Positions::range : Positions::best;
      }
      auto placement = place(document);
      if (placement && !placement->teams.empty()) holds.push_back(*std::move(placement));
    }
  }
  return holds;
}

}  // namespace

TEST_CASE("robots that are all off by less than the tolerance still hold the object",
          "[closure][clearance][slow]") {
  std::mt19937_64 rng(7);
  int moves = 0;
  for (const Placement& placement : some_holds()) {
    if (!placement.closure.form_closure) continue;
    CHECK(placement.closure.clearance.tolerance > 0);
    for (int i = 0; i < 24; ++i, ++moves) {
      const auto robots = disturbed(placement, rng, i % 2 == 0);
      INFO(name(placement.settings.method));
      const bool holds = in_form_closure(placement.polygon(), placement.centre_of_mass, robots);
      CHECK(holds);
    }
  }
  CHECK(moves > 2000);
}

TEST_CASE("what a search to hold finds is firm, unless it says so", "[closure][clearance][slow]") {
  int reached = 0, searched = 0;
  for (const Placement& placement : some_holds()) {
    if (goal_of(placement.settings) != Goal::hold) continue;
    ++searched;
    const double clear = 0.02 * farthest_vertex(placement.polygon(), placement.centre_of_mass);
    const Closure& closure = placement.closure;
    const double near = 1e-9 * placement.polygon().diameter();
    const bool is_firm = closure.form_closure && closure.clearance.distance >= clear - near &&
                         closure.clearance.tolerance >= clear / 2 - near;
    CHECK(placement.goal_reached == is_firm);
    reached += placement.goal_reached ? 1 : 0;
  }
  CHECK(searched > 80);
  CHECK(reached > searched * 9 / 10);
}
