// Against brute force.
#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "evenlift/hull.h"
#include "evenlift/optimum.h"
#include "evenlift/placement.h"
#include "evenlift/stands.h"
#include "evenlift/tolerance.h"
#include "kit/catch.h"
#include "kit/corpus.h"
#include "kit/placed.h"
#include "optimum/rings.h"
#include "shapes/problem_document.h"
#include "shapes/small_polygons.h"

using namespace evenlift;
using evenlift::testing::placed;

namespace {

double coverage_of(const Placement& placement, const std::vector<std::uint32_t>& taken) {
  Points ends;
  for (const std::uint32_t i : taken)
    for (const LiftingPoint& end :
         {placement.candidates[i].chord.r1, placement.candidates[i].chord.r2})
      ends.push_back(end.position);
  return coverage(placement.object,
                  convex_hull(ends, near_distance(placement.polygon().diameter())));
}

// Of `size` candidates.
template <class Visit>
void for_each_choice(std::uint32_t all, std::size_t size, std::vector<std::uint32_t>& taken,
                     Visit visit) {
  if (taken.size() == size) return visit(taken);
  for (std::uint32_t i = taken.empty() ? 0 : taken.back() + 1; i < all; ++i) {
    taken.push_back(i);
    for_each_choice(all, size, taken, visit);
    taken.pop_back();
  }
}

std::uint64_t choices(std::size_t all, std::size_t size) {
  std::uint64_t number = 1;
  for (std::size_t i = 0; i < size; ++i) number = number * (all - i) / (i + 1);
  return number;
}

double widest_by_force(const Placement& placement, std::size_t teams) {
  double widest = 0;
  std::vector<std::uint32_t> taken;
  for_each_choice(
      static_cast<std::uint32_t>(placement.candidates.size()), teams, taken,
      [&](const auto& each) { widest = std::max(widest, coverage_of(placement, each)); });
  return widest;
}

Optimum optimum_of(const Placement& placement) {
  return widest_choice(placement.object, placement.centre_of_mass, placement.candidates,
                       placement.requested_teams, placement.team_candidates);
}

// Returns whether the choices are few enough for brute force.
bool compare(const Placement& placement) {
  const std::size_t teams = placement.teams.size();
  if (teams == 0 || teams < placement.requested_teams) return false;
  if (choices(placement.candidates.size(), teams) > 2000) return false;
  const Optimum optimum = optimum_of(placement);
  CHECK(optimum.proved);
  CHECK(optimum.taken.size() == teams);
  CHECK(optimum.coverage == Approx(coverage_of(placement, optimum.taken)).margin(1e-12));
  CHECK(optimum.coverage == Approx(widest_by_force(placement, teams)).margin(1e-9));
  CHECK(optimum.coverage >= placement.coverage - 1e-12);
  return true;
}

// Samples on which three teams chosen to hold can be compared with all.
struct Held {
  std::string name;
  Placement placement;
};
std::vector<Held> held_samples() {
  std::vector<Held> samples;
  for (const std::string& name : corpus::polygon_names()) {
    Document document = corpus::polygon(name);
    document.settings.goal = Goal::hold;
    Placement placement = placed(document);
    if (placement.teams.size() >= 3 && placement.candidates.size() <= 40)
      samples.push_back({name, std::move(placement)});
  }
  return samples;
}

}  // namespace

TEST_CASE("the widest choice of teams is that of brute force", "[optimum][thorough]") {
  int compared = 0;
  for (std::uint64_t number = 0; number < 900; ++number) {
    Document document = testing::document_of(small_polygons::make_plain_case(number).problem);
    document.settings.min_ratio = 0.7;
    document.settings.teams = static_cast<std::uint32_t>(1 + number % 4);
    if (number % 3 == 0) document.settings.positions = Positions::range;
    const auto placement = place(document);
    if (!placement) continue;
    INFO("case " << number);
    if (compare(*placement)) ++compared;
  }
  CHECK(compared > 300);
}

TEST_CASE("with many candidates there is a bound, and a choice below it", "[optimum]") {
  Document document = corpus::polygon("labyrinth");
  document.settings.teams = 3;
  document.settings.min_ratio = 0.6;
  const Placement placement = placed(document);
  REQUIRE(placement.candidates.size() > most_candidates_proved);
  const Optimum optimum = optimum_of(placement);
  CHECK(optimum.coverage >= placement.coverage);
  CHECK(optimum.coverage <= optimum.bound);
  CHECK(optimum.bound <= 1 + 1e-9);
}

TEST_CASE("bounds of many candidates are true of few, too", "[optimum]") {
  // Of two ways to bound a choice, one is exact, the other never below it.
  const Placement placement = placed(corpus::polygon("guitar"));
  const Optimum optimum = optimum_of(placement);
  CHECK(optimum.proved);
  int asked = 0;
  const Optimum stopped =
      widest_choice(placement.object, placement.centre_of_mass, placement.candidates, 3,
                    placement.team_candidates, [&] { return ++asked > 3; });
  CHECK(asked > 3);
  CHECK_FALSE(stopped.proved);
  CHECK(stopped.bound >= optimum.coverage - 1e-12);
  CHECK(stopped.coverage <= optimum.coverage + 1e-12);
}

TEST_CASE("a bound that takes ends one by one is never below the best ring of whole chords",
          "[optimum]") {
  for (const char* name : {"square", "hexagon", "arrow", "thesis-sample"}) {
    const Placement placement = placed(corpus::polygon(name));
    const optimum::Triangles triangles(placement.object, placement.centre_of_mass,
                                       placement.candidates);
    for (const std::uint32_t teams : {1u, 2u, 3u, 4u}) {
      INFO(name << ", " << teams << " teams");
      const auto by_sides = optimum::best_ring_by_sides(triangles, teams, {});
      const auto of_chords = optimum::best_ring_of_chords(triangles, teams, {});
      REQUIRE((by_sides && of_chords));
      CHECK(by_sides->share >= of_chords->share - 1e-12);
      // The diagonals of a square cover all of it.
      if (std::string(name) == "square" && teams == 2) CHECK(of_chords->share == Approx(1));
    }
  }
}

TEST_CASE("the choice to hold is at least as good as what swaps come to", "[optimum][slow]") {
  int equal = 0, compared = 0;
  for (const Held& held : held_samples()) {
    INFO(held.name);
    const Placement& placement = held.placement;
    const auto to_hold =
        choice_to_hold(placement.object, placement.centre_of_mass, placement.candidates, 3,
                       placement.team_candidates, hold_requirements(placement), Optimum{});
    REQUIRE(to_hold);
    const HoldKeys keys =
        hold_keys(placement.object, placement.centre_of_mass, placement.candidates,
                  placement.team_candidates, hold_requirements(placement));
    CHECK_FALSE(better_by(keys, to_hold->keys));
    ++compared;
    if (!better_by(to_hold->keys, keys)) ++equal;
  }
  CHECK(compared > 60);
  CHECK(equal > compared / 2);
}

TEST_CASE("bounds of holds are true, and reached where they are said to be proved",
          "[optimum][slow]") {
  int proved = 0, compared = 0;
  for (const Held& held : held_samples()) {
    INFO(held.name);
    const Placement& placement = held.placement;
    const Optimum widest = optimum_of(placement);
    const auto find = [&](std::uint64_t most) {
      return *choice_to_hold(placement.object, placement.centre_of_mass, placement.candidates, 3,
                             placement.team_candidates, hold_requirements(placement), widest,
                             nullptr, most);
    };
    const ChoiceToHold best = find(most_choices), bounded = find(0);
    CHECK(best.proved);
    CHECK(bounded.taken.size() == 3);
    CHECK_FALSE(better_by(bounded.keys, best.keys));
    CHECK(best.keys.level <= bounded.most_level);
    CHECK(best.keys.coverage <= bounded.most_coverage + 1e-9);
    CHECK(bounded.keys.coverage <= bounded.most_coverage);
    if (bounded.proved) {
      CHECK(bounded.keys.level == best.keys.level);
      CHECK(bounded.keys.coverage == Approx(best.keys.coverage).margin(2e-9));
    }
    proved += bounded.proved;
    ++compared;
  }
  CHECK(compared > 60);
  CHECK(proved > 5);
  CHECK(proved < compared);
}

TEST_CASE("more choices than can be compared are bounded", "[optimum]") {
  Document document = corpus::polygon("labyrinth");
  document.settings.teams = 4;
  document.settings.min_ratio = 0.6;
  document.settings.goal = Goal::hold;
  const Placement placement = placed(document);
  REQUIRE(choices(placement.candidates.size(), 4) > most_choices);
  const auto found = choice_to_hold(placement.object, placement.centre_of_mass,
                                    placement.candidates, 4, placement.team_candidates,
                                    hold_requirements(placement), optimum_of(placement));
  REQUIRE(found);
  CHECK(found->keys.level <= found->most_level);
  CHECK(found->keys.coverage <= found->most_coverage);
  CHECK(found->keys.level == 3);
}

TEST_CASE("the best choices of robots with a size are those of brute force without collisions",
          "[optimum][stands][thorough]") {
  int compared = 0, unlike = 0;
  for (const std::string& name : corpus::polygon_names()) {
    Document document = corpus::polygon(name);
    if (document.vertices.size() > 60) continue;
    INFO(name);
    document.settings.teams = 2 + compared % 2;
    document.settings.positions = Positions::range;
    const double size = Polygon::create(document.vertices)->diagonal();
    document.settings.robot = {0.03 * size, 0, 0, 0, 0.1 * size};
    const auto placement = place(document);
    if (!placement || placement->teams.size() < 2) continue;
    const std::size_t teams = placement->teams.size();
    if (choices(placement->candidates.size(), teams) > 3000) continue;
    const Stands* stands = placement->stands.get();
    double widest = 0;
    HoldKeys to_hold;
    std::vector<std::uint32_t> taken;
    for_each_choice(static_cast<std::uint32_t>(placement->candidates.size()), teams, taken,
                    [&](const std::vector<std::uint32_t>& each) {
                      std::vector<LiftingPoint> robots;
                      for (const std::uint32_t i : each)
                        for (const LiftingPoint& end :
                             {placement->candidates[i].chord.r1, placement->candidates[i].chord.r2})
                          robots.push_back(end);
                      if (stands->any_collide(robots)) return;
                      widest = std::max(widest, coverage_of(*placement, each));
                      const HoldKeys keys = hold_keys(placement->object, placement->centre_of_mass,
                                                      placement->candidates, each,
                                                      hold_requirements(*placement), stands);
                      if (better_by(keys, to_hold)) to_hold = keys;
                    });
    const Optimum found =
        widest_choice(placement->object, placement->centre_of_mass, placement->candidates, teams,
                      placement->team_candidates, {}, stands);
    CHECK(found.coverage <= widest + 1e-9);
    CHECK(found.bound >= widest - 1e-9);
    if (found.proved) CHECK(found.coverage == Approx(widest).margin(2e-9));
    unlike += !found.proved;
    const auto held =
        choice_to_hold(placement->object, placement->centre_of_mass, placement->candidates, teams,
                       placement->team_candidates, hold_requirements(*placement), found, stands);
    REQUIRE(held);
    CHECK(held->proved);
    CHECK(held->keys.level == to_hold.level);
    CHECK(held->keys.coverage == Approx(to_hold.coverage).margin(2e-9));
    ++compared;
  }
  CHECK(compared > 40);
  CHECK(unlike > 0);
}
