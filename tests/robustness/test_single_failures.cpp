// After a robot fails, compared with a lift that never had it.
#include <algorithm>

#include "evenlift/closure.h"
#include "evenlift/failures.h"
#include "evenlift/hull.h"
#include "evenlift/load_models.h"
#include "evenlift/placed_robots.h"
#include "evenlift/stability.h"
#include "kit/catch.h"
#include "kit/corpus.h"
#include "kit/placed.h"
#include "kit/polygons.h"
#include "kit/solid.h"

using namespace evenlift;
using evenlift::testing::placed;

namespace {

// By plan: each of the other teams carries an equal part of the weight.
double greatest_of_other_teams(const Placement& placement, std::size_t failed) {
  std::vector<Chord> chords;
  for (std::size_t t = 0; t < placement.teams.size(); ++t)
    if (t != failed) chords.push_back(chord_of(placement.teams[t]));
  return summarize_loads(distribute_weight(chords, placement.weight()))->max;
}

void check_rest(const Placement& placement, std::size_t robot,
                const std::optional<RestOfRobots>& rest) {
  const Polygon polygon = testing::polygon(placement.vertices());
  const Vec2& centre = placement.centre_of_mass;
  const double size = polygon.diameter(), weight = placement.weight();
  std::vector<LiftingPoint> points = lifting_points(placement.teams);
  points.erase(points.begin() + static_cast<std::ptrdiff_t>(robot));
  Points robots;
  for (const LiftingPoint& point : points) robots.push_back(point.position);

  CHECK(rest.has_value() == (failures_carried(robots, centre, size) >= 0));
  if (!rest) return;
  CHECK(rest->steady == (failures_steady(robots, centre, size) >= 0));
  CHECK(rest->clear ==
        (failures_steady(robots, centre, size, hold_requirements(placement).clear) >= 0));
  CHECK(rest->coverage ==
        Approx(coverage(solid(polygon), convex_hull(robots, 1e-9 * size))).margin(1e-12));
  const Closure closure = analyse_closure(polygon, centre, points);
  CHECK(rest->form_closure == closure.form_closure);
  CHECK(rest->margin == closure.margin);
  const std::vector<double> loads = spring_loads(robots, centre, size, weight)->loads;
  CHECK(rest->greatest_by_springs == *std::max_element(loads.begin(), loads.end()));
  CHECK(rest->least_greatest == *best_load(robots, centre, size, weight));
  REQUIRE(rest->greatest_by_plan.has_value() == (placement.teams.size() > 1));
  if (rest->greatest_by_plan)
    CHECK(*rest->greatest_by_plan ==
          Approx(greatest_of_other_teams(placement, robot / 2)).epsilon(1e-12));
}

}  // namespace

TEST_CASE("without a robot the others have what they would have had without it",
          "[robustness][failures][slow]") {
  int fallen = 0, unsteady = 0, closed = 0;
  for (const std::string& name : corpus::polygon_names()) {
    for (const std::uint32_t teams : {1u, 2u, 3u}) {
      Document document = corpus::polygon(name);
      document.settings.method = all_methods[teams];  // circle, distance, equal angles
      document.settings.teams = teams;
      document.settings.weight = 48;
      const Placement placement = placed(document);
      const auto failures = single_failures(placement);
      REQUIRE(failures.size() == 2 * placement.teams.size());
      for (std::size_t robot = 0; robot < failures.size(); ++robot) {
        INFO(name << ", " << teams << " teams, robot " << robot);
        check_rest(placement, robot, failures[robot]);
        fallen += !failures[robot];
        unsteady += failures[robot] && !failures[robot]->steady;
        closed += failures[robot] && failures[robot]->form_closure;
      }
    }
  }
  CHECK(fallen > 50);
  CHECK(unsteady > 50);
  CHECK(closed > 10);
}

TEST_CASE("any one robot may fail if and only if the object is carried without each of them",
          "[robustness][failures]") {
  int always_carried = 0, always_steady = 0, not_steady = 0, by_a_hair = 0;
  for (const std::string& name : corpus::polygon_names()) {
    Document document = corpus::polygon(name);
    document.settings.teams = 3;
    const Placement placement = placed(document);
    const Robustness known = robustness(placement);
    const auto failures = single_failures(placement);
    INFO(name);
    const auto carried = [](const auto& rest) { return rest.has_value(); };
    const auto steady = [](const auto& rest) { return rest && rest->steady; };
    const auto clear = [](const auto& rest) { return rest && rest->clear; };
    if (failures.empty()) continue;
    CHECK((known.failures_carried >= 1) == std::all_of(failures.begin(), failures.end(), carried));
    CHECK((known.failures_steady >= 1) == std::all_of(failures.begin(), failures.end(), steady));
    CHECK((known.failures_clear >= 1) == std::all_of(failures.begin(), failures.end(), clear));
    by_a_hair += known.failures_clear < 1 && known.failures_steady >= 1;
    always_carried += known.failures_carried >= 1;
    ++(known.failures_steady >= 1 ? always_steady : not_steady);
  }
  CHECK(always_carried > 50);
  CHECK(always_steady > 10);
  CHECK(not_steady > 0);
  CHECK(by_a_hair > 0);
}
