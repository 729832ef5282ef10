// The check of all rings, the coverage, and a placement.
#include <vector>

#include "bench/bench.h"
#include "evenlift/hull.h"
#include "evenlift/placement.h"
#include "evenlift/polygon_with_holes.h"
#include "evenlift/stability.h"

namespace evenlift::bench {
namespace {

constexpr std::int64_t in_a_row = 32;

// A square plate with `max_holes` stars in rows, n vertices in all.
Document plate(std::int64_t n) {
  const auto each = static_cast<std::size_t>(n) / max_holes;
  const Points star = *generate(Family::star, each, seed);  // in 0 .. 1000
  Document document;
  const double size = 1100.0 * in_a_row;
  document.vertices = {{-100, -100}, {size, -100}, {size, size}, {-100, size}};
  for (std::int64_t i = 0; i < static_cast<std::int64_t>(max_holes); ++i) {
    const Vec2 at(1100.0 * static_cast<double>(i % in_a_row),
                  1100.0 * static_cast<double>(i / in_a_row));
    Points& hole = document.holes.emplace_back();
    for (const Vec2& v : star) hole.push_back(at + v);
  }
  return document;
}

void create_with_holes(benchmark::State& state) {
  const Document document = plate(state.range(0));
  for (auto _ : state) benchmark::DoNotOptimize(object_of(document)->area());
  const auto n = static_cast<double>(state.range(0));
  count_time_per(state, "per_n_log_n", n * std::log2(n));
}

void coverage_with_holes(benchmark::State& state) {
  const PolygonWithHoles object = *object_of(plate(state.range(0)));
  const double size = 1100.0 * in_a_row;
  const Points hull{{0, size / 3}, {size / 2, 0}, {size, size / 2}, {size / 2, size}};
  for (auto _ : state) benchmark::DoNotOptimize(coverage(object, hull));
  count_time_per(state, "per_n", static_cast<double>(state.range(0)));
}

void place_with_holes(benchmark::State& state) {
  const PolygonWithHoles object = *object_of(plate(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(place(object, std::nullopt, Settings{})->coverage);
}

void of_many(benchmark::internal::Benchmark* b) {
  b->ArgName("n")->Unit(benchmark::kMillisecond)->Arg(10'000)->Arg(100'000)->Arg(1'000'000);
}

BENCHMARK(create_with_holes)->Apply(of_many);
BENCHMARK(coverage_with_holes)->Apply(of_many);
BENCHMARK(place_with_holes)->Apply(of_many);

}  // namespace
}  // namespace evenlift::bench
