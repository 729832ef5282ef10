// On samples and outlines with many candidates.
#include <vector>

#include "bench/bench.h"
#include "evenlift/placement.h"
#include "evenlift/swaps.h"

namespace evenlift::bench {
namespace {

Document to_hold(Document document, std::int64_t teams, Positions positions) {
  document.settings.teams = static_cast<std::uint32_t>(teams);
  document.settings.goal = Goal::hold;
  document.settings.positions = positions;
  return document;
}

void hold_on_samples(benchmark::State& state, Positions positions) {
  std::vector<Document> documents = samples();
  for (Document& document : documents) document = to_hold(document, state.range(0), positions);
  time_each(state, documents,
            [](const Document& document) { benchmark::DoNotOptimize(place(document)); });
}

void hold(benchmark::State& state, Family family, Positions positions, std::int64_t teams = 3) {
  const Document document = to_hold(document_of(family, state.range(0)), teams, positions);
  for (auto _ : state) benchmark::DoNotOptimize(place(document));
}

// Teams among candidates in ranges, evenly picked from a comb's.
void swap(benchmark::State& state) {
  const PolygonWithHoles polygon(polygon_of(Family::comb, 1000));
  const Settings settings = to_hold({}, state.range(0), Positions::range).settings;
  const std::vector<Candidate> all =
      *find_candidates(polygon, polygon.centroid(), settings.min_ratio, settings.positions);
  const auto number = static_cast<std::size_t>(state.range(1));
  std::vector<Candidate> picked;
  for (std::size_t i = 0; i < number; ++i) picked.push_back(all[i * all.size() / number]);
  for (auto _ : state)
    benchmark::DoNotOptimize(
        choose_candidates(polygon, polygon.centroid(), picked, settings, *settings.teams));
}

void teams(benchmark::internal::Benchmark* b) {
  b->ArgName("teams")->Unit(benchmark::kMillisecond)->Arg(2)->Arg(3)->Arg(4)->Arg(8);
}
void of_1000(benchmark::internal::Benchmark* b) {
  b->ArgName("n")->Unit(benchmark::kMillisecond)->Arg(1000);
}

BENCHMARK_CAPTURE(hold_on_samples, best, Positions::best)->Apply(teams);
BENCHMARK_CAPTURE(hold_on_samples, range, Positions::range)->Apply(teams);
BENCHMARK_CAPTURE(hold, spiral, Family::spiral, Positions::range)->Apply(of_1000);
BENCHMARK_CAPTURE(hold, comb, Family::comb, Positions::best)->Apply(of_1000);

// At the limits: the t^3 K up to which the page swaps t teams during a drag, and after it; the most
// candidates for swapping two teams at once; the most teams; and the part of most_swaps in a round
// that max_edge_pairs permits.
template <std::int64_t n>
void of_n(benchmark::internal::Benchmark* b) {
  b->ArgName("n")->Unit(benchmark::kMillisecond)->Arg(n);
}
BENCHMARK(swap)
    ->ArgNames({"teams", "K"})
    ->Unit(benchmark::kMillisecond)
    ->Args({3, 1851})
    ->Args({8, 15625});
BENCHMARK_CAPTURE(hold, most_candidates_for_pairs, Family::convex, Positions::best, 2)
    ->Apply(of_n<106>);
BENCHMARK_CAPTURE(hold, most_swapped_teams, Family::regular, Positions::best, most_swapped_teams)
    ->Apply(of_n<200>);
BENCHMARK_CAPTURE(hold, most_swaps, Family::comb, Positions::range, 2)->Apply(of_n<3344>);

}  // namespace
}  // namespace evenlift::bench
