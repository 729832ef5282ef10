// The slowest placements over the families of polygons: at most 1,000 vertices and 64 robots take at
// most 10 s, larger ones 60 s (docs/performance.md). `cut` is 1 if a limit of work ended the search.
#include "bench/bench.h"
#include "evenlift/placement.h"

namespace evenlift::bench {
namespace {

void time_place(benchmark::State& state, Document document) {
  bool cut_short = false;
  for (auto _ : state) {
    const auto placement = place(document);
    if (!placement) return state.SkipWithError(placement.error().message.c_str());
    cut_short = placement->cut_short;
  }
  state.counters["cut"] = cut_short ? 1 : 0;
}

void bounds_balanced(benchmark::State& state, Family family) {
  Document document = document_of(family, state.range(0));
  document.settings.method = Method::balanced;
  document.settings.robots = static_cast<std::uint32_t>(state.range(1));
  time_place(state, std::move(document));
}

void bounds_hold(benchmark::State& state, Family family, Positions positions) {
  Document document = document_of(family, state.range(0));
  document.settings.goal = Goal::hold;
  document.settings.positions = positions;
  document.settings.teams = static_cast<std::uint32_t>(state.range(1));
  time_place(state, std::move(document));
}

void bounds_all_candidates(benchmark::State& state, Family family) {
  Document document = document_of(family, state.range(0));
  document.settings.teams.reset();
  time_place(state, std::move(document));
}

void once(benchmark::internal::Benchmark* b) { b->Unit(benchmark::kMillisecond)->Iterations(1); }

void sizes(benchmark::internal::Benchmark* b) {
  once(b);
  b->ArgNames({"n", "robots"});
  for (const int robots : {6, 24, 64}) b->Args({1000, robots});
}
// A comb of more vertices has too many pairs of facing edges.
template <int n>
void large(benchmark::internal::Benchmark* b) {
  once(b);
  b->ArgNames({"n", "robots"});
  for (const int robots : {6, 64}) b->Args({n, robots});
}
void team_sizes(benchmark::internal::Benchmark* b) {
  once(b);
  b->ArgNames({"n", "teams"});
  for (const int teams : {3, 8, 32}) b->Args({1000, teams});
}
void doubled(benchmark::internal::Benchmark* b) {
  once(b);
  b->ArgName("n")->Arg(50000)->Arg(100000);
}

#define FOR_FAMILY(family, n)                                                                \
  BENCHMARK_CAPTURE(bounds_balanced, family, Family::family)->Apply(sizes)->Apply(large<n>); \
  BENCHMARK_CAPTURE(bounds_hold, family##_best, Family::family, Positions::best)             \
      ->Apply(team_sizes);                                                                   \
  BENCHMARK_CAPTURE(bounds_hold, family##_range, Family::family, Positions::range)           \
      ->Apply(team_sizes)

FOR_FAMILY(regular, 50000);
FOR_FAMILY(convex, 50000);
FOR_FAMILY(star, 50000);
FOR_FAMILY(comb, 5000);
FOR_FAMILY(spiral, 50000);
FOR_FAMILY(random, 50000);

BENCHMARK_CAPTURE(bounds_all_candidates, convex, Family::convex)->Apply(doubled);
BENCHMARK_CAPTURE(bounds_all_candidates, regular, Family::regular)->Apply(doubled);

}  // namespace
}  // namespace evenlift::bench
