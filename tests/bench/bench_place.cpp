// From vertices to loads and closure.
#include "bench/bench.h"
#include "bench/coast.h"
#include "evenlift/angles.h"
#include "evenlift/capacity.h"
#include "evenlift/placement.h"

namespace evenlift::bench {
namespace {

void place(benchmark::State& state, Family family, Method method) {
  Document document = document_of(family, state.range(0));
  document.settings.method = method;
  document.settings.teams = static_cast<std::uint32_t>(state.range(1));
  std::size_t found = 0;
  for (auto _ : state) {
    const auto placement = evenlift::place(document);
    found = placement->candidates.size();
    benchmark::DoNotOptimize(found);
  }
  state.counters["candidates"] = static_cast<double>(found);
}

void for_20_teams(benchmark::internal::Benchmark* method) {
  method->ArgNames({"n", "teams"})->Unit(benchmark::kMillisecond)->Args({1000, 20});
}
void for_20_teams_twice(benchmark::internal::Benchmark* method) {
  for_20_teams(method);
  method->Args({10000, 20});
}

BENCHMARK_CAPTURE(place, random_by_area, Family::random, Method::area)->Apply(for_20_teams_twice);
BENCHMARK_CAPTURE(place, random_by_circle, Family::random, Method::circle)
    ->Apply(for_20_teams_twice);
BENCHMARK_CAPTURE(place, random_by_distance, Family::random, Method::distance)
    ->Apply(for_20_teams_twice);
BENCHMARK_CAPTURE(place, random_distributed, Family::random, Method::distributed)
    ->Apply(for_20_teams_twice);
BENCHMARK_CAPTURE(place, random_at_random, Family::random, Method::random)
    ->Apply(for_20_teams_twice);
BENCHMARK_CAPTURE(place, comb_by_area, Family::comb, Method::area)->Apply(for_20_teams);
BENCHMARK_CAPTURE(place, comb_by_circle, Family::comb, Method::circle)->Apply(for_20_teams);
BENCHMARK_CAPTURE(place, comb_by_distance, Family::comb, Method::distance)->Apply(for_20_teams);
BENCHMARK_CAPTURE(place, comb_distributed, Family::comb, Method::distributed)->Apply(for_20_teams);
BENCHMARK_CAPTURE(place, comb_at_random, Family::comb, Method::random)->Apply(for_20_teams);

// Hard for the bounds: radii are random, so nearly all ends gain the same area or distance.
void hard_for_bounds(benchmark::internal::Benchmark* method) {
  method->ArgNames({"n", "teams"})->Unit(benchmark::kMillisecond);
  for (const std::int64_t n : {1000, 3000, 10000, 30000}) method->Args({n, 3});
}
BENCHMARK_CAPTURE(place, star_by_area, Family::star, Method::area)->Apply(hard_for_bounds);
BENCHMARK_CAPTURE(place, star_by_distance, Family::star, Method::distance)->Apply(hard_for_bounds);

// A capacity that needs nearly two hundred teams, for an existing placement: the page does this
// once after an edit.
void plan(benchmark::State& state, Family family, Method method, double capacity = 0.3) {
  Document document = document_of(family, state.range(0));
  document.settings.method = method;
  const Placement placement = *evenlift::place(document);
  CapacityPlan plan;
  for (auto _ : state) {
    plan = plan_capacity(placement, capacity);
    benchmark::DoNotOptimize(plan);
  }
  state.counters["teams"] = plan.teams;
}

void of_1000(benchmark::internal::Benchmark* method) {
  method->ArgName("n")->Unit(benchmark::kMillisecond)->Arg(1000);
}
BENCHMARK_CAPTURE(plan, comb_by_area, Family::comb, Method::area)->Apply(of_1000);
BENCHMARK_CAPTURE(plan, comb_by_circle, Family::comb, Method::circle)->Apply(of_1000);
BENCHMARK_CAPTURE(plan, comb_by_distance, Family::comb, Method::distance)->Apply(of_1000);
BENCHMARK_CAPTURE(plan, comb_distributed, Family::comb, Method::distributed)->Apply(of_1000);
BENCHMARK_CAPTURE(plan, comb_at_random, Family::comb, Method::random)->Apply(of_1000);

// --- At the limits

// The most vertices and teams permitted.
void at_most(benchmark::internal::Benchmark* method) {
  method->ArgNames({"n", "teams"})->Unit(benchmark::kMillisecond);
}
BENCHMARK_CAPTURE(place, max_vertices, Family::convex, Method::area)
    ->Apply(at_most)
    ->Args({max_vertices, 50});
BENCHMARK_CAPTURE(place, max_teams_distributed, Family::random, Method::distributed)
    ->Apply(at_most)
    ->Args({1000, max_teams});

void read_max_vertices(benchmark::State& state) {
  const std::string text = write_thesis(document_of(Family::convex, max_vertices));
  for (auto _ : state) benchmark::DoNotOptimize(read_polygon(text));
  state.counters["bytes"] = static_cast<double>(text.size());
}
BENCHMARK(read_max_vertices)->Unit(benchmark::kMillisecond);

// A tilted square: all contacts of a side are aligned, and rounding separates their normals.
Document tilted_square(int on_each_side) {
  const Vec2 right = 1000 * Vec2(cosine(0.3), sine(0.3)), up = left_normal(right);
  const Vec2 corners[] = {Vec2{}, right, right + up, up};
  Document document;
  for (std::size_t side = 0; side < 4; ++side)
    for (int i = 0; i < on_each_side; ++i)
      document.vertices.push_back(corners[side] +
                                  (corners[(side + 1) % 4] - corners[side]) * i / on_each_side);
  return document;
}

// A team on every candidate.
void place_all(benchmark::State& state, Document document) {
  document.settings.teams.reset();
  std::size_t teams = 0;
  for (auto _ : state) {
    teams = evenlift::place(document)->teams.size();
    benchmark::DoNotOptimize(teams);
  }
  state.counters["teams"] = static_cast<double>(teams);
}
BENCHMARK_CAPTURE(place_all, aligned_contacts, tilted_square(4000))->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(place_all, corners_of_base, document_of(Family::convex, 16000))
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(place_all, star, document_of(Family::star, 20000))->Unit(benchmark::kMillisecond);

// No number of teams that is tried keeps all loads within this.
BENCHMARK_CAPTURE(plan, most_teams_for_capacity, Family::comb, Method::area, 0.05)->Apply(of_1000);

// A plan that finds no number; for balanced robots, one found after some searches.
void plan_failures(benchmark::State& state, Document document, Settings settings, double capacity) {
  document.settings = std::move(settings);
  const Placement placement = *evenlift::place(document);
  FailurePlan plan;
  for (auto _ : state) {
    plan = plan_for_failures(placement, capacity);
    benchmark::DoNotOptimize(plan);
  }
  state.counters["tried"] = plan.tried;
}
BENCHMARK_CAPTURE(plan_failures, most_loads_planned, document_of(Family::comb, 1000),
                  Settings{.method = Method::distributed}, 0.3)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(plan_failures, most_swapped_teams, document_of(Family::random, 200),
                  (Settings{.goal = Goal::hold, .positions = Positions::range}), 1.7)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(plan_failures, most_sets_planned, coast(), Settings{.method = Method::balanced},
                  2)
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace evenlift::bench
