// Properties of every result, and brute force.
#include <algorithm>
#include <cmath>
#include <string>

#include "evenlift/closure.h"
#include "evenlift/hull.h"
#include "evenlift/placement.h"
#include "evenlift/selection.h"
#include "evenlift/settings.h"
#include "evenlift/swaps.h"
#include "evenlift/tolerance.h"
#include "kit/catch.h"
#include "kit/corpus.h"
#include "kit/metrics.h"
#include "kit/placed.h"
#include "shapes/problem_document.h"
#include "shapes/small_polygons.h"

using namespace evenlift;
using evenlift::testing::placed;

namespace {

constexpr double usual_margin = 0.05;

Document to_hold(Document document, std::uint32_t teams, Positions positions) {
  document.settings.teams = teams;
  document.settings.goal = Goal::hold;
  document.settings.positions = positions;
  return document;
}

// By the functions that describe every placement, not by those of the search.
HoldKeys keys_by_definition(const Placement& placement, const std::vector<std::uint32_t>& taken,
                            const HoldRequirements& hold) {
  std::vector<LiftingPoint> points;
  Points positions;
  HoldKeys keys;
  for (const std::uint32_t i : taken) {
    const Chord& chord = placement.candidates[i].chord;
    for (const LiftingPoint& point : {chord.r1, chord.r2}) {
      points.push_back(point);
      positions.push_back(point.position);
    }
    keys.ratios += chord.ratio;
  }
  // Only contacts far enough from corners count.
  std::vector<LiftingPoint> counted;
  for (const Contact& contact : contacts(placement.polygon(), points))
    if (contact.to_corner >= hold.clear - near_distance(placement.polygon().diameter()))
      counted.push_back(points[contact.point]);
  const Closure closure = analyse_closure(placement.polygon(), placement.centre_of_mass, counted);
  for (const double bound : {0.001, 0.4 * hold.min_margin, hold.min_margin})
    if (closure.margin && *closure.margin >= bound) ++keys.level;
  const Clearance clearance = analyse_clearance(placement.polygon(), placement.centre_of_mass,
                                                contacts(placement.polygon(), points));
  if (clearance.tolerance < hold.tolerance - near_distance(placement.polygon().diameter()))
    keys.level = 0;
  keys.coverage = coverage(placement.object,
                           convex_hull(positions, near_distance(placement.polygon().diameter())));
  return keys;
}

// By more than the two ways to compute keys differ.
bool clearly_better(const HoldKeys& a, const HoldKeys& b) {
  if (a.level != b.level) return a.level > b.level;
  if (std::fabs(a.coverage - b.coverage) > 2e-9) return a.coverage > b.coverage;
  if (std::fabs(a.coverage - b.coverage) > 0.5e-9) return false;  // perhaps a tie
  return a.ratios > b.ratios + 2 * tau;
}

// Whether rounding could change the level.
bool is_doubtful(const Placement& placement, const std::vector<std::uint32_t>& taken) {
  std::vector<LiftingPoint> points;
  for (const std::uint32_t i : taken) {
    points.push_back(placement.candidates[i].chord.r1);
    points.push_back(placement.candidates[i].chord.r2);
  }
  const auto margin = analyse_closure(placement.polygon(), placement.centre_of_mass, points).margin;
  const auto near = [&](double bound) { return margin && std::fabs(*margin - bound) < 1e-9; };
  return near(0.001) || near(0.4 * usual_margin) || near(usual_margin);
}

template <class Visit>
void for_each_swap(const Placement& placement, Visit visit) {
  const std::vector<std::uint32_t>& taken = placement.team_candidates;
  for (std::uint32_t c = 0; c < placement.candidates.size(); ++c) {
    if (std::find(taken.begin(), taken.end(), c) != taken.end()) continue;
    for (std::size_t team = 0; team < taken.size(); ++team) {
      std::vector<std::uint32_t> swapped = taken;
      swapped[team] = c;
      visit(swapped);
    }
  }
}

// Properties of any teams chosen to hold.
void check_result(const Placement& placement) {
  const HoldKeys keys =
      keys_by_definition(placement, placement.team_candidates, hold_requirements(placement));
  CHECK(keys.coverage == Approx(placement.coverage).margin(1e-9));
  const double clear = 0.02 * farthest_vertex(placement.polygon(), placement.centre_of_mass);
  const Clearance& clearance = placement.closure.clearance;
  const double near = near_distance(placement.polygon().diameter());
  CHECK(placement.goal_reached ==
        (placement.closure.form_closure && clearance.distance >= clear - near &&
         clearance.tolerance >= clear / 2 - near));
  std::vector<std::uint32_t> sorted = placement.team_candidates;
  std::sort(sorted.begin(), sorted.end());
  CHECK(std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end());

  const auto start = select_teams(placement.object, placement.centre_of_mass, placement.candidates,
                                  *metric_of(placement.settings.method), placement.requested_teams,
                                  first_team(placement.settings.positions));
  REQUIRE(start.size() == placement.team_candidates.size());
  CHECK_FALSE(
      clearly_better(keys_by_definition(placement, start, hold_requirements(placement)), keys));
  for_each_swap(placement, [&](const std::vector<std::uint32_t>& swapped) {
    if (clearly_better(keys_by_definition(placement, swapped, hold_requirements(placement)), keys))
      CHECK(is_doubtful(placement, swapped));
  });
}

}  // namespace

TEST_CASE("teams that are swapped are never worse than their start, and no swap is left",
          "[swaps][thorough]") {
  int closed = 0, placed_at_all = 0;
  const auto metrics = testing::metrics();
  for (std::uint64_t number = 0; number < 1200; ++number) {
    Document document = testing::document_of(small_polygons::make_plain_case(number).problem);
    document.settings.min_ratio = 0.8;
    document.settings.method = metrics[number % metrics.size()];
    const auto positions = number % 2 == 0 ? Positions::best : Positions::range;
    const auto placement =
        place(to_hold(document, static_cast<std::uint32_t>(2 + number % 3), positions));
    if (!placement || placement->teams.empty()) continue;
    INFO("case " << number);
    if (placement->candidates.size() <= 60) check_result(*placement);
    ++placed_at_all;
    if (placement->goal_reached) ++closed;
  }
  CHECK(placed_at_all > 950);
  CHECK(closed > placed_at_all / 2);
}

TEST_CASE("two teams among a dozen candidates hold as well as any two", "[swaps][thorough]") {
  int compared = 0;
  for (std::uint64_t number = 0; number < 2000; ++number) {
    Document document = testing::document_of(small_polygons::make_plain_case(number).problem);
    document.settings.min_ratio = 0.8;
    const auto placement = place(to_hold(document, 2, Positions::best));
    if (!placement || placement->teams.size() < 2 || placement->candidates.size() > 12) continue;
    INFO("case " << number);
    ++compared;
    const HoldKeys keys =
        keys_by_definition(*placement, placement->team_candidates, hold_requirements(*placement));
    for (std::uint32_t a = 0; a < placement->candidates.size(); ++a)
      for (std::uint32_t b = a + 1; b < placement->candidates.size(); ++b)
        if (clearly_better(keys_by_definition(*placement, {a, b}, hold_requirements(*placement)),
                           keys))
          CHECK(is_doubtful(*placement, {a, b}));
  }
  CHECK(compared > 500);
}

TEST_CASE("one team more never loses the hold of the samples", "[swaps][thorough]") {
  for (const std::string& name : corpus::polygon_names()) {
    INFO(name);
    for (const Positions positions : {Positions::best, Positions::range}) {
      bool closed = false;
      std::uint32_t level = 0;
      for (std::uint32_t teams = 1; teams <= 5; ++teams) {
        const Placement placement = placed(to_hold(corpus::polygon(name), teams, positions));
        const std::uint32_t now =
            keys_by_definition(placement, placement.team_candidates, hold_requirements(placement))
                .level;
        CHECK(now >= level);
        CHECK(placement.closure.form_closure >= closed);
        closed = placement.closure.form_closure;
        level = now;
      }
    }
  }
}

TEST_CASE("a square in ranges is held by two teams, and by its four best places never", "[swaps]") {
  Document square;
  square.vertices = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  CHECK_FALSE(placed(to_hold(square, 2, Positions::best)).goal_reached);
  const Placement placement = placed(to_hold(square, 4, Positions::range));
  CHECK(placement.goal_reached);
  CHECK(*placement.closure.margin > 0.05);
}

TEST_CASE("the story of the swaps leads from the start to the result", "[swaps][slow]") {
  int swaps = 0, jumps = 0;
  for (const std::string& name : corpus::polygon_names()) {
    INFO(name);
    const Placement placement = placed(to_hold(corpus::polygon(name), 3, Positions::range));
    if (placement.teams.size() < 3) continue;
    const auto start = select_teams(placement.object, placement.centre_of_mass,
                                    placement.candidates, Metric::area, 3, FirstTeam::longest);
    const SwapHistory history =
        swap_teams(placement.object, placement.centre_of_mass, placement.candidates, start,
                   hold_requirements(placement));
    CHECK(history.start == start);
    CHECK(history.taken() == placement.team_candidates);
    CHECK(history.settled);
    HoldKeys keys = history.keys;
    std::vector<std::uint32_t> taken = start;
    for (const Swap& swap : history.swaps) {
      ++swaps;
      CHECK(better_by(swap.keys, keys) == swap.decided_by);
      for (std::uint32_t team = 0; team < taken.size(); ++team) {
        const bool moved =
            std::find(swap.teams.begin(), swap.teams.end(), team) != swap.teams.end();
        CHECK(moved == (swap.taken[team] != taken[team]));
      }
      if (swap.kind == SwapKind::single) CHECK(swap.teams.size() == 1);
      if (swap.kind == SwapKind::one_more) ++jumps;
      taken = swap.taken;
      keys = swap.keys;
    }
  }
  CHECK(swaps > 100);
  CHECK(jumps > 0);
}

TEST_CASE("what cannot be swapped is refused, with the reason", "[swaps]") {
  Settings settings;
  settings.goal = Goal::hold;
  CHECK_FALSE(check_settings(settings));
  for (const Method method : {Method::distributed, Method::random}) {
    settings.method = method;
    REQUIRE(check_settings(settings));
    CHECK(check_settings(settings)->place.option == "goal");
  }
  CHECK_FALSE(check_swaps(100, most_swapped_teams));
  CHECK(check_swaps(100, most_swapped_teams + 1)->place.option == "goal");
  CHECK_FALSE(check_swaps(100, 100));
  CHECK(check_swaps(most_swaps, 2)->place.option == "goal");
  // If too many teams are requested, all candidates are placed.
  const Placement all = placed(to_hold(corpus::polygon("labyrinth"), 1'000'000, Positions::best));
  CHECK(all.teams.size() == all.candidates.size());
}
