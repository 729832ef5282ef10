// Teams that are to hold, on the samples and on outlines with many candidates.
#include <algorithm>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "bench/bench.h"
#include "evenlift/formats.h"
#include "evenlift/placement.h"

namespace evenlift::bench {
namespace {

Document to_hold(Document document, std::int64_t teams, Positions positions) {
  document.settings.teams = static_cast<std::uint32_t>(teams);
  document.settings.goal = Goal::hold;
  document.settings.positions = positions;
  return document;
}

// The time of each sample: the mean and the worst.
void hold_on_samples(benchmark::State& state, Positions positions) {
  std::vector<Document> documents;
  for (const auto& entry : std::filesystem::directory_iterator(EVENLIFT_ASSETS_DIR "/polygons")) {
    std::ifstream file(entry.path(), std::ios::binary);
    const auto document = read_polygon(std::string(std::istreambuf_iterator<char>(file), {}));
    if (document) documents.push_back(to_hold(*document, state.range(0), positions));
  }
  double sum = 0, worst = 0, runs = 0;
  for (auto _ : state) {
    for (const Document& document : documents) {
      const std::clock_t begin = std::clock();
      benchmark::DoNotOptimize(place(document));
      const double time = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
      sum += time;
      worst = std::max(worst, time);
      ++runs;
    }
  }
  state.counters["mean_s"] = sum / runs;
  state.counters["worst_s"] = worst;
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
