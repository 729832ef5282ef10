#include <algorithm>
#include <string>

#include "evenlift/output/json.h"
#include "evenlift/output/trace_words.h"
#include "evenlift/placement.h"
#include "evenlift/stability.h"
#include "evenlift/trace.h"
#include "evenlift/why_not.h"
#include "kit/catch.h"
#include "kit/corpus.h"
#include "kit/placed.h"
#include "kit/traced.h"

using namespace evenlift;
using evenlift::testing::number_of;
using evenlift::testing::placed;

namespace {

Trace trace_of(const std::string& name, std::uint32_t teams, Positions positions,
               std::optional<Goal> goal) {
  Document document = corpus::polygon(name);
  document.settings.teams = teams;
  document.settings.positions = positions;
  document.settings.goal = goal;
  return testing::traced(placed(document));
}

// On every sample, each step has words, figures and numbers.
void check_words(const Trace& trace) {
  for (std::uint32_t k = 0; k < trace.size(); ++k) {
    const StepDetail detail = look_at(trace, k);
    INFO("step " << k << ", " << name(detail.step.kind));
    const std::string text = caption(trace, detail);
    CHECK_FALSE(text.empty());
    CHECK(text.find('#') == std::string::npos);
    CHECK(pseudo_line(trace, detail) < pseudo_code(trace.placement.settings).size());
    for (const Figure& figure : figures(trace, detail)) {
      CHECK_FALSE(figure.points.empty());
      CHECK_FALSE(figure_text(trace, detail, figure).empty());
    }
    if (detail.step.kind == StepKind::duplicates) {
      const double merged = number_of(trace, detail, "merged");
      CHECK(merged >= 0);
      if (merged > 0)
        CHECK(text.starts_with(std::to_string(static_cast<int>(merged)) + " of the "));
      if (merged == 0) CHECK(text.starts_with("No "));
    }
    if (const auto asked = question(trace, detail))
      CHECK_FALSE(question_text(trace, detail, *asked).empty());
  }
}

}  // namespace

TEST_CASE("each range of the trace has the two candidates that it added",
          "[ranges][trace][thorough]") {
  std::size_t added = 0;
  for (const std::string& name : corpus::polygon_names()) {
    INFO(name);
    const Trace trace = trace_of(name, 3, Positions::range, {});
    const auto of_kind = std::count_if(
        trace.placement.candidates.begin(), trace.placement.candidates.end(),
        [](const Candidate& candidate) { return candidate.kind == CandidateKind::range; });
    CHECK(static_cast<std::size_t>(of_kind) <= 2 * trace.ranges.size());
    CHECK(trace.count(StepKind::range) == trace.ranges.size());
    for (std::uint32_t i = 0; i < trace.ranges.size(); ++i) {
      const RangeDetail detail = look_at_range(trace, i);
      for (std::size_t k = 0; k < 2; ++k) {
        REQUIRE(detail.candidates[k] < trace.placement.candidates.size());
        added += trace.placement.candidates[detail.candidates[k]].kind == CandidateKind::range;
      }
      for (const Chord& end : detail.ends) CHECK(end.ratio >= 0.8 - 1e-9);
    }
    for (std::uint32_t i = 0; i < trace.placement.candidates.size(); ++i)
      CHECK_FALSE(why_not_text(trace, why_not(trace, trace.size() - 1, i)).empty());
  }
  CHECK(added > 1000);
}

TEST_CASE("the swaps of the trace lead from the metric's teams to the result",
          "[swaps][trace][slow]") {
  std::uint32_t swaps = 0;
  for (const std::string& name : corpus::polygon_names()) {
    INFO(name);
    const Trace trace = trace_of(name, 3, Positions::range, Goal::hold);
    if (trace.placement.teams.empty()) continue;
    CHECK(trace.count(StepKind::held) == 1);
    REQUIRE(trace.stages.size() == trace.count(StepKind::swap) + 1);
    const std::vector<Team>& last = trace.stages.back();
    REQUIRE(last.size() == trace.placement.teams.size());
    for (std::size_t i = 0; i < last.size(); ++i)
      CHECK(chord_of(last[i]).r1.position == chord_of(trace.placement.teams[i]).r1.position);
    for (std::uint32_t i = 0; i < trace.count(StepKind::swap); ++i, ++swaps) {
      const StepDetail detail = look_at(trace, *trace.find(StepKind::swap, i));
      CHECK(number_of(trace, detail, "coverage") ==
            Approx(coverage(trace.object(), detail.base)).margin(1e-9));
      CHECK(number_of(trace, detail, "level") >= number_of(trace, detail, "level_before"));
      CHECK(better_by(detail.swap->after, detail.swap->before) == detail.swap->decided_by);
    }
    const Progress end = progress_at(trace, trace.size() - 1);
    CHECK(end.swaps == trace.count(StepKind::swap));
    CHECK(coverage(trace.object(), lifting_base(trace, end)) ==
          Approx(trace.placement.coverage).margin(1e-12));
  }
  CHECK(swaps > 100);
}

TEST_CASE("every step of ranges and swaps has its words, figures and line",
          "[ranges][trace][slow]") {
  for (const char* name :
       {"thesis-sample-centroid", "guitar", "octagon", "square", "thesis-sample"})
    for (const std::uint32_t teams : {1u, 2u, 3u, 5u}) {
      INFO(name << ", " << teams);
      check_words(trace_of(name, teams, Positions::range, Goal::hold));
      check_words(trace_of(name, teams, Positions::best, Goal::hold));
      check_words(trace_of(name, teams, Positions::range, {}));
    }
}

TEST_CASE("the choice of the longest candidate is told as it is made", "[ranges][trace]") {
  const Trace trace = trace_of("guitar", 3, Positions::range, {});
  const TeamScores scores = look_at_scores(trace, 0);
  CHECK(scores.rule == Rule::longest);
  CHECK(scores.ranking.front() == trace.placement.team_candidates[0]);
  for (std::uint32_t team = 1; team < 3; ++team)
    CHECK(look_at_scores(trace, team).ranking.front() == trace.placement.team_candidates[team]);
}

TEST_CASE("a swap of one team is a choice, of which no other answer is better",
          "[swaps][trace][slow]") {
  int teams = 0, candidates = 0, sized = 0, none = 0;
  for (const std::string& name : corpus::polygon_names()) {
    Document document = corpus::polygon(name);
    if (document.vertices.size() > 60) continue;
    document.settings.teams = 3 + teams % 2;
    document.settings.positions = Positions::range;
    document.settings.goal = Goal::hold;
    const bool has_size = (teams + candidates) % 3 == 0;
    const double diagonal = Polygon::create(document.vertices)->diagonal();
    if (has_size) document.settings.robot.radius = 0.02 * diagonal;
    const auto placement = place(document);
    if (!placement) continue;
    const Result<Trace> made = make_trace(*placement);
    REQUIRE(made.ok());
    const Trace& trace = *made;
    INFO(name << (has_size ? ", with a size" : ""));
    for (std::uint32_t i = 0; i < trace.count(StepKind::swap); ++i) {
      const StepDetail detail = look_at(trace, *trace.find(StepKind::swap, i));
      const bool single = detail.swap->kind == SwapKind::single;
      const auto asked = question(trace, detail);
      REQUIRE(asked.has_value() == single);
      REQUIRE(is_choice(trace, detail.number) == single);
      if (!asked) continue;
      const bool of_team = asked->kind == QuestionKind::leaving_team;
      CHECK((of_team || asked->kind == QuestionKind::coming_candidate));
      CHECK(of_team == (i % 2 == 0 && placement->teams.size() > 1));
      CHECK(asked->answer == (of_team ? detail.swap->teams[0] : detail.swap->to[0]));
      (of_team ? teams : candidates) += 1;
      sized += has_size;
      const std::vector<std::uint32_t> offered = choices(trace, detail, *asked);
      CHECK(std::is_sorted(offered.begin(), offered.end()));
      CHECK(std::count(offered.begin(), offered.end(), asked->answer) == 1);
      if (of_team) CHECK(offered.size() == trace.stages[i].size());
      CHECK_FALSE(question_text(trace, detail, *asked).empty());
      std::size_t looked_at = 0;
      for (const std::uint32_t choice : offered) {
        const Chord& chord = chord_of_choice(trace, detail, *asked, choice);
        CHECK(length(chord.r1.position - chord.r2.position) > 0);
        if (of_team) CHECK(chord.r1.position == chord_of(trace.stages[i][choice]).r1.position);
        if (choice == asked->answer || ++looked_at > 12) continue;
        const OtherSwap other = compare_swap(trace, detail, *asked, choice);
        if (other.candidate) CHECK_FALSE(better_by(other.keys, detail.swap->after));
        none += !other.candidate;
        const std::string text = other_swap_text(trace, detail, *asked, choice);
        CHECK_FALSE(text.empty());
        CHECK(text.find('#') == std::string::npos);
      }
    }
  }
  CHECK(teams > 30);
  CHECK(candidates > 10);
  CHECK(sized > 5);
  CHECK(none > 0);
}

TEST_CASE("every step tells loads in the document's unit of weight", "[trace]") {
  for (const Method method : {Method::area, Method::balanced, Method::given}) {
    Document document = corpus::polygon("grand-piano");
    document.settings.method = method;
    if (method == Method::given) document.settings.supports = {{80, 100}, {600, 100}, {200, 700}};
    document.settings.weight = 6;
    document.shown.units.weight = WeightUnit::t;
    const auto trace = make_trace(placed(document), HistoryLength::whole, document.shown.units);
    REQUIRE(trace.ok());
    std::size_t told = 0;
    for (std::uint32_t step = 0; step < trace->size(); ++step) {
      const std::string text = caption(*trace, look_at(*trace, step));
      CAPTURE(text);
      CHECK(text.find("\u00A0kg") == std::string::npos);
      if (text.find("6\u00A0t in all") != std::string::npos) ++told;
    }
    CHECK(told > 0);
  }
}
