// Where robots with a size can stand, and placements of them.
#include "bench/bench.h"
#include "bench/coast.h"
#include "evenlift/placement.h"
#include "evenlift/stands.h"

namespace evenlift::bench {
namespace {

// In thousandths of L: a body, optionally with an arm and a hand of the same size.
RobotSize size_of(const Polygon& polygon, std::int64_t thousandths, bool hand) {
  const double size = static_cast<double>(thousandths) / 1000 * polygon.diameter();
  return hand ? RobotSize{size, size, size, size, 0} : RobotSize{size, 0, 0, 0, 0};
}

void stands_on_coast(benchmark::State& state, bool hand) {
  const PolygonWithHoles polygon(*Polygon::create(coast().vertices));
  const RobotSize size = size_of(polygon, state.range(0), hand);
  for (auto _ : state) benchmark::DoNotOptimize(Stands(polygon, size, {}).unusable().size());
}

void stands_most_no_go(benchmark::State& state) {
  const PolygonWithHoles polygon(*Polygon::create(coast().vertices));
  std::vector<EdgePart> parts;
  for (std::uint32_t i = 0; i < most_no_go; ++i) parts.push_back({20 * i, 0.25, 0.75});
  const RobotSize size = size_of(polygon, state.range(0), true);
  for (auto _ : state) benchmark::DoNotOptimize(Stands(polygon, size, parts).unusable().size());
}

void place_on_coast(benchmark::State& state) {
  Document document = coast();
  const PolygonWithHoles polygon(*Polygon::create(document.vertices));
  document.settings.robot = size_of(polygon, state.range(0), false);
  for (auto _ : state)
    benchmark::DoNotOptimize(place(polygon, std::nullopt, document.settings)->coverage);
}

BENCHMARK_CAPTURE(stands_on_coast, body, false)
    ->Arg(1)
    ->Arg(3)
    ->Arg(10)
    ->Arg(30)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(stands_on_coast, all, true)
    ->Arg(1)
    ->Arg(3)
    ->Arg(10)
    ->Arg(30)
    ->Unit(benchmark::kMillisecond);
BENCHMARK(stands_most_no_go)->Arg(0)->Arg(3)->Unit(benchmark::kMillisecond);
BENCHMARK(place_on_coast)->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace evenlift::bench
