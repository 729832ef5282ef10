#include <cstdint>

#include "evenlift/failures.h"
#include "evenlift/load_models.h"
#include "evenlift/placement.h"
#include "kit/catch.h"
#include "kit/corpus.h"
#include "oracle/rational.h"
#include "oracle/vec.h"
#include "robustness/robot_sets.h"

using namespace evenlift;
using robot_sets::RobotSet;

namespace {

using Exact = oracle::Rational;
using ExactVec = oracle::Vec<Exact>;

// Sets of robots, as bits.
using Mask = std::uint32_t;

// Decides exactly, from pairs and triangles of robots, whether a subset carries the object and
// keeps it steady.
class Subsets {
 public:
  explicit Subsets(const RobotSet& set)
      : near_square_(square(Exact(1) / 1000000000 * Exact(set.diameter))) {
    for (const Vec2& p : set.robots)
      robots_.push_back({Exact(p.x) - Exact(set.centre.x), Exact(p.y) - Exact(set.centre.y)});
    find_carriers();
    find_sides();
  }

  bool carries(Mask subset) const {
    for (const Mask carrier : carriers_)
      if ((carrier & ~subset) == 0) return true;
    return false;
  }

  // C must be to the left, by more than the tolerance, of each line through two robots of the
  // subset without a robot to its right.
  bool keeps_steady(Mask subset) const {
    bool supported = false;
    for (const Side& side : sides_) {
      if ((side.robots & ~subset) != 0 || (subset & side.right) != 0) continue;
      if (!side.leaves_room) return false;
      supported = true;
    }
    return supported;
  }

  // The most robots that may be missing in any combination; -1 if it does not hold even with all.
  template <class Holds>
  int failures(Holds holds) const {
    const auto m = static_cast<int>(robots_.size());
    int worst = m;  // the least number missing for which it does not hold
    for (Mask subset = 0; subset < Mask{1} << m; ++subset)
      if (!holds(subset)) worst = std::min(worst, m - __builtin_popcount(subset));
    return worst - 1;
  }

 private:
  struct Side {
    Mask robots, right;
    bool leaves_room;
  };

  static Exact square(const Exact& x) { return x * x; }
  static Exact square(const ExactVec& v) { return dot(v, v); }
  static Mask bit(std::size_t i) { return Mask{1} << i; }

  bool near_point(const ExactVec& p) const { return square(p) <= near_square_; }

  // Whether the origin is within tolerance.
  bool near_segment(const ExactVec& p, const ExactVec& q) const {
    if (near_point(p) || near_point(q)) return true;
    const ExactVec along = q - p;
    if (dot(p, along) >= 0 || dot(q, along) <= 0) return false;
    return square(cross(p, q)) <= near_square_ * square(along);
  }

  static bool in_triangle(const ExactVec& p, const ExactVec& q, const ExactVec& r) {
    const int a = oracle::sign(cross(p, q)), b = oracle::sign(cross(q, r)),
              c = oracle::sign(cross(r, p));
    return a != 0 && a == b && b == c;
  }

  void find_carriers() {
    const std::size_t m = robots_.size();
    for (std::size_t i = 0; i < m; ++i) {
      if (near_point(robots_[i])) carriers_.push_back(bit(i));
      for (std::size_t j = i + 1; j < m; ++j) {
        if (near_segment(robots_[i], robots_[j])) carriers_.push_back(bit(i) | bit(j));
        for (std::size_t k = j + 1; k < m; ++k)
          if (in_triangle(robots_[i], robots_[j], robots_[k]))
            carriers_.push_back(bit(i) | bit(j) | bit(k));
      }
    }
  }

  void find_sides() {
    for (std::size_t i = 0; i < robots_.size(); ++i) {
      for (std::size_t j = 0; j < robots_.size(); ++j) {
        const ExactVec along = robots_[j] - robots_[i];
        if (square(along) == 0) continue;
        Side side{bit(i) | bit(j), 0, false};
        for (std::size_t k = 0; k < robots_.size(); ++k)
          if (cross(along, robots_[k] - robots_[i]) < 0) side.right |= bit(k);
        const Exact room = cross(robots_[i], robots_[j]);
        side.leaves_room = room > 0 && square(room) > near_square_ * square(along);
        sides_.push_back(side);
      }
    }
  }

  Exact near_square_;
  std::vector<ExactVec> robots_;  // relative to C
  std::vector<Mask> carriers_;    // the smallest sets that carry the object
  std::vector<Side> sides_;
};

int carried(const RobotSet& set) { return failures_carried(set.robots, set.centre, set.diameter); }
int steady(const RobotSet& set) { return failures_steady(set.robots, set.centre, set.diameter); }

RobotSet about_origin(Points robots) { return {"by hand", std::move(robots), Vec2{}, 10}; }

}  // namespace

TEST_CASE("so many robots may fail as every subset that is left shows",
          "[robustness][depth][thorough]") {
  int held = 0, deep = 0;
  for (std::uint64_t number = 0; number < 3000; ++number) {
    const RobotSet set = robot_sets::make_set(number, 10);
    const Subsets subsets(set);
    INFO(number << ", " << set.kind << ", " << set.robots.size() << " robots");
    CHECK(carried(set) == subsets.failures([&](Mask left) { return subsets.carries(left); }));
    CHECK(steady(set) == subsets.failures([&](Mask left) { return subsets.keeps_steady(left); }));
    held += carried(set) >= 0;
    deep += steady(set) >= 1;
  }
  CHECK(held > 1500);
  CHECK(deep > 300);
}

TEST_CASE("teams of two carry any failures but as many as there are teams", "[robustness][depth]") {
  for (std::uint64_t number = 0; number < 2000; ++number) {
    const std::size_t teams = 1 + number % 12;
    const RobotSet set = robot_sets::make_pairs(number, teams);
    INFO(number);
    // Each side of a line through C has a robot of every team, except teams on the line.
    CHECK(carried(set) >= static_cast<int>(teams) - 1);
    CHECK(steady(set) <= carried(set));
  }
}

TEST_CASE("teams are carried however far from the origin they are", "[robustness][depth]") {
  for (std::uint64_t number = 0; number < 300; ++number) {
    const std::size_t teams = 1 + number % 6;
    RobotSet set = robot_sets::make_pairs(number, teams);
    const Vec2 shift(9e8, -3e8);
    for (std::size_t i = 0; i < set.robots.size(); ++i) set.robots[i] += shift;
    set.centre += shift;
    INFO(number);
    CHECK(carried(set) >= static_cast<int>(teams) - 1);
    CHECK(spring_loads(set.robots, set.centre, set.diameter, 1).has_value());
  }
}

TEST_CASE("the teams of every sample carry any failures but one for each team",
          "[robustness][depth][slow]") {
  for (const std::string& name : corpus::polygon_names()) {
    for (const Method method : pair_methods) {
      Document document = corpus::polygon(name);
      document.settings.method = method;
      document.settings.teams = 4;
      const Result<Placement> placement = place(document);
      REQUIRE(placement.ok());
      RobotSet set{name, {}, placement->centre_of_mass, placement->polygon().diameter()};
      for (const LiftingPoint& point : lifting_points(placement->teams))
        set.robots.push_back(point.position);
      INFO(name << " by " << evenlift::name(method));
      CHECK(carried(set) >= static_cast<int>(placement->teams.size()) - 1);
      CHECK(steady(set) <= carried(set));
    }
  }
}

TEST_CASE("few robots, no robots and robots at the centre of mass", "[robustness][depth]") {
  CHECK(carried(about_origin({})) == -1);
  CHECK(steady(about_origin({})) == -1);
  // A robot below C carries the object, but nothing is steady on one leg.
  CHECK(carried(about_origin({{0, 0}})) == 0);
  CHECK(steady(about_origin({{0, 0}})) == -1);
  CHECK(carried(about_origin({{1, 1}})) == -1);
  CHECK(carried(about_origin({{-1, -2}, {2, 4}})) == 0);
  CHECK(steady(about_origin({{-1, -2}, {2, 4}})) == -1);
  CHECK(carried(about_origin({{3, 0}, {-2, 2}, {-2, -2}})) == 0);
  CHECK(steady(about_origin({{3, 0}, {-2, 2}, {-2, -2}})) == 0);
  // Of a square's corners, the two that are left may be opposite or not.
  CHECK(carried(about_origin({{1, 1}, {-1, 1}, {-1, -1}, {1, -1}})) == 1);
  CHECK(steady(about_origin({{1, 1}, {-1, 1}, {-1, -1}, {1, -1}})) == 0);
  // A robot at C helps to carry whichever others fail, but steadies nothing.
  CHECK(carried(about_origin({{1, 1}, {-1, 1}, {-1, -1}, {1, -1}, {0, 0}})) == 2);
  CHECK(steady(about_origin({{1, 1}, {-1, 1}, {-1, -1}, {1, -1}, {0, 0}})) == 0);
}

TEST_CASE("how many may fail stays when the robots are turned, moved and scaled",
          "[robustness][depth]") {
  for (std::uint64_t number = 0; number < 1000; ++number) {
    const RobotSet set = robot_sets::make_pairs(number, 1 + number % 20);
    const RobotSet copy = robot_sets::moved(set, number);
    INFO(number);
    CHECK(carried(copy) == carried(set));
    CHECK(steady(copy) == steady(set));
  }
}
