// The trace: every step of every sample polygon, at once and in any order.
#include <cmath>

#include "catch.h"
#include "corpus.h"
#include "evenlift/placement.h"
#include "evenlift/trace.h"
#include "evenlift/why_not.h"

using namespace evenlift;

namespace {

Placement placed(Document document, Metric metric = Metric::area, std::uint32_t teams = 3) {
  document.settings.metric = metric;
  document.settings.teams = teams;
  Result<Placement> placement = place(document);
  REQUIRE(placement.ok());
  return *std::move(placement);
}

Trace traced(const Placement& placement) {
  Result<Trace> trace = make_trace(placement);
  REQUIRE(trace.ok());
  return *std::move(trace);
}

}  // namespace

TEST_CASE("the trace ends in the state that place reports", "[trace]") {
  for (const std::string& name : corpus::polygon_names()) {
    for (const Metric metric : all_metrics) {
      INFO(name << ' ' << evenlift::name(metric));
      const Placement placement = placed(corpus::polygon(name), metric);
      const Trace trace = traced(placement);
      const Done end = done(trace, trace.size() - 1);
      CHECK(end.teams == placement.teams.size());
      CHECK(lifting_base(trace, end.base_teams) == placement.hull);
      CHECK(end.shares == placement.teams.size());
      CHECK(end.cuts == trace.contacts.size());
      if (!placement.teams.empty()) CHECK(end.closure);
      if (!trace.by_candidates()) continue;
      CHECK(end.merged);
      CHECK(end.pairs == trace.pairs.size());
      CHECK(trace.pair_of_candidate.size() == placement.candidates.size());
      for (std::uint32_t team = 0; team < placement.teams.size(); ++team)
        CHECK(look_at_scores(trace, team).ranking.front() ==
              static_cast<std::uint32_t>(placement.team_candidates[team]));
    }
  }
}

TEST_CASE("every step is found again from its kind and item", "[trace]") {
  for (const std::string& name : corpus::polygon_names()) {
    for (const Metric metric : all_metrics) {
      const Trace trace = traced(placed(corpus::polygon(name), metric));
      INFO(name << ' ' << evenlift::name(metric));
      std::uint32_t steps = 0;
      for (std::uint32_t kind = 0; kind < step_kind_count; ++kind)
        steps += trace.count(static_cast<StepKind>(kind));
      REQUIRE(steps == trace.size());
      for (std::uint32_t k = 0; k < trace.size(); ++k) {
        const Step step = trace.step(k);
        if (trace.find(step.kind, step.item) != k || nearest_step(trace, step) != k) FAIL(k);
        if (step_kind_from_name(evenlift::name(step.kind)) != step.kind) FAIL(k);
        const StepDetail detail = look_at(trace, k);
        for (const Object& object : objects(trace, detail)) {
          if (object.points.empty() || !std::isfinite(object.value)) FAIL(k);
          for (const Vec2& p : object.points)
            if (!p.allFinite()) FAIL(k << " " << evenlift::name(object.mark));
        }
        for (const Number& number : numbers(trace, detail))
          if (!std::isfinite(number.value)) FAIL(k << " " << number.name);
      }
    }
  }
}
