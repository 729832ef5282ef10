// Steps and results; the same object gets the same robots.
#include <algorithm>
#include <cmath>
#include <string>

#include "balanced/for_oracle.h"
#include "balanced/search.h"
#include "evenlift/angles.h"
#include "evenlift/balanced.h"
#include "evenlift/balanced_history.h"
#include "evenlift/closure.h"
#include "evenlift/hull.h"
#include "evenlift/plane.h"
#include "evenlift/stability.h"
#include "kit/catch.h"
#include "kit/corpus.h"
#include "kit/polygons.h"
#include "kit/solid.h"
#include "shapes/problem_document.h"
#include "shapes/small_polygons.h"

using namespace evenlift;
using evenlift::testing::plain;

namespace {

Settings settings_of(std::uint32_t robots) {
  Settings settings;
  settings.method = Method::balanced;
  settings.robots = robots;
  return settings;
}

struct Task {
  Polygon polygon;
  Vec2 centre;
  BalancedProblem problem;
};

Task task_of(const Document& document, std::uint32_t robots) {
  const Polygon polygon = testing::polygon(document.vertices);
  const Vec2 centre = *check_centre_of_mass(polygon, document.centre_of_mass);
  return {polygon, centre, BalancedProblem(solid(polygon), centre, settings_of(robots))};
}

int level_of(std::optional<double> margin) {
  const double least = margin.value_or(-1);
  return (least >= 0.001) + (least >= 0.02) + (least >= 0.05);
}

// Searches by brute force for a clearly better swap of three robots.
class Improver {
 public:
  Improver(const Task& task, std::vector<set_oracle::Point> robots)
      : task_(task),
        object_(testing::object_of(task.polygon, task.centre)),
        robots_(std::move(robots)) {
    apart_ = 0.12 * set_oracle::radius(object_);
    clear_ = 0.02 * set_oracle::radius(object_);
    coverage_ = set_oracle::coverage(object_, robots_);
    level_ = is_firm(robots_, 0) ? level_of(set_oracle::margin(object_, robots_, clear_)) : 0;
  }

  bool finds_one() const {
    const std::vector<set_oracle::Point> stands = set_oracle::stands(object_);
    for (std::size_t i = 0; i < robots_.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        for (std::size_t k = 0; k < j; ++k)
          for (const set_oracle::Point& stand : stands)
            if (improves(i, j, k, stand)) return true;
    return false;
  }

 private:
  bool improves(std::size_t i, std::size_t j, std::size_t k, const set_oracle::Point& stand) const {
    std::vector<set_oracle::Point> robots{stand};
    for (std::size_t r = 0; r < robots_.size(); ++r)
      if (r != i && r != j && r != k) robots.push_back(robots_[r]);
    set_oracle::Point middle{0, 0};
    for (std::size_t axis = 0; axis < 2; ++axis) {
      middle[axis] = static_cast<double>(robots_.size()) * object_.centre[axis];
      for (const set_oracle::Point& p : robots) middle[axis] -= p[axis];
      middle[axis] /= 2;
    }
    if (!set_oracle::inside_hull(object_, middle)) return false;
    const auto better = [&](const std::array<set_oracle::Point, 2>& chord) {
      std::vector<set_oracle::Point> all = robots;
      all.insert(all.end(), chord.begin(), chord.end());
      return is_better(all);
    };
    const auto chords = set_oracle::even_chords(object_, middle);
    return std::any_of(chords.begin(), chords.end(), better);
  }

  // Better beyond the tolerances of its keys.
  bool is_better(const std::vector<set_oracle::Point>& robots) const {
    constexpr double surely = 1e-6;
    if (set_oracle::least_distance(robots) < apart_ * (1 + surely)) return false;
    const bool wider = set_oracle::coverage(object_, robots) > coverage_ + surely;
    if (!wider && level_ == 3) return false;
    const double margin = set_oracle::margin(object_, robots, clear_).value_or(-1);
    int level = level_of(margin - surely);
    if (level > 0 && !is_firm(robots, surely)) level = 0;
    return level > level_ || (wider && level == level_);
  }

  // Tests of closure check this against exact arithmetic.
  bool is_firm(const std::vector<set_oracle::Point>& robots, double surely) const {
    std::vector<LiftingPoint> points;
    for (const set_oracle::Point& p : robots) {
      const Vec2 at(p[0], p[1]);
      std::uint32_t edge = 0;
      const auto distance = [&](std::uint32_t e) {
        return distance_to_segment(task_.polygon.edge_start(e), task_.polygon.edge_end(e), at);
      };
      for (std::uint32_t e = 1; e < task_.polygon.size(); ++e)
        if (distance(e) < distance(edge)) edge = e;
      points.push_back({at, edge});
    }
    const double near = near_distance(task_.polygon.diameter());
    return holds_within(task_.polygon, task_.centre, contacts(task_.polygon, points),
                        (1 + surely) * clear_ / 2 - near);
  }

  const Task& task_;
  set_oracle::Object object_;
  std::vector<set_oracle::Point> robots_;
  double apart_, clear_, coverage_;
  int level_;
};

}  // namespace

TEST_CASE("no swap makes the balanced robots of a small object better", "[balanced][slow]") {
  int looked_at = 0;
  for (std::uint64_t number = 0; number < 60; ++number) {
    const Document document = testing::document_of(small_polygons::make_plain_case(number).problem);
    if (document.vertices.size() > 9) continue;
    INFO("case " << number);
    const Task task = task_of(document, 4 + number % 2);
    const auto start = start_balanced(task.problem);
    if (!start) continue;
    const BalancedSearch end = finish_search(task.problem, *start);
    if (end.round == most_rounds) continue;
    if (balanced_keys(task.problem, end.robots).near_pairs > 0) continue;
    ++looked_at;
    CHECK_FALSE(Improver(task, plain(end.robots)).finds_one());
  }
  CHECK(looked_at > 8);
}

TEST_CASE("the oracle finds a swap that improves a start", "[balanced]") {
  const Task task = task_of(corpus::polygon("grand-piano"), 5);
  CHECK(Improver(task, plain(start_balanced(task.problem)->robots)).finds_one());
}

TEST_CASE("each swap makes the set better, and says what moved", "[balanced][slow]") {
  for (const char* name : {"grand-piano", "arrow", "letter-e", "thesis-sample"}) {
    INFO(name);
    const Task task = task_of(corpus::polygon(name), 6);
    BalancedSearch search = *start_balanced(task.problem);
    const BalancedSearch end = finish_search(task.problem, search);
    while (!search.finished) {
      const BalancedStep step = try_next_triple(task.problem, search);
      if (step.swap) {
        CHECK(is_better(task.problem, step.search.robots, search.robots));
        for (std::size_t k = 0; k < 3; ++k) {
          CHECK(search.robots[step.swap->numbers[k]].position == step.swap->from[k].position);
          const auto stands = positions(step.search.robots);
          CHECK(std::find(stands.begin(), stands.end(), step.swap->to[k].position) != stands.end());
        }
      } else {
        CHECK(positions(step.search.robots) == positions(search.robots));
      }
      search = step.search;
    }
    // Triple by triple, round by round or at once: the same robots.
    CHECK(positions(search.robots) == positions(end.robots));
  }
}

TEST_CASE("a search that begins again counts its rounds anew", "[balanced]") {
  for (const char* name : {"arrow", "bracket", "convex-5"}) {
    INFO(name);
    Settings settings = settings_of(5);
    settings.robot.radius = 50;
    const Task task = task_of(corpus::polygon(name), 5);
    const BalancedProblem problem(solid(task.polygon), task.centre, settings);
    BalancedSearch search = *start_balanced(problem);
    while (!search.restarted) search = try_next_triple(problem, search).search;
    REQUIRE_FALSE(search.finished);
    CHECK(search.round == 0);
  }
}

TEST_CASE("the keys of a set are what the rest of the core says of it", "[balanced][slow]") {
  for (const std::string& name : corpus::polygon_names()) {
    INFO(name);
    const Task task = task_of(corpus::polygon(name), 5);
    const auto start = start_balanced(task.problem);
    REQUIRE(start);
    const BalancedKeys keys = balanced_keys(task.problem, start->robots);
    const Points robots = positions(start->robots);
    CHECK(std::fabs(keys.coverage - coverage(solid(task.polygon), convex_hull(robots))) <= 1e-11);
    const double clear = 0.02 * farthest_vertex(task.polygon, task.centre);
    const Hold hold =
        analyse_hold(task.polygon, task.centre,
                     clear_contacts(task.polygon, contacts(task.polygon, start->robots), clear));
    const Clearance clearance =
        analyse_clearance(task.polygon, task.centre, contacts(task.polygon, start->robots));
    const bool is_firm = clearance.tolerance >= clear / 2 - near_distance(task.polygon.diameter());
    CHECK(static_cast<int>(keys.level) == (is_firm ? level_of(hold.margin) : 0));
    CHECK(std::is_sorted(keys.places.begin(), keys.places.end()));
  }
}

TEST_CASE(
    "of sets that cover the same the one farther from C is better, then the one that comes first",
    "[balanced]") {
  const Polygon rectangle = testing::polygon({{-2, -1}, {2, -1}, {2, 1}, {-2, 1}});
  Settings settings = settings_of(6);
  settings.goal = Goal::cover;
  settings.apart = 0;
  const BalancedProblem problem(solid(rectangle), {0, 0}, settings);
  // Robots at the four corners, which cover all, and two more.
  const auto corners_and = [](const LiftingPoint& p, const LiftingPoint& q) {
    return std::vector<LiftingPoint>{{{-2, -1}, 0}, {{2, -1}, 1}, {{2, 1}, 2}, {{-2, 1}, 3}, p, q};
  };
  const auto check = [&](const std::vector<LiftingPoint>& better,
                         const std::vector<LiftingPoint>& worse, BalancedKey key) {
    CHECK(balanced_keys(problem, better).coverage == Approx(1).margin(1e-12));
    CHECK(is_better(problem, better, worse));
    CHECK_FALSE(is_better(problem, worse, better));
    CHECK_FALSE(is_better(problem, better, better));
    CHECK(decided_by(problem, better, worse) == key);
  };
  check(corners_and({{2, 0}, 1}, {{-2, 0}, 3}), corners_and({{0, -1}, 0}, {{0, 1}, 2}),
        BalancedKey::spread);
  // The walk begins at (-2, -1), and reaches (-1, -1) first.
  check(corners_and({{-1, -1}, 0}, {{1, 1}, 2}), corners_and({{1, -1}, 0}, {{-1, 1}, 2}),
        BalancedKey::places);
}

TEST_CASE("a set that survives a failure is better than one that holds", "[balanced]") {
  const Polygon square = testing::polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  Settings settings = settings_of(6);
  settings.goal = Goal::hold;
  settings.survive = 1;
  settings.apart = 0;
  const BalancedProblem problem(solid(square), {0.5, 0.5}, settings);
  // Nothing holds it from left to right; but whichever robot fails, C stays inside.
  const std::vector<LiftingPoint> survives = {{{0.1, 0}, 0}, {{0.5, 0}, 0}, {{0.9, 0}, 0},
                                              {{0.9, 1}, 2}, {{0.5, 1}, 2}, {{0.1, 1}, 2}};
  // Held from all sides; but without the robot at the right, C is on the edge of the others' hull.
  const std::vector<LiftingPoint> holds = {{{0.48, 0}, 0}, {{0.5, 0}, 0}, {{1, 0.6}, 1},
                                           {{0.52, 1}, 2}, {{0.5, 1}, 2}, {{0, 0.4}, 3}};
  CHECK(balanced_keys(problem, holds).level > balanced_keys(problem, survives).level);
  CHECK(is_better(problem, survives, holds));
  CHECK(decided_by(problem, survives, holds) == BalancedKey::steady);
}

TEST_CASE("a search ends after eight rounds, even if the last one changed something",
          "[balanced]") {
  const Task task = task_of(corpus::polygon("grand-piano"), 5);
  // At the last triple of a round with a swap.
  BalancedSearch search = *start_balanced(task.problem);
  search.next = static_cast<std::uint32_t>(balanced::triples_of(5).size()) - 1;
  search.changed = true;
  search.restarted = true;
  search.round = most_rounds - 2;
  const BalancedSearch goes_on = try_next_triple(task.problem, search).search;
  CHECK_FALSE(goes_on.finished);
  CHECK(goes_on.round == most_rounds - 1);
  CHECK(goes_on.next == 0);
  search.round = most_rounds - 1;
  const BalancedSearch ended = try_next_triple(task.problem, search).search;
  CHECK(ended.finished);
  CHECK(ended.round == most_rounds);
}

TEST_CASE("the more robots, the nearer to each other are the three that may be swapped",
          "[balanced]") {
  const auto number = [](std::uint32_t robots) { return balanced::triples_of(robots).size(); };
  CHECK(number(3) == 1);
  CHECK(number(12) == 220);  // all of them
  CHECK(number(13) == 130);  // two are neighbours
  CHECK(number(24) == 504);
  CHECK(number(25) == 25);  // three in a row
  CHECK(number(64) == 64);
}

TEST_CASE("trial points are on their edges, whichever way the vertices run", "[balanced]") {
  for (const Points& vertices :
       {Points{{0, 0}, {4, 0}, {4, 2}, {0, 3}}, Points{{0, 3}, {4, 2}, {4, 0}, {0, 0}}}) {
    const Polygon polygon = testing::polygon(vertices);
    for (const LiftingPoint& stand : balanced::Outline(polygon, {2, 1}).stands()) {
      const Vec2 from = polygon.edge_start(stand.edge), to = polygon.edge_end(stand.edge);
      CHECK(distance_to_segment(from, to, stand.position) < 1e-12);
    }
  }
}

TEST_CASE("a set counts each two of its robots that are too near each other once", "[balanced]") {
  const Polygon polygon = testing::polygon({{0, 0}, {4, 0}, {4, 2}, {0, 2}});
  Settings settings = settings_of(4);
  settings.apart = 100;
  const BalancedProblem problem(solid(polygon), {2, 1}, settings);
  balanced::Best best(problem.rules());
  best.offer_two_more({{{1, 0}, 0}, {{1, 2}, 2}});
  REQUIRE(best.set());
  CHECK(best.set()->near_pairs == 6);
}

TEST_CASE("no robot with a size comes to where it collides with one that stays",
          "[balanced][stands]") {
  // Mirrored, the other end of the chord is the one that would collide.
  for (const bool mirrored : {false, true}) {
    const auto at = [&](double x, double y) { return Vec2(mirrored ? 10 - x : x, y); };
    const Polygon polygon =
        testing::polygon({at(0, 0), at(10, 0), at(10, 6), at(3, 6), at(3, 5), at(0, 5)});
    Settings settings = settings_of(4);
    settings.robot.radius = 0.4;
    const BalancedProblem problem(solid(polygon), {5, 3}, settings);
    // On either side of the reflex corner (3, 5).
    const LiftingPoint above{at(3, 5.5), 3}, near{at(2.4, 5), 4}, far{at(1.5, 5), 4};
    REQUIRE(problem.rules().room()->collide(near, above));
    REQUIRE_FALSE(problem.rules().room()->collide(far, above));

    // With one pair of places C is the centroid: one robot stays, the other moves to this place.
    const auto comes_beside = [&](const LiftingPoint& stays) {
      CHECK(completions(problem, {stays, above}).chords.size() == 1);
      balanced::Best best(problem.rules());
      best.offer_three_more({stays}, above);
      return best.set().has_value();
    };
    CHECK(comes_beside(far));
    CHECK_FALSE(comes_beside(near));

    // The first robot moves along the lower side to the place that would force its neighbours to
    // (3, 5.5) and (10, 1.5).
    const auto neighbours_follow = [&](const LiftingPoint& stays) {
      const LiftingPoint to{Vec2(10 - stays.position.x + (mirrored ? 3 : -3), 0), 0};
      CHECK(completions(problem, {to, stays}).chords.size() == 1);
      return move_robot(problem, {{at(6, 0), 0}, {at(10, 2), 1}, stays, {at(4, 6), 2}}, 0, to)
          .has_value();
    };
    CHECK(neighbours_follow(far));
    CHECK_FALSE(neighbours_follow(near));
  }
}

TEST_CASE("the list of vertices may begin anywhere and run either way", "[balanced][slow]") {
  const std::vector<std::string> names = corpus::polygon_names();
  for (std::size_t i = 0; i < names.size(); i += 3) {
    INFO(names[i]);
    Document document = corpus::polygon(names[i]);
    const Polygon before = testing::polygon(document.vertices);
    document.centre_of_mass = *check_centre_of_mass(before, document.centre_of_mass);
    const Task task = task_of(document, 5);
    std::rotate(
        document.vertices.begin(),
        document.vertices.begin() + static_cast<std::ptrdiff_t>(document.vertices.size() / 3),
        document.vertices.end());
    if (i % 2 == 0) std::reverse(document.vertices.begin(), document.vertices.end());
    const Task other = task_of(document, 5);
    const Points a = positions(finish_search(task.problem, *start_balanced(task.problem)).robots);
    const Points b = positions(finish_search(other.problem, *start_balanced(other.problem)).robots);
    REQUIRE(a.size() == b.size());
    for (std::size_t k = 0; k < a.size(); ++k)
      CHECK(length(a[k] - b[k]) <= 1e-8 * before.diagonal());
  }
}

TEST_CASE("a turned and scaled object gets the same verdict, and nearly the same coverage",
          "[balanced][thorough]") {
  const std::vector<std::string> names = corpus::polygon_names();
  int compared = 0, near = 0;
  for (std::size_t i = 0; i < names.size(); i += 2) {
    INFO(names[i]);
    Document document = corpus::polygon(names[i]);
    document.centre_of_mass.reset();
    const Task task = task_of(document, 6);
    const double angle = 0.37 + static_cast<double>(i);
    for (Vec2& v : document.vertices)
      v = 3.7 *
          Vec2(cosine(angle) * v.x - sine(angle) * v.y, sine(angle) * v.x + cosine(angle) * v.y);
    const Task other = task_of(document, 6);
    const auto result = [](const Task& t) {
      return balanced_keys(t.problem, finish_search(t.problem, *start_balanced(t.problem)).robots);
    };
    const BalancedKeys a = result(task), b = result(other);
    CHECK(a.level > 0);
    CHECK((a.level > 0) == (b.level > 0));
    ++compared;
    near += std::fabs(a.coverage - b.coverage) <= 0.01;
  }
  INFO(near << " of " << compared);
  CHECK(compared > 40);
  CHECK(near >= 0.95 * compared);
}
