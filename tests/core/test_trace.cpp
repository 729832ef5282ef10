// Every step of every sample, at once and in any order.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <set>

#include "evenlift/generate.h"
#include "evenlift/hull.h"
#include "evenlift/moved.h"
#include "evenlift/numbers.h"
#include "evenlift/output/trace_json.h"
#include "evenlift/output/trace_words.h"
#include "evenlift/output/words.h"
#include "evenlift/placement.h"
#include "evenlift/selection.h"
#include "evenlift/trace.h"
#include "evenlift/why_not.h"
#include "kit/catch.h"
#include "kit/corpus.h"
#include "kit/json.h"
#include "kit/metrics.h"
#include "kit/placed.h"
#include "kit/traced.h"

using namespace evenlift;
using evenlift::testing::Json;
using evenlift::testing::placed;
using evenlift::testing::traced;

namespace {

// All steps up to `last` together.
Progress played(const Trace& trace, std::uint32_t last) {
  Progress progress;
  for (std::uint32_t k = 0; k <= last; ++k) {
    switch (trace.step(k).kind) {
      case StepKind::ray:
        ++progress.rays;
        break;
      case StepKind::slopes:
        progress.slopes = true;
        break;
      case StepKind::sections:
        ++progress.sections;
        break;
      case StepKind::outcome:
      case StepKind::opposite:
        ++progress.sources;
        break;
      case StepKind::duplicates:
        progress.merged = true;
        break;
      case StepKind::team:
        ++progress.teams;
        break;
      case StepKind::base:
        ++progress.base_teams;
        break;
      case StepKind::share:
        ++progress.shares;
        break;
      case StepKind::coverage:
        progress.coverage = true;
        break;
      case StepKind::cut:
        ++progress.cuts;
        break;
      case StepKind::closure:
        progress.closure = true;
        break;
      default:
        break;
    }
  }
  return progress;
}

// No NaN, no unfilled placeholder, and no character that the font lacks.
void check_text(const std::string& text, bool sentence) {
  INFO(text);
  if (sentence) {
    REQUIRE(text.size() > 10);
    if (text.back() != '.' && text.back() != '?') FAIL("no full stop");
  }
  for (const char* bad :
       {"nan", "inf ", "inf,", "inf.", "#", "  ", " .", " ,", "()", "(,", "e+", "undefined"})
    if (text.find(bad) != std::string::npos) FAIL(bad);
  if (!text.empty() && (text.front() == ' ' || text.back() == ' ')) FAIL("a space at an end");
  static const std::set<std::string> others{"\u00a0", "\u00a7", "\u00b0", "\u00b1", "\u00b2",
                                            "\u00b7", "\u00d7", "\u00e9", "\u2013", "\u2014",
                                            "\u2018", "\u2019", "\u201c", "\u201d", "\u2026",
                                            "\u2212", "\u2248", "\u2264", "\u2265"};
  for (std::size_t i = 0; i < text.size();) {
    const auto byte = static_cast<unsigned char>(text[i]);
    const std::size_t size = byte < 0x80 ? 1 : byte < 0xe0 ? 2 : 3;
    if (size > 1 && !others.count(text.substr(i, size)))
      FAIL("not in the font: " << text.substr(i, size));
    if (size == 1 && byte < 0x20) FAIL("a control character");
    i += size;
  }
}

std::vector<std::uint32_t> some_steps(const Trace& trace, std::uint32_t most) {
  std::vector<std::uint32_t> steps;
  const std::uint32_t stride = trace.size() / most + 1;
  for (std::uint32_t k = 0; k < trace.size(); k += stride) steps.push_back(k);
  steps.push_back(trace.size() - 1);
  return steps;
}

}  // namespace

TEST_CASE("the trace ends in the state that place reports", "[trace][slow]") {
  for (const std::string& name : corpus::polygon_names()) {
    for (const Method method : pair_methods) {
      INFO(name << ' ' << evenlift::name(method));
      const Placement placement = placed(corpus::polygon(name), method);
      const Trace trace = traced(placement);
      const Progress end = progress_at(trace, trace.size() - 1);
      CHECK(end.teams == placement.teams.size());
      CHECK(lifting_base(trace, end.base_teams) == placement.lifting_base);
      CHECK(end.shares == placement.teams.size());
      CHECK(end.cuts == trace.contacts.size());
      if (!placement.teams.empty()) CHECK(end.closure);
      if (!trace.by_candidates()) continue;
      CHECK(end.merged);
      CHECK(end.sources == trace.pairs.size() + trace.opposite.size());
      CHECK(trace.source_of_candidate.size() == placement.candidates.size());
      for (std::uint32_t team = 0; team < placement.teams.size(); ++team)
        CHECK(look_at_scores(trace, team).ranking.front() == placement.team_candidates[team]);
    }
  }
}

TEST_CASE("every source with a candidate leads to the one that stands for it", "[trace]") {
  std::size_t merged = 0, opposite_stand = 0;
  for (const std::string& name : corpus::polygon_names()) {
    INFO(name);
    const Trace trace = traced(placed(corpus::polygon(name)));
    const std::vector<Candidate>& candidates = trace.placement.candidates;
    const double near = 1.01e-9 * trace.polygon().diagonal();
    std::vector<std::uint32_t> standing(candidates.size());
    for (std::uint32_t pair = 0; pair < trace.pairs.size(); ++pair) {
      const PairDetail detail = look_at_pair(trace, pair);
      REQUIRE(detail.verdict.candidate.has_value() == detail.candidate.has_value());
      if (!detail.candidate) continue;
      REQUIRE(detail.candidate < candidates.size());
      CHECK(trace.first_source_of_candidate[*detail.candidate] <= pair);
      const Chord& kept = candidates[*detail.candidate].chord;
      standing[*detail.candidate] += detail.stands;
      merged += !detail.stands;
      if (detail.stands) {
        CHECK(kept.r1.position == detail.chosen.r1.position);
        CHECK(kept.r2.position == detail.chosen.r2.position);
      }
      const double straight = std::max(length(kept.r1.position - detail.chosen.r1.position),
                                       length(kept.r2.position - detail.chosen.r2.position));
      const double turned = std::max(length(kept.r1.position - detail.chosen.r2.position),
                                     length(kept.r2.position - detail.chosen.r1.position));
      CHECK(std::min(straight, turned) <= near);
    }
    for (std::uint32_t i = 0; i < trace.opposite.size(); ++i) {
      const OppositeDetail detail = look_at_opposite(trace, i);
      CHECK(detail.candidate.has_value() == (detail.chord.ratio >= 0.8 - 1e-9));
      if (!detail.candidate) continue;
      standing[*detail.candidate] += detail.stands;
      CHECK(candidates[*detail.candidate].between_vertices);
      opposite_stand += detail.stands;
    }
    for (const std::uint32_t number : standing) CHECK(number == 1);
  }
  CHECK(merged > 100);
  CHECK(opposite_stand > 0);
}

TEST_CASE("every step is found again from its kind and item", "[trace][slow]") {
  for (const std::string& name : corpus::polygon_names()) {
    for (const Method method : pair_methods) {
      const Trace trace = traced(placed(corpus::polygon(name), method));
      INFO(name << ' ' << evenlift::name(method));
      std::uint32_t steps = 0;
      for (std::uint32_t kind = 0; kind < step_kind_count; ++kind)
        steps += trace.count(static_cast<StepKind>(kind));
      REQUIRE(steps == trace.size());
      for (std::uint32_t k = 0; k < trace.size(); ++k) {
        const Step step = trace.step(k);
        if (trace.find(step.kind, step.item) != k || nearest_step(trace, step) != k) FAIL(k);
        if (step_kind_from_name(evenlift::name(step.kind)) != step.kind) FAIL(k);
        const StepDetail detail = look_at(trace, k);
        for (const Figure& figure : figures(trace, detail)) {
          if (figure.points.empty() || !std::isfinite(figure.value)) FAIL(k);
          for (const Vec2& p : figure.points)
            if (!is_finite(p)) FAIL(k << " " << evenlift::name(figure.kind));
        }
        for (const Number& number : numbers(trace, detail))
          if (!std::isfinite(number.value)) FAIL(k << " " << number.name);
      }
    }
  }
}

TEST_CASE("what is known at a step does not depend on the way to it", "[trace]") {
  for (const char* name :
       {"thesis-sample-centroid", "square", "horseshoe", "thesis-sample", "u-channel"}) {
    for (const Method method : pair_methods) {
      INFO(name << ' ' << evenlift::name(method));
      const Trace trace = traced(placed(corpus::polygon(name), method, 4));
      for (std::uint32_t k = 0; k < trace.size(); ++k)
        REQUIRE(progress_at(trace, k) == played(trace, k));
      // Words and shapes are the same forward, backward and twice from one place.
      std::vector<std::string> forward;
      const auto picture = [&](std::uint32_t k) {
        const StepDetail detail = look_at(trace, k);
        std::string text = caption(trace, detail) + formula(trace, detail);
        for (const Figure& o : figures(trace, detail)) {
          text += evenlift::name(o.kind);
          for (const Vec2& p : o.points) text += shortest(p.x) + "," + shortest(p.y) + " ";
          text += shortest(o.value);
        }
        return text;
      };
      for (std::uint32_t k = 0; k < trace.size(); ++k) forward.push_back(picture(k));
      for (std::uint32_t k = trace.size(); k-- > 0;) REQUIRE(picture(k) == forward[k]);
    }
  }
}

TEST_CASE("every caption, formula and name of every sample is complete", "[trace][words][slow]") {
  for (const std::string& name : corpus::polygon_names()) {
    for (const Method method : pair_methods) {
      const Trace trace = traced(placed(corpus::polygon(name), method));
      INFO(name << ' ' << evenlift::name(method));
      const std::vector<std::string_view> code = pseudo_code({.method = method});
      for (std::uint32_t k = 0; k < trace.size(); ++k) {
        INFO("step " << k);
        const StepDetail detail = look_at(trace, k);
        check_text(caption(trace, detail), true);
        check_text(formula(trace, detail), false);
        REQUIRE(pseudo_line(trace, detail) < code.size());
        if (const auto asked = question(trace, detail))
          check_text(question_text(trace, detail, *asked), true);
      }
      for (const std::uint32_t k : some_steps(trace, 40)) {
        INFO("step " << k);
        const StepDetail detail = look_at(trace, k);
        for (const Figure& figure : figures(trace, detail)) {
          const std::string text = figure_text(trace, detail, figure);
          if (text.size() < 5) FAIL(evenlift::name(figure.kind));
          check_text(text, false);
        }
      }
      for (std::string_view line : code) {
        while (line.front() == ' ') line.remove_prefix(1);
        check_text(std::string(line), false);
      }
    }
  }
}

TEST_CASE("where there is little or nothing to show the lesson says so", "[trace][words]") {
  struct Hard {
    const char* text;
    double min_ratio;
    StepKind has;  // a step that the trace must have
  };
  const Hard cases[] = {
      // C at a vertex, and in line with edges.
      {"CoM:(5,4)\n(0,0)\n(10,0)\n(5,4)\n(5,20)\n", 0.8, StepKind::radial},
      {"CoM:(2,2)\n(0,0)\n(4,0)\n(4,2)\n(3,2)\n(3,4)\n(0,4)\n", 0.8, StepKind::radial},
      // C beside an edge.
      {"CoM:(1,0.001)\n(0,0)\n(4,0)\n(4,4)\n(0,4)\n", 1, StepKind::fewer},
      // C so near a corner that all chords are uneven.
      {"CoM:(1,1)\n(0,0)\n(400,0)\n(400,400)\n(0,400)\n", 1, StepKind::fewer},
      {"CoM:(2,1e-10)\n(0,0)\n(4,0)\n(4,4)\n(0,4)\n", 0.8, StepKind::radial},
      {"(0,0)\n(4,0)\n(0,3)\n", 1, StepKind::fewer}};
  for (const Hard& hard : cases) {
    Result<Document> document = read_polygon(hard.text);
    REQUIRE(document.ok());
    document->settings.min_ratio = hard.min_ratio;
    for (const Method method : pair_methods) {
      INFO(hard.text << evenlift::name(method));
      const Trace trace = traced(placed(*document, method, 4));
      if (trace.by_candidates()) CHECK(trace.count(hard.has) == 1);
      if (trace.placement.teams.empty()) {
        CHECK(trace.count(StepKind::fewer) == 1);
        CHECK(trace.count(StepKind::loads) == 0);
      }
      CHECK(trace.step(trace.size() - 1).kind == StepKind::result);
      for (std::uint32_t k = 0; k < trace.size(); ++k) {
        INFO("step " << k);
        const StepDetail detail = look_at(trace, k);
        check_text(caption(trace, detail), true);
        check_text(formula(trace, detail), false);
        for (const Figure& figure : figures(trace, detail))
          check_text(figure_text(trace, detail, figure), false);
      }
      for (int i = 0; i < 12; ++i) {
        const double angle = 0.5 * i;
        const auto chord =
            chord_at(trace, trace.centre + trace.polygon().diagonal() *
                                               Vec2(std::cos(angle), std::sin(angle)));
        const std::uint32_t end = trace.size() - 1;
        check_text(why_not_text(trace, why_not_chord(trace, end, chord)), true);
        check_text(why_not_text(trace, why_not_chord(trace, 0, chord)), true);
      }
    }
  }
}

TEST_CASE("a caption does not hide what decides", "[trace][words]") {
  // Other ratios are not rounded to 1 or the minimum.
  const Trace trace = traced(placed(corpus::polygon("thesis-sample-centroid")));
  const auto at = trace.find(StepKind::ray, 1);
  REQUIRE(at);
  CHECK(caption(trace, look_at(trace, *at)).find("0.7998") != std::string::npos);
}

TEST_CASE("numbers are as short left of zero as right of it", "[trace][words]") {
  Document document = corpus::polygon("stone-slab");
  for (Vec2& v : document.vertices) v -= Vec2(2000, 2000);
  const Trace trace = traced(placed(document));
  CHECK(caption(trace, look_at(trace, *trace.find(StepKind::centre, 0)))
            .find("centroid, (−1483.4, −1622.2).") != std::string::npos);
}

TEST_CASE("one candidate that is left is no choice", "[trace]") {
  Document document;
  document.vertices = {{0, 0}, {9, 0}, {2, 7}};
  document.settings.teams = 50;
  const Trace trace = traced(placed(document));
  const std::size_t candidates = trace.placement.candidates.size();
  REQUIRE(trace.placement.teams.size() == candidates);
  std::size_t choices = 0, alone = 0;
  for (std::uint32_t k = 0; k < trace.size(); ++k) {
    if (trace.step(k).kind != StepKind::scores) continue;
    const bool is_last = trace.step(k).item + 1 == candidates;
    CHECK(is_choice(trace, k) != is_last);
    ++(is_last ? alone : choices);
  }
  CHECK(alone == 1);
  CHECK(choices > 0);
}

TEST_CASE("of several chords through a place the shortest that reaches it is meant", "[trace]") {
  // To the right of C the object ends at 2, and has another part from 4 to 6.
  Document document;
  document.vertices = {{-4, -2}, {2, -2}, {2, 1}, {4, 1}, {4, -2}, {6, -2}, {6, 2}, {-4, 2}};
  document.centre_of_mass = Vec2(0, 0);
  const Trace trace = traced(placed(document));
  const std::pair<double, double> reached[] = {{1, 2}, {3, 4}, {5, 6}};
  for (const auto& [at, end] : reached) {
    const auto chord = chord_at(trace, {at, 0});
    REQUIRE(chord);
    CHECK(chord->r1.position.x == -4);
    CHECK(chord->r2.position.x == end);
  }
}

TEST_CASE("a choice is asked with the answer that the algorithm gives", "[trace]") {
  const Trace trace = traced(placed(corpus::polygon("thesis-sample-centroid")));
  int ends = 0, winners = 0;
  for (std::uint32_t k = 0; k < trace.size(); ++k) {
    const StepDetail detail = look_at(trace, k);
    const auto asked = question(trace, detail);
    REQUIRE(asked.has_value() == is_choice(trace, k));
    if (!asked) continue;
    if (asked->kind == QuestionKind::nearer_end) {
      ++ends;
      CHECK(detail.pair->ends[asked->answer].ratio > detail.pair->ends[1 - asked->answer].ratio);
      CHECK(detail.pair->chosen.ratio == detail.pair->ends[asked->answer].ratio);
    } else {
      ++winners;
      CHECK(asked->answer == trace.placement.team_candidates[detail.step.item]);
    }
  }
  CHECK(ends == 10);
  CHECK(winners == 3);
}

TEST_CASE("shapes of a gain add up to its score", "[trace]") {
  for (const char* name : {"thesis-sample-centroid", "horseshoe", "stone-slab", "letter-e"}) {
    for (const Method method : testing::metrics()) {
      INFO(name << ' ' << evenlift::name(method));
      const Trace trace = traced(placed(corpus::polygon(name), method));
      const double size = trace.polygon().diagonal();
      const TeamScores scores = look_at_scores(trace, 1);
      for (std::uint32_t c = 0; c < scores.of_candidate.size(); ++c) {
        const Score& score = scores.of_candidate[c];
        REQUIRE(score.exact);
        double sum = 0;
        for (const Figure& o : gain_figures(trace, scores, c)) {
          if (o.kind == FigureKind::gain_circle) sum += 3.14159265358979 * o.value * o.value;
          if (o.kind == FigureKind::arm_before) sum += o.value;
          if (o.kind == FigureKind::arm_after) sum -= o.value;
          if (o.kind == FigureKind::gain_part) sum += signed_area(o.points);
        }
        CHECK(std::fabs(sum - score.value) <= 1e-9 * size * size);
      }
    }
  }
}

TEST_CASE("the scores of the trace are those of the selection", "[trace]") {
  for (const Method method : testing::metrics()) {
    const Placement placement = placed(corpus::polygon("letter-s"), method, 5);
    const Trace trace = traced(placement);
    std::vector<std::uint32_t> taken;
    for (std::uint32_t team = 0; team < placement.teams.size(); ++team) {
      if (team > 0) {
        const std::vector<double> known =
            scores(trace.object(), trace.centre, placement.candidates, taken, *metric_of(method));
        const TeamScores mine = look_at_scores(trace, team);
        for (std::size_t i = 0; i < known.size(); ++i)
          REQUIRE(mine.of_candidate[i].value == known[i]);
      }
      taken.push_back(placement.team_candidates[team]);
    }
  }
}

TEST_CASE("where candidates are many, only those that compete are scored exactly", "[trace]") {
  Result<Points> comb = generate(Family::comb, 500, 1);
  REQUIRE(comb.ok());
  Document document;
  document.vertices = *comb;
  const Placement placement = placed(document, Method::area, 4);
  REQUIRE(placement.candidates.size() * document.vertices.size() > exact_score_budget);
  const Trace trace = traced(placement);
  std::size_t bounds = 0;
  for (std::uint32_t team = 1; team < 4; ++team) {
    const TeamScores scores = look_at_scores(trace, team);
    const Score& best = scores.of_candidate[scores.ranking.front()];
    CHECK(best.exact);
    CHECK(scores.ranking.front() == placement.team_candidates[team]);
    for (const std::uint32_t c : scores.ranking) {
      bounds += !scores.of_candidate[c].exact;
      if (scores.of_candidate[c].value > best.value * (1 + 1e-9)) FAIL(c);
    }
  }
  CHECK(bounds > 0);
}

TEST_CASE("why not this one has an answer for every candidate and chord", "[trace][words]") {
  for (const char* name :
       {"thesis-sample-centroid", "thesis-sample", "square", "horseshoe", "u-channel", "cross"}) {
    for (const Method method : pair_methods) {
      INFO(name << ' ' << evenlift::name(method));
      const Placement placement = placed(corpus::polygon(name), method);
      const Trace trace = traced(placement);
      const std::uint32_t end = trace.size() - 1;
      std::size_t taken = 0;
      for (std::uint32_t c = 0; c < placement.candidates.size(); ++c) {
        const WhyNot answer = why_not(trace, end, c);
        taken += answer.why == Why::taken;
        check_text(why_not_text(trace, answer), true);
        if (!trace.by_candidates()) continue;
        const auto at =
            std::find(placement.team_candidates.begin(), placement.team_candidates.end(), c);
        CHECK((answer.why == Why::taken) == (at != placement.team_candidates.end()));
        if (answer.why == Why::taken) CHECK(answer.team == at - placement.team_candidates.begin());
        if (answer.why == Why::behind) CHECK(answer.value <= answer.best * (1 + 1e-9));
      }
      if (trace.by_candidates()) CHECK(taken == placement.teams.size());
      for (std::uint32_t pair = 0; pair < trace.pairs.size(); ++pair) {
        const WhyNot answer = why_not_chord(trace, end, look_at_pair(trace, pair).chosen);
        check_text(why_not_text(trace, answer), true);
        if (answer.why == Why::too_uneven)
          CHECK(trace.candidate_of_source[*answer.pair] == no_index);
        if (trace.candidate_of_source[pair] != no_index) CHECK(answer.why != Why::too_uneven);
      }
      // Chords in many directions.
      for (int i = 0; i < 48; ++i) {
        const double angle = 0.13 * i;
        const Vec2 far =
            trace.centre + trace.polygon().diagonal() * Vec2(std::cos(angle), std::sin(angle));
        const auto chord = chord_at(trace, far);
        const WhyNot answer = why_not_chord(trace, end, chord);
        check_text(why_not_text(trace, answer), true);
        CHECK((answer.why == Why::no_chord) == !chord);
        if (!chord || !trace.by_candidates()) continue;
        CHECK(answer.why != Why::no_pair);
        if (answer.why == Why::too_uneven) CHECK(answer.pair_ratio < 0.8);
        if (answer.why == Why::not_best_of_pair)
          CHECK(answer.chord.ratio <= answer.pair_ratio + 1e-12);
      }
      CHECK(why_not_chord(trace, end, chord_at(trace, trace.centre)).why == Why::no_chord);
    }
  }
}

TEST_CASE("the answer for a candidate that lost names what was compared", "[trace][words]") {
  const auto named = [](Rule rule) -> std::string {
    switch (rule) {
      case Rule::longest_even:
      case Rule::longest:
        return " has a length of ";
      case Rule::most_even:
        return " has a load ratio of ";
      case Rule::score:
        break;
    }
    return " has a score of ";
  };
  std::set<Rule> seen;
  for (const char* name : {"guitar", "thesis-sample-centroid", "grand-piano", "thesis-sample"})
    for (const Positions positions : {Positions::best, Positions::range})
      for (const std::uint32_t teams : {1u, 2u}) {
        INFO(name << ", " << evenlift::name(positions) << ", teams: " << teams);
        Document document = corpus::polygon(name);
        document.settings.positions = positions;
        const Trace trace = traced(placed(document, Method::area, teams));
        for (std::uint32_t c = 0; c < trace.placement.candidates.size(); ++c) {
          const WhyNot answer = why_not(trace, trace.size() - 1, c);
          if (answer.why != Why::behind || answer.decided_by != DecidedBy::first_key) continue;
          const std::string text = why_not_text(trace, answer);
          INFO(text);
          CHECK(text.find(named(answer.rule)) != std::string::npos);
          seen.insert(answer.rule);
        }
      }
  CHECK(seen.count(Rule::longest) == 1);
  CHECK(seen.count(Rule::longest_even) + seen.count(Rule::most_even) >= 1);
  CHECK(seen.count(Rule::score) == 1);
}

TEST_CASE("who lost a tie by its length is told both lengths, the greater first",
          "[trace][words]") {
  Document document = corpus::polygon("worktop");
  document.settings.cargo = {{{300, 200}, 30, ""}};
  const Trace trace = traced(placed(document, Method::area, max_teams));
  std::size_t ties = 0;
  for (std::uint32_t k = 0; k < trace.size(); ++k) {
    if (trace.step(k).kind != StepKind::scores) continue;
    for (std::uint32_t c = 0; c < trace.placement.candidates.size(); ++c) {
      const WhyNot answer = why_not(trace, k, c);
      if (answer.why != Why::behind || answer.decided_by != DecidedBy::length) continue;
      ++ties;
      const std::string text = why_not_text(trace, answer);
      INFO(text);
      CHECK(std::stod(text.substr(text.find("is longer, ") + 11)) >
            std::stod(text.substr(text.find(" against ") + 9)));
    }
  }
  CHECK(ties > 0);
}

TEST_CASE("why a team stands here is said without the algorithm's own words", "[trace][words]") {
  const auto why = [](const char* name, Method method, std::uint32_t team, LengthUnit unit) {
    Document document = corpus::polygon(name);
    document.settings.method = method;
    const Trace trace = traced(*place(document), {unit, WeightUnit::kg});
    return why_here_text(trace, look_at_scores(trace, team));
  };
  CHECK(
      why("puzzle-piece", Method::area, 0, LengthUnit::mm) ==
      "The first team takes the longest chord with two equal halves: the farther apart the robots "
      "stand, the wider the lifting base can become. The next chord is 122.9\u00A0mm shorter.");
  CHECK(
      why("puzzle-piece", Method::area, 1, LengthUnit::mm) ==
      "Team 2 takes the chord that adds the most area to the lifting base: the wider the lifting "
      "base, the harder it is to tip the object. It adds an area of 329625\u00A0mm²; the next best chord would add 328147\u00A0mm².");
  CHECK(why("square", Method::circle, 1, LengthUnit::none)
            .starts_with("Team 2 takes the chord whose ends leave room"));
  for (const char* name : {"thesis-sample-centroid", "square", "horseshoe", "cross"})
    for (const Method method : {Method::area, Method::circle, Method::distance}) {
      INFO(name << ' ' << evenlift::name(method));
      const Trace trace = traced(placed(corpus::polygon(name), method));
      for (std::uint32_t team = 0; team < trace.placement.teams.size(); ++team)
        check_text(why_here_text(trace, look_at_scores(trace, team)), true);
    }
}

TEST_CASE("a chord is picked by a point on it", "[trace]") {
  const Trace trace = traced(placed(corpus::polygon("thesis-sample-centroid")));
  REQUIRE(trace.rays.chords.size() > 10);
  for (const VertexChord& chord : trace.rays.chords) {
    const Vec2 middle = trace.centre + 0.9 * (chord.chord.r2.position - trace.centre);
    const auto picked = chord_at(trace, middle);
    REQUIRE(picked);
    CHECK(length(picked->r2.position - trace.centre) >= length(middle - trace.centre) * (1 - 1e-9));
    CHECK(std::fabs(cross(picked->r2.position - trace.centre, middle - trace.centre)) <=
          1e-9 * trace.polygon().diagonal() * trace.polygon().diagonal());
  }
}

TEST_CASE("after an edit the lesson keeps its place as well as it can", "[trace]") {
  const Trace big = traced(placed(corpus::polygon("horseshoe")));
  const Trace small = traced(placed(corpus::polygon("square")));
  const Trace other = traced(placed(corpus::polygon("square"), Method::random));
  for (const Trace* to : {&big, &small, &other}) {
    for (const Trace* from : {&big, &small, &other}) {
      for (std::uint32_t k = 0; k < from->size(); ++k) {
        const Step step = from->step(k);
        const std::uint32_t at = nearest_step(*to, step);
        REQUIRE(at < to->size());
        if (to->count(step.kind) > 0) REQUIRE(to->step(at).kind == step.kind);
      }
    }
  }
  CHECK(small.step(nearest_step(small, {StepKind::sections, Chapter::pairs, 60})) ==
        Step{StepKind::sections, Chapter::pairs, 1});
}

TEST_CASE("what is too long to watch is refused with a sentence", "[trace][slow]") {
  Document document;
  document.vertices = *generate(Family::comb, 2000, 1);
  const Result<Trace> trace = make_trace(placed(document));
  REQUIRE_FALSE(trace.ok());
  CHECK(trace.error().message.find("steps") != std::string::npos);
}

TEST_CASE("objects of every size have readable numbers", "[trace][words]") {
  for (const double size : {1e-11, 1e-9, 1e-3, 1.0, 1e5}) {
    for (const Method method : pair_methods) {
      Document document = corpus::polygon("stone-slab");
      for (Vec2& v : document.vertices) v = v * size;
      document.settings.weight = 1 / size;
      const Trace trace = traced(placed(document, method));
      INFO(size << ' ' << evenlift::name(method));
      for (std::uint32_t k = 0; k < trace.size(); ++k) {
        const StepDetail detail = look_at(trace, k);
        const std::string text = caption(trace, detail);
        if (size > 1e-4) check_text(text, true);
        CHECK(text.find("nan") == std::string::npos);
        CHECK(text.find("(0.000000000, 0.000000000)") == std::string::npos);
      }
    }
  }
}

// tests/expected/trace makes changes of the output visible.
TEST_CASE("known polygons give the expected traces", "[trace][expected][slow]") {
  const std::filesystem::path folder =
      std::filesystem::path(EVENLIFT_TESTS_DIR) / "expected" / "trace";
  const auto check = [&](const std::string& name, const Placement& placement) {
    INFO(name);
    const std::string list = trace_list(traced(placement));
    const std::filesystem::path path = folder / (name + ".txt");
    if (std::getenv("EVENLIFT_UPDATE_EXPECTED") != nullptr) corpus::write_file(path, list);
    CHECK(list == corpus::read_file(path));
  };
  for (const char* name : {"thesis-sample", "square", "horseshoe"})
    check(name, placed(corpus::polygon(name)));
  check("worktop.balanced", placed(corpus::polygon("worktop"), Method::balanced));
  check("guitar.balanced", placed(corpus::polygon("guitar"), Method::balanced));
}

TEST_CASE("every step of balanced robots has its words, figures and numbers",
          "[trace][balanced][slow]") {
  for (const char* name : {"worktop", "letter-e", "square", "boomerang-moved", "round-table"}) {
    for (const std::uint32_t robots : {2u, 3u, 4u, 7u}) {
      INFO(name << ", " << robots);
      Document document = corpus::polygon(name);
      document.settings.robots = robots;
      const Trace trace = traced(placed(document, Method::balanced));
      for (std::uint32_t k = 0; k < trace.size(); ++k) {
        INFO("step " << k);
        const StepDetail detail = look_at(trace, k);
        check_text(caption(trace, detail), true);
        check_text(formula(trace, detail), false);
        CHECK(pseudo_line(trace, detail) < pseudo_code({.method = Method::balanced}).size());
        for (const Figure& figure : figures(trace, detail))
          check_text(figure_text(trace, detail, figure), false);
        for (const Number& number : numbers(trace, detail)) CHECK(std::isfinite(number.value));
        if (const auto asked = question(trace, detail)) {
          check_text(question_text(trace, detail, *asked), true);
          if (asked->kind == QuestionKind::even_chord)
            check_text(even_chord_text(trace, detail, asked->answer), true);
        }
      }
    }
  }
}

TEST_CASE("a step of a failure carries the object within tau L, not within tau of its box",
          "[trace][balanced][slow]") {
  // The square's diameter is 2, its box's diagonal 2.83. After the last failure, C is 2.4e-9
  // outside the other three robots' triangle.
  Document document;
  document.vertices = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
  document.settings.robots = 4;
  Trace trace = traced(placed(document, Method::balanced));
  const double off = 2.4e-9 * std::sqrt(2.0);
  BalancedHistory& history = trace.history;
  BalancedSet& last = history.moves.empty() ? history.start.back() : history.moves.back().set;
  last.robots = {
      {{-0.5, 0.5}, 1}, {{0.5 + off, -0.5 + off}, 3}, {{0.5, 0.5}, 0}, {{-0.5, -0.5}, 2}};
  const auto step = trace.find(StepKind::failure, 3);
  REQUIRE(step.has_value());
  CHECK(look_at(trace, *step).balanced->loads.empty());
  last.robots[1].position = {0.5 + off / 2, -0.5 + off / 2};  // within tau L
  CHECK(look_at(trace, *step).balanced->loads.size() == 3);
}

TEST_CASE("a trace of robots that were moved by hand says so, and what is true where they stand",
          "[trace][moved][slow]") {
  for (const Method method : {Method::area, Method::balanced}) {
    INFO(name(method));
    Document document = corpus::polygon("guitar");
    document.settings.method = method;
    document.settings.positions = Positions::range;
    const Placement found = placed(document);
    const Polygon& polygon = found.polygon();
    std::optional<Moved> moved;
    for (std::uint32_t edge = 0; edge < polygon.size() && !moved; ++edge) {
      const Vec2 to = (polygon.edge_start(edge) + polygon.edge_end(edge)) / 2;
      moved = method == Method::balanced ? moved_along_outline(found, 0, {to, edge})
                                         : moved_along_range(found, 0, to);
    }
    REQUIRE(moved.has_value());
    CHECK_FALSE(traced(found).moved);
    const Result<Placement> there = with_moved(found, *moved);
    REQUIRE(there.ok());
    const Trace trace = traced(*there);
    REQUIRE(trace.moved.has_value());
    CHECK(trace.moved->moved == *moved);
    // The steps are those of the method.
    CHECK(trace.placement.coverage == found.coverage);
    CHECK(caption(trace, look_at(trace, 0)).find("moved by hand") != std::string::npos);
    const StepDetail last = look_at(trace, trace.size() - 1);
    REQUIRE(last.step.kind == StepKind::result);
    const std::string text = caption(trace, last);
    CHECK(text.find(verdict(found)) == 0);
    CHECK(text.find("moved by hand") != std::string::npos);
    CHECK(text.find(verdict(*there)) != std::string::npos);
    CHECK(testing::number_of(trace, last, "moved_coverage") == there->coverage);
    CHECK(trace_json(trace).find("\"moved_form_closure\"") != std::string::npos);
  }
}

TEST_CASE("the JSON of a step has its figures, but for the polygon itself", "[trace][json]") {
  const Trace trace = traced(placed(corpus::polygon("trapezium")));
  const auto json = Json::parse(trace_json(trace));
  REQUIRE(json.size() == trace.size());
  std::size_t compared = 0;
  for (std::uint32_t k = 0; k < trace.size(); ++k) {
    std::vector<std::string> expected, found;
    for (const Figure& figure : figures(trace, look_at(trace, k)))
      if (figure.kind != FigureKind::object) expected.emplace_back(name(figure.kind));
    if (expected.size() > 100) continue;
    for (const auto& object : json[k]["objects"]) found.push_back(object["mark"].text());
    INFO(k);
    CHECK(found == expected);
    compared += expected.size();
  }
  CHECK(compared > 50);
}

TEST_CASE("each sense of turning is ruled out once, and then told as ruled out", "[trace][words]") {
  std::size_t told = 0;
  for (const char* name : {"horseshoe", "arrow", "cross", "stone-slab", "letter-e", "anchor"}) {
    const Placement placement = placed(corpus::polygon(name));
    const Trace trace = traced(placement);
    INFO(name);
    for (const std::string sense : {"clockwise", "counter-clockwise"}) {
      std::size_t ruled_out = 0;
      for (std::uint32_t k = 0; k < trace.size(); ++k) {
        const std::string text = caption(trace, look_at(trace, k));
        const bool now = text.find("It can no longer turn " + sense + " about any point.") !=
                         std::string::npos,
                   before = text.find("Turning " + sense + " is already ruled out.") !=
                            std::string::npos;
        if (before) CHECK(ruled_out == 1);
        ruled_out += now;
        told += now || before;
      }
      CHECK(ruled_out <= 1);
    }
  }
  CHECK(told > 4);
}
