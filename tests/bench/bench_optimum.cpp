// With the most candidates for which it is proved, bounded or compared.
#include <vector>

#include "bench/bench.h"
#include "evenlift/optimum.h"

namespace evenlift::bench {
namespace {

// Of a convex polygon that has more.
std::vector<Candidate> candidates_of(const Polygon& polygon, std::size_t number) {
  std::vector<Candidate> all =
      *find_candidates(polygon, polygon.centroid(), Settings{}.min_ratio, Positions::best);
  all.resize(number);
  return all;
}

std::vector<std::uint32_t> first(std::int64_t teams) {
  std::vector<std::uint32_t> start;
  for (std::uint32_t i = 0; i < teams; ++i) start.push_back(i);
  return start;
}

void widest(benchmark::State& state, std::size_t number) {
  const PolygonWithHoles polygon(polygon_of(Family::convex, 800));
  const std::vector<Candidate> candidates = candidates_of(polygon, number);
  const std::vector<std::uint32_t> start = first(state.range(0));
  bool proved = false;
  for (auto _ : state) {
    proved = widest_choice(polygon, polygon.centroid(), candidates, start.size(), start).proved;
    benchmark::DoNotOptimize(proved);
  }
  state.counters["proved"] = proved;
}

// 294 candidates give 4,192,244 choices of three teams; 295 give more than most_choices.
void to_hold_most_choices(benchmark::State& state) {
  const PolygonWithHoles polygon(polygon_of(Family::convex, 800));
  const Vec2& centre = polygon.centroid();
  const std::vector<Candidate> candidates = candidates_of(polygon, 294);
  const std::vector<std::uint32_t> start = first(3);
  const Optimum optimum = widest_choice(polygon, centre, candidates, start.size(), start);
  const HoldRequirements hold = hold_requirements(polygon, centre, {});
  bool compared = false;
  for (auto _ : state) {
    compared =
        choice_to_hold(polygon, centre, candidates, start.size(), start, hold, optimum)->compared;
    benchmark::DoNotOptimize(compared);
  }
  state.counters["compared"] = compared;
}

void few_teams(benchmark::internal::Benchmark* b) {
  b->ArgName("teams")->Unit(benchmark::kMillisecond)->Arg(3);
}
BENCHMARK_CAPTURE(widest, most_candidates_proved, most_candidates_proved)
    ->Apply(few_teams)
    ->Arg(10);
BENCHMARK_CAPTURE(widest, most_candidates_bounded, most_candidates_bounded)->Apply(few_teams);
BENCHMARK(to_hold_most_choices)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace evenlift::bench
