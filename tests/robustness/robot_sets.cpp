#include "robustness/robot_sets.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "evenlift/angles.h"
#include "evenlift/hull.h"
#include "evenlift/random.h"

namespace robot_sets {
namespace {

using evenlift::Points;
using evenlift::Rng;
using evenlift::Vec2;

enum class Kind {
  grid,         // coarse; many are collinear or at one place
  anywhere,     // doubles in a square
  on_a_square,  // on its sides, as at an object's straight edges
  pairs,        // across C
  one_line,     // on one slanted line with C
  one_place,    // two or three places
  at_a_robot,   // C is at a robot
  on_the_edge,  // C is half way between two robots; the others may be on one side
  thin,         // in a strip of 1e-5 L
  count
};
constexpr const char* names[] = {"grid",      "anywhere",   "on a square", "pairs", "one line",
                                 "one place", "at a robot", "on the edge", "thin"};
static_assert(std::size(names) == static_cast<std::size_t>(Kind::count));

double between(Rng& rng, double low, double high) { return low + (high - low) * rng.uniform(); }

double whole(Rng& rng, int from, int to) {
  return from + static_cast<double>(rng.below(static_cast<std::uint64_t>(to - from + 1)));
}

Vec2 anywhere(Rng& rng) {
  const double x = between(rng, -1, 1);
  return {x, between(rng, -1, 1)};
}

Vec2 on_a_square(Rng& rng) {
  const double along = between(rng, -1, 1);
  switch (rng.below(4)) {
    case 0:
      return {along, -1};
    case 1:
      return {1, along};
    case 2:
      return {along, 1};
    default:
      return {-1, along};
  }
}

Vec2 on_the_grid(Rng& rng, int half) {
  const double x = whole(rng, -half, half);
  return {x, whole(rng, -half, half)};
}

RobotSet with_size(RobotSet set) {
  Points all = set.robots;
  all.push_back(set.centre);
  all = evenlift::convex_hull(std::move(all));
  set.diameter = 1e-3;
  for (const Vec2& a : all)
    for (const Vec2& b : all) set.diameter = std::max(set.diameter, evenlift::length(a - b));
  return set;
}

RobotSet basic_set(Kind kind, Rng& rng, std::size_t m) {
  RobotSet set{names[static_cast<std::size_t>(kind)], {}, anywhere(rng) / 2, 0};
  Points& robots = set.robots;
  const Vec2 direction = anywhere(rng);
  while (robots.size() < m) {
    switch (kind) {
      case Kind::grid:
        set.centre = Vec2{};
        robots.push_back(on_the_grid(rng, 3));
        break;
      case Kind::on_a_square:
        robots.push_back(on_a_square(rng));
        break;
      case Kind::pairs: {
        const Vec2 arm = anywhere(rng);
        robots.push_back(set.centre + arm);
        if (robots.size() < m) robots.push_back(set.centre - between(rng, 0.2, 2) * arm);
        break;
      }
      case Kind::one_line:
        robots.push_back(set.centre + between(rng, -1, 1) * direction);
        break;
      case Kind::one_place: {
        const Vec2 places[] = {set.centre + direction, set.centre - direction / 3, set.centre};
        robots.push_back(places[rng.below(3)]);
        break;
      }
      case Kind::on_the_edge: {
        const double along = whole(rng, -4, 4), across = whole(rng, 0, 2);
        set.centre = {0.25, 0.5};
        robots.push_back(set.centre + along * Vec2(0.5, 0.25) + across * Vec2(-0.25, 0.5));
        break;
      }
      case Kind::thin: {
        const double along = between(rng, -1, 1);
        robots.push_back(set.centre + along * direction +
                         1e-5 * between(rng, -1, 1) * evenlift::left_normal(direction));
        break;
      }
      default:
        robots.push_back(anywhere(rng));
    }
  }
  if (kind == Kind::at_a_robot) set.centre = robots[rng.below(robots.size())];
  return with_size(set);
}

RobotSet turned(RobotSet set, Rng& rng) {
  const double angle = between(rng, 0, 2 * evenlift::pi);
  const double c = evenlift::cosine(angle), s = evenlift::sine(angle);
  const double mirror = rng.below(2) == 0 ? 1 : -1;
  const auto turn = [&](Vec2& p) { p = Vec2(c * p.x - s * p.y, mirror * (s * p.x + c * p.y)); };
  for (Vec2& robot : set.robots) turn(robot);
  turn(set.centre);
  return set;
}

RobotSet scaled_and_shifted(RobotSet set, double scale, const Vec2& shift) {
  for (Vec2& robot : set.robots) robot = scale * robot + shift;
  set.centre = scale * set.centre + shift;
  set.diameter *= scale;
  return set;
}

Rng generator(std::uint64_t number) { return Rng(number * 0x9e3779b97f4a7c15u + 11); }

}  // namespace

RobotSet make_set(std::uint64_t number, std::size_t most) {
  Rng rng = generator(number);
  const auto kind = static_cast<Kind>(number % static_cast<std::uint64_t>(Kind::count));
  RobotSet set = basic_set(kind, rng, 1 + rng.below(most));
  switch (rng.below(5)) {
    case 0:  // as small as permitted
      return scaled_and_shifted(set, 1e-9, Vec2{});
    case 1:  // as large as permitted
      return scaled_and_shifted(set, 1e8, Vec2{});
    case 2:  // far away
      return scaled_and_shifted(set, 64, {4649776.25, -512345.5});
    case 3:
      return turned(set, rng);
    default:
      return set;
  }
}

RobotSet make_grid(std::uint64_t number, std::size_t most) {
  Rng rng = generator(number);
  return basic_set(Kind::grid, rng, 1 + rng.below(most));
}

RobotSet make_pairs(std::uint64_t number, std::size_t teams) {
  Rng rng = generator(number);
  return turned(basic_set(Kind::pairs, rng, 2 * teams), rng);
}

RobotSet make_steady_set(std::uint64_t number, std::size_t most) {
  Rng rng = generator(number);
  const Kind kinds[] = {Kind::anywhere, Kind::on_a_square, Kind::pairs, Kind::grid};
  RobotSet set = basic_set(kinds[number % 4], rng, rng.below(most));
  for (const Vec2& corner : {Vec2(1, 0), Vec2(-0.5, 1), Vec2(-0.5, -1)})
    set.robots.push_back(set.centre + between(rng, 0.2, 1) * corner);
  return with_size(set);
}

RobotSet make_near_edge(std::uint64_t number, std::size_t most) {
  Rng rng = generator(number);
  const Kind kinds[] = {Kind::anywhere, Kind::on_a_square, Kind::grid, Kind::thin};
  RobotSet set = basic_set(kinds[number % 4], rng, 3 + rng.below(most));
  const Points hull = evenlift::convex_hull(set.robots, 1e-9 * set.diameter);
  if (hull.size() < 3) return make_near_edge(number + 1000003, most);
  const std::size_t edge = rng.below(hull.size());
  const Vec2 &a = hull[edge], along = hull[(edge + 1) % hull.size()] - a;
  const double place = rng.uniform();
  double distance = set.diameter;
  for (std::uint64_t powers = 1 + rng.below(9); powers > 0; --powers) distance /= 10;
  const Vec2 inward = evenlift::left_normal(along) / evenlift::length(along);
  set.centre = a + place * along + distance * inward;
  return with_size(set);
}

RobotSet moved(const RobotSet& set, std::uint64_t number) {
  Rng rng = generator(number + 1000000);
  const RobotSet at_rest = turned(set, rng);
  const double scale = between(rng, 0.1, 10);
  const double x = between(rng, -3, 3);
  return scaled_and_shifted(at_rest, scale, set.diameter * Vec2(x, between(rng, -3, 3)));
}

}  // namespace robot_sets
