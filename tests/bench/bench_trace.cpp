// The lesson: what a trace costs once, and what a step costs when it is looked at.
#include "bench/bench.h"
#include "evenlift/output/trace_words.h"
#include "evenlift/placement.h"
#include "evenlift/trace.h"

namespace evenlift::bench {
namespace {

Placement placement_of(Family family, std::int64_t n) {
  Document document = document_of(family, n);
  document.settings.teams = 20;
  return *evenlift::place(document);
}

void trace(benchmark::State& state, Family family) {
  const Placement placement = placement_of(family, state.range(0));
  std::uint32_t steps = 0;
  for (auto _ : state) {
    const Result<Trace> trace = make_trace(placement);
    steps = trace->size();
    benchmark::DoNotOptimize(steps);
  }
  state.counters["steps"] = steps;
}

// A step's details, shapes and words; of the last team, the dearest.
void look(benchmark::State& state, Family family, StepKind kind) {
  const Trace trace = *make_trace(placement_of(family, state.range(0)));
  const std::uint32_t k = *trace.find(kind, trace.count(kind) - 1);
  std::size_t size = 0;
  for (auto _ : state) {
    const StepDetail detail = look_at(trace, k);
    size = figures(trace, detail).size() + caption(trace, detail).size() +
           formula(trace, detail).size() + progress_at(trace, k).cuts;
    benchmark::DoNotOptimize(size);
  }
}

void thousand(benchmark::internal::Benchmark* shape) {
  shape->ArgName("n")->Unit(benchmark::kMillisecond)->Arg(1000);
}
BENCHMARK_CAPTURE(trace, random, Family::random)->Apply(thousand);
BENCHMARK_CAPTURE(trace, comb, Family::comb)->Apply(thousand);
BENCHMARK_CAPTURE(look, random_ray, Family::random, StepKind::ray)->Apply(thousand);
BENCHMARK_CAPTURE(look, random_outcome, Family::random, StepKind::outcome)->Apply(thousand);
BENCHMARK_CAPTURE(look, random_scores, Family::random, StepKind::scores)->Apply(thousand);
BENCHMARK_CAPTURE(look, random_base, Family::random, StepKind::base)->Apply(thousand);
BENCHMARK_CAPTURE(look, random_cut, Family::random, StepKind::cut)->Apply(thousand);
BENCHMARK_CAPTURE(look, comb_slopes, Family::comb, StepKind::slopes)->Apply(thousand);
BENCHMARK_CAPTURE(look, comb_outcome, Family::comb, StepKind::outcome)->Apply(thousand);
BENCHMARK_CAPTURE(look, comb_scores, Family::comb, StepKind::scores)->Apply(thousand);

}  // namespace
}  // namespace evenlift::bench
