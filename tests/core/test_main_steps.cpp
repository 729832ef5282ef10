// The same story for every polygon, in about fifteen steps.
#include <algorithm>

#include "evenlift/generate.h"
#include "evenlift/main_steps.h"
#include "evenlift/placement.h"
#include "kit/catch.h"
#include "kit/corpus.h"
#include "kit/placed.h"
#include "kit/traced.h"

using namespace evenlift;
using evenlift::testing::placed;
using evenlift::testing::traced;

namespace {

std::size_t of_kind(const Trace& trace, const std::vector<std::uint32_t>& steps, StepKind kind) {
  return static_cast<std::size_t>(std::count_if(
      steps.begin(), steps.end(), [&](std::uint32_t k) { return trace.step(k).kind == kind; }));
}

void check(const Trace& trace) {
  const std::vector<std::uint32_t> steps = main_steps(trace);
  REQUIRE(steps.size() >= 3);
  CHECK(steps.size() <= most_main_steps);
  CHECK(steps.front() == 0);
  CHECK(steps.back() == trace.size() - 1);
  CHECK(std::is_sorted(steps.begin(), steps.end()));
  CHECK(std::adjacent_find(steps.begin(), steps.end()) == steps.end());
  const auto teams = trace.placement.teams.size();
  CHECK(of_kind(trace, steps, StepKind::team) == std::min<std::size_t>(teams, 4));
  // Each chapter has a main step.
  for (std::uint32_t c = 0; c < chapter_count; ++c) {
    const auto chapter = static_cast<Chapter>(c);
    const bool told = std::any_of(steps.begin(), steps.end(), [&](std::uint32_t k) {
      return trace.step(k).chapter == chapter;
    });
    CHECK(told == trace.chapter_begin(chapter).has_value());
  }
  // Steps and omitted items together cover every pair, ray and team.
  for (const std::uint32_t k : steps) {
    const Step step = trace.step(k);
    const std::uint32_t more = further_like(trace, step);
    if (step.kind == StepKind::outcome) CHECK(more + 1 == trace.count(StepKind::outcome));
    if (step.kind == StepKind::ray) CHECK(more + 1 == trace.count(StepKind::ray));
    if (step.kind == StepKind::team && step.item == 2 && teams > 4) CHECK(more + 4 == teams);
  }
}

}  // namespace

TEST_CASE("main steps begin with the polygon, end with the result, and are few", "[trace][slow]") {
  for (const std::string& name : corpus::polygon_names()) {
    INFO(name);
    for (const Method method : pair_methods)
      for (const std::uint32_t teams : {1u, 3u, 9u})
        check(traced(placed(corpus::polygon(name), method, teams)));
  }
}

TEST_CASE("of thousands of steps, the main ones are still few", "[trace]") {
  const Result<Points> comb = generate(Family::comb, 300, 1);
  REQUIRE(comb);
  Document document;
  document.vertices = *comb;
  const Trace trace = traced(placed(document, Method::area, 20));
  CHECK(trace.size() > 1000);
  check(trace);
}

TEST_CASE("the pair that stands for all led to a candidate, if any did", "[trace]") {
  int told = 0;
  for (const std::string& name : corpus::polygon_names()) {
    INFO(name);
    const Trace trace = traced(placed(corpus::polygon(name)));
    const bool any = std::any_of(
        trace.candidate_of_source.begin(),
        trace.candidate_of_source.begin() + static_cast<std::ptrdiff_t>(trace.pairs.size()),
        [](std::uint32_t c) { return c != no_index; });
    if (!any) continue;
    for (const std::uint32_t k : main_steps(trace)) {
      if (trace.step(k).kind != StepKind::outcome) continue;
      CHECK(look_at_pair(trace, trace.step(k).item).candidate.has_value());
      ++told;
    }
  }
  CHECK(told > 90);
}
