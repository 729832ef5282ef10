// From a polygon to its candidates: validation in O(n log n), edge pairs in O(n log n + K).
#include "bench/bench.h"
#include "evenlift/candidates.h"

namespace evenlift::bench {
namespace {

void validate(benchmark::State& state, Family family) {
  const Document document = document_of(family, state.range(0));
  for (auto _ : state) benchmark::DoNotOptimize(Polygon::create(document.vertices));
  count_time_per(state, "per_(n_log_n)", n_log_n(polygon_of(family, state.range(0))));
}

void pairs(benchmark::State& state, Family family) {
  const Polygon polygon = polygon_of(family, state.range(0));
  for (auto _ : state) benchmark::DoNotOptimize(edge_pairs(polygon, polygon.centroid()));
  count_pairs(state, polygon);
}

void candidates(benchmark::State& state, Family family, Positions positions = Positions::best) {
  const Polygon polygon = polygon_of(family, state.range(0));
  std::size_t found = 0;
  for (auto _ : state) {
    const auto list = find_candidates(polygon, polygon.centroid(), Settings{}.min_ratio, positions);
    found = list->size();
    benchmark::DoNotOptimize(found);
  }
  count_pairs(state, polygon);
  state.counters["candidates"] = static_cast<double>(found);
}

void up_to_256k(benchmark::internal::Benchmark* family) {
  family->RangeMultiplier(4)->Range(1 << 10, 1 << 18)->ArgName("n")->Unit(benchmark::kMillisecond);
}
void up_to_4k(benchmark::internal::Benchmark* family) {
  family->RangeMultiplier(2)->Range(1 << 8, 1 << 12)->ArgName("n")->Unit(benchmark::kMillisecond);
}

BENCHMARK_CAPTURE(validate, star, Family::star)->Apply(up_to_256k);
BENCHMARK_CAPTURE(pairs, star, Family::star)->Apply(up_to_256k);
BENCHMARK_CAPTURE(pairs, comb, Family::comb)->Apply(up_to_4k);
BENCHMARK_CAPTURE(candidates, star, Family::star)->Apply(up_to_256k);
BENCHMARK_CAPTURE(candidates, comb, Family::comb)->Apply(up_to_4k);

// The most vertices and edge pairs; with positions in ranges, a third of the pairs.
template <std::int64_t n>
void of_n(benchmark::internal::Benchmark* family) {
  family->ArgName("n")->Unit(benchmark::kMillisecond)->Arg(n);
}
BENCHMARK_CAPTURE(validate, max_vertices, Family::convex)->Apply(of_n<max_vertices>);
BENCHMARK_CAPTURE(candidates, max_vertices, Family::convex)->Apply(of_n<max_vertices>);
BENCHMARK_CAPTURE(candidates, max_edge_pairs, Family::comb)->Apply(of_n<5792>);
BENCHMARK_CAPTURE(candidates, max_edge_pairs_in_ranges, Family::comb, Positions::range)
    ->Apply(of_n<3344>);

}  // namespace
}  // namespace evenlift::bench
