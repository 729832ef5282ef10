// The cost of a trace, and of looking at a step.
#include <string>

#include "bench/bench.h"
#include "evenlift/lesson.h"
#include "evenlift/output/trace_words.h"
#include "evenlift/placement.h"
#include "evenlift/trace.h"
#include "evenlift/why_not.h"

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

// Details, shapes and words of the last team's step, which cost the most.
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

// --- At the limits

// "Why not this one?" about a spiral's vertex with many chords through it and C.
void why_not_most_chords(benchmark::State& state) {
  const Trace trace = *make_trace(placement_of(Family::spiral, state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(chord_at(trace, trace.polygon().vertex(0)));
}

// The most bytes and steps permitted.
void parse_max_lesson(benchmark::State& state) {
  std::string text = "title: Long\npolygon: square\n";
  for (std::size_t step = 1; step <= max_lesson_steps; ++step)
    text += "\n[step " + std::to_string(step) + "]\n" + std::string(300, 'a') + "\n";
  text = '#' + std::string(max_lesson_bytes - text.size() - 2, ' ') + '\n' + text;
  std::size_t steps = 0;
  for (auto _ : state) {
    steps = parse_lesson(text)->steps.size();
    benchmark::DoNotOptimize(steps);
  }
  state.counters["steps"] = static_cast<double>(steps);
}

template <std::int64_t n>
void of_n(benchmark::internal::Benchmark* shape) {
  shape->ArgName("n")->Unit(benchmark::kMillisecond)->Arg(n);
}
BENCHMARK_CAPTURE(trace, max_trace_steps, Family::comb)->Apply(of_n<1440>);
BENCHMARK_CAPTURE(look, exact_score_budget, Family::random, StepKind::scores)->Apply(of_n<1200>);
BENCHMARK(why_not_most_chords)->Apply(thousand);
BENCHMARK(parse_max_lesson)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace evenlift::bench
