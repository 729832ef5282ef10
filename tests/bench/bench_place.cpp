// A whole placement, as the program and the page ask for it: from vertices to loads and closure.
#include "bench/bench.h"
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

// Hard for the bounds by area and distance: the radii are random, so that nearly all ends gain
// about as much.
void hard_for_bounds(benchmark::internal::Benchmark* method) {
  method->ArgNames({"n", "teams"})->Unit(benchmark::kMillisecond);
  for (const std::int64_t n : {1000, 3000, 10000, 30000}) method->Args({n, 3});
}
BENCHMARK_CAPTURE(place, star_by_area, Family::star, Method::area)->Apply(hard_for_bounds);
BENCHMARK_CAPTURE(place, star_by_distance, Family::star, Method::distance)->Apply(hard_for_bounds);

// A capacity that takes nearly two hundred teams, beside a placement that is there already: what
// the page does after an edit, once for all frames until the next one.
void plan(benchmark::State& state, Family family, Method method) {
  Document document = document_of(family, state.range(0));
  document.settings.method = method;
  const Placement placement = *evenlift::place(document);
  CapacityPlan plan;
  for (auto _ : state) {
    plan = plan_capacity(placement, 0.3);
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

}  // namespace
}  // namespace evenlift::bench
