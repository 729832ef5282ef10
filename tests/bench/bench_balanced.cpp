// The start, which a page shows at once, and the whole search.
#include <utility>

#include "bench/bench.h"
#include "bench/coast.h"
#include "evenlift/balanced.h"

namespace evenlift::bench {
namespace {

enum class Part { start, search };

void run(benchmark::State& state, Document document, Part part) {
  document.settings.method = Method::balanced;
  document.settings.robots = static_cast<std::uint32_t>(state.range(0));
  const PolygonWithHoles polygon(*Polygon::create(document.vertices));
  double coverage = 0;
  for (auto _ : state) {
    const BalancedProblem problem(polygon, polygon.centroid(), document.settings);
    BalancedSearch search = *start_balanced(problem);
    if (part == Part::search) search = finish_search(problem, std::move(search));
    coverage = balanced_keys(problem, search.robots).coverage;
    benchmark::DoNotOptimize(coverage);
  }
  state.counters["coverage"] = coverage;
}

void balanced(benchmark::State& state, Family family, std::int64_t n, Part part) {
  run(state, document_of(family, n), part);
}

void balanced_on_coast(benchmark::State& state, Part part) { run(state, coast(), part); }

void balanced_surviving(benchmark::State& state) {
  Document document = coast();
  document.settings.survive = most_survived;
  run(state, std::move(document), Part::search);
}

void balanced_on_samples(benchmark::State& state) {
  std::vector<Document> documents = samples();
  for (Document& document : documents) {
    document.settings.method = Method::balanced;
    document.settings.robots = static_cast<std::uint32_t>(state.range(0));
  }
  time_each(state, documents, [](const Document& document) {
    const PolygonWithHoles polygon(*Polygon::create(document.vertices));
    const Vec2 centre = *check_centre_of_mass(polygon, document.centre_of_mass);
    const BalancedProblem problem(polygon, centre, document.settings);
    benchmark::DoNotOptimize(finish_search(problem, *start_balanced(problem)));
  });
}

void robots(benchmark::internal::Benchmark* b) {
  b->ArgName("robots")->Unit(benchmark::kMillisecond)->Arg(4)->Arg(6)->Arg(8)->Arg(12);
}
void six_robots(benchmark::internal::Benchmark* b) {
  b->ArgName("robots")->Unit(benchmark::kMillisecond)->Arg(6);
}

// On outlines of some 20,000 vertices.
void up_to_most_robots(benchmark::internal::Benchmark* b) {
  b->ArgName("robots")->Unit(benchmark::kMillisecond)->Arg(4)->Arg(6)->Arg(8)->Arg(most_robots);
}
void from_4_to_8(benchmark::internal::Benchmark* b) {
  b->ArgName("robots")->Unit(benchmark::kMillisecond)->Arg(4)->Arg(6)->Arg(8);
}

// The experiment's numbers of robots, and larger ones.
void numbers_of_robots(benchmark::internal::Benchmark* b) {
  b->ArgName("robots")->Unit(benchmark::kMillisecond);
  for (const int robots : {3, 4, 6, 8, 10, 12, 16, 24, 36}) b->Arg(robots);
}

BENCHMARK(balanced_on_samples)->Apply(numbers_of_robots);
BENCHMARK_CAPTURE(balanced, random_50_start, Family::random, 50, Part::start)->Apply(robots);
BENCHMARK_CAPTURE(balanced, random_50, Family::random, 50, Part::search)->Apply(robots);
BENCHMARK_CAPTURE(balanced, comb_50, Family::comb, 50, Part::search)->Apply(six_robots);
BENCHMARK_CAPTURE(balanced, star_50, Family::star, 50, Part::search)->Apply(six_robots);
BENCHMARK_CAPTURE(balanced_on_coast, start, Part::start)->Apply(up_to_most_robots);
BENCHMARK_CAPTURE(balanced_on_coast, search, Part::search)->Apply(up_to_most_robots);
// These end by most_work.
BENCHMARK_CAPTURE(balanced, most_work_random, Family::random, 20000, Part::search)
    ->Apply(from_4_to_8);
BENCHMARK_CAPTURE(balanced, most_work_star, Family::star, 20000, Part::search)->Apply(from_4_to_8);
BENCHMARK_CAPTURE(balanced, most_work_comb, Family::comb, 2000, Part::search)->Apply(six_robots);
BENCHMARK(balanced_surviving)
    ->ArgName("robots")
    ->Unit(benchmark::kMillisecond)
    ->Arg(2 * most_survived + 3);

}  // namespace
}  // namespace evenlift::bench
