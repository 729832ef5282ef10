// Teams that are to hold, on the samples and on outlines with many candidates.
#include <vector>

#include "bench/bench.h"
#include "evenlift/placement.h"

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

void hold(benchmark::State& state, Family family, Positions positions) {
  const Document document = to_hold(document_of(family, state.range(0)), 3, positions);
  for (auto _ : state) benchmark::DoNotOptimize(place(document));
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

}  // namespace
}  // namespace evenlift::bench
