#include "bench/bench.h"
#include "evenlift/placed_robots.h"

namespace evenlift::bench {
namespace {

Placement placement_of(benchmark::State& state) {
  Document document = document_of(Family::random, 1000);
  document.settings.teams = static_cast<std::uint32_t>(state.range(0));
  document.settings.method = Method::distributed;  // finds places for any number of teams
  return *evenlift::place(document);
}

void robustness_always(benchmark::State& state) {
  const Placement placement = placement_of(state);
  for (auto _ : state) {
    benchmark::DoNotOptimize(model_loads(placement));
    benchmark::DoNotOptimize(robustness(placement));
  }
}

void robustness_failures(benchmark::State& state) {
  const Placement placement = placement_of(state);
  for (auto _ : state) benchmark::DoNotOptimize(single_failures(placement));
}

BENCHMARK(robustness_always)
    ->ArgName("teams")
    ->Unit(benchmark::kMillisecond)
    ->Arg(3)
    ->Arg(50)
    ->Arg(1000)
    ->Arg(max_teams);
// Up to the number that the page analyses.
BENCHMARK(robustness_failures)
    ->ArgName("teams")
    ->Unit(benchmark::kMillisecond)
    ->Arg(3)
    ->Arg(50)
    ->Arg(64);

}  // namespace
}  // namespace evenlift::bench
