// The trace's steps are the search's, and true of places and chords.
#include <algorithm>
#include <cmath>
#include <string>

#include "balanced/for_oracle.h"
#include "evenlift/main_steps.h"
#include "evenlift/output/trace_words.h"
#include "evenlift/placement.h"
#include "evenlift/trace.h"
#include "evenlift/why_not.h"
#include "kit/catch.h"
#include "kit/corpus.h"
#include "kit/data_table.h"
#include "kit/placed.h"
#include "kit/traced.h"

using namespace evenlift;
using evenlift::testing::object_of;
using evenlift::testing::plain;

namespace {

Document document_of(const std::string& name, std::uint32_t robots) {
  Document document = corpus::polygon(name);
  document.settings.method = Method::balanced;
  document.settings.robots = robots;
  return document;
}

Trace traced(const Document& document) { return testing::traced(*place(document, Effort::start)); }

bool same_robots(const std::vector<LiftingPoint>& a, const std::vector<LiftingPoint>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const LiftingPoint& p, const LiftingPoint& q) {
                      return p.position == q.position && p.edge == q.edge;
                    });
}

const std::string samples[] = {"grand-piano", "boomerang", "letter-e", "thesis-sample", "square",
                               "worktop",     "guitar",    "triangle", "anchor-moved"};

// The step of this kind and item.
std::uint32_t at(const Trace& trace, StepKind kind, std::uint32_t item = 0) {
  const auto step = trace.find(kind, item);
  REQUIRE(step.has_value());
  return *step;
}

}  // namespace

TEST_CASE("the story of a search ends with the robots that the search finds",
          "[trace][balanced][slow]") {
  for (const std::string& name : samples) {
    for (const std::uint32_t robots : {2u, 3u, 4u, 5u, 6u}) {
      INFO(name << ", " << robots);
      const Document document = document_of(name, robots);
      const Trace trace = traced(document);
      const Placement found = testing::placed(document);
      CHECK(same_robots(lifting_points(trace.placement.teams), lifting_points(found.teams)));
      CHECK(trace.placement.search_ended);
      CHECK(trace.placement.coverage == found.coverage);
      CHECK(trace.step(trace.size() - 1).kind == StepKind::result);
    }
  }
}

TEST_CASE("each set of the story is balanced, and each swap makes the set better",
          "[trace][balanced][slow]") {
  std::size_t moves = 0;
  for (const std::string& name : samples) {
    INFO(name);
    const Trace trace = traced(document_of(name, 6));
    const set_oracle::Object object = object_of(trace.polygon(), trace.centre);
    const double near = 1e-9 * set_oracle::diameter(object);
    for (const BalancedSet& set : trace.history.start)
      CHECK(set_oracle::imbalance(object, plain(set.robots)) < near);
    std::vector<LiftingPoint> before = trace.history.start.back().robots;
    for (const BalancedMove& move : trace.history.moves) {
      CHECK(set_oracle::imbalance(object, plain(move.set.robots)) < near);
      CHECK(is_better(*trace.problem, move.set.robots, before));
      CHECK(decided_by(*trace.problem, move.set.robots, before) == move.decided_by);
      before = move.set.robots;
    }
    CHECK(trace.history.settled);
    moves += trace.history.moves.size();
  }
  CHECK(moves > 20);
}

TEST_CASE("a robot that stays keeps its number, and those that move are named",
          "[trace][balanced][slow]") {
  for (const std::string& name : samples) {
    INFO(name);
    const Trace trace = traced(document_of(name, 6));
    std::vector<LiftingPoint> before = trace.history.start.back().robots;
    for (std::uint32_t i = 0; i < trace.history.moves.size(); ++i) {
      const BalancedDetail detail = *look_at(trace, at(trace, StepKind::exchange, i)).balanced;
      CHECK_FALSE(detail.moved.empty());
      CHECK(detail.moved.size() <= 3);
      CHECK(detail.ways.size() == 2 * detail.moved.size());
      for (std::size_t r = 0; r < detail.robots.size(); ++r) {
        const auto& numbers = trace.robot_numbers[i];
        const auto number = std::find(numbers.begin(), numbers.end(), detail.numbers[r]);
        REQUIRE(number != numbers.end());
        const Vec2& former = before[static_cast<std::size_t>(number - numbers.begin())].position;
        const bool moved = std::find(detail.moved.begin(), detail.moved.end(), detail.numbers[r]) !=
                           detail.moved.end();
        CHECK(moved == (former != detail.robots[r].position));
      }
      before = detail.robots;
    }
    // At the end, they are the placement's.
    const auto& last = trace.robot_numbers.back();
    CHECK(std::is_sorted(last.begin(), last.end()));
  }
}

TEST_CASE("a completion is drawn about the point that makes C the centroid",
          "[trace][balanced][slow]") {
  int completions = 0, choices = 0;
  for (const std::string& name : samples) {
    INFO(name);
    const Trace trace = traced(document_of(name, 6));
    for (std::uint32_t k = 0; k < trace.size(); ++k) {
      const StepDetail detail = look_at(trace, k);
      const StepKind kind = detail.step.kind;
      if (kind != StepKind::completion && kind != StepKind::exchange) continue;
      const BalancedDetail& balanced = *detail.balanced;
      const double near = 1e-9 * trace.polygon().diagonal();
      Vec2 sum = static_cast<double>(balanced.rest.size() + 2) * trace.centre;
      for (const LiftingPoint& robot : balanced.rest) sum -= robot.position;
      CHECK(length(sum / 2 - balanced.middle) < near);
      for (const Chord& chord : balanced.chords)
        CHECK(length((chord.r1.position + chord.r2.position) / 2 - balanced.middle) < near);
      // No other chord is better; the chosen one makes the step's set.
      for (std::uint32_t chord = 0; chord < balanced.chords.size(); ++chord)
        CHECK_FALSE(compare_even_chord(trace, detail, chord).better);
      const Vec2& end = balanced.chords[balanced.chosen].r1.position;
      CHECK(std::any_of(balanced.robots.begin(), balanced.robots.end(),
                        [&](const LiftingPoint& robot) { return robot.position == end; }));
      CHECK(is_choice(trace, k) == (balanced.chords.size() > 1));
      ++completions;
      choices += balanced.chords.size() > 1;
    }
  }
  CHECK(completions > 20);
  CHECK(choices > 5);
}

TEST_CASE("a lever of two, three robots, and then all of them", "[trace][balanced]") {
  const Trace trace = traced(document_of("grand-piano", 6));
  const StepDetail two = look_at(trace, at(trace, StepKind::lever));
  REQUIRE(two.balanced->robots.size() == 2);
  CHECK(formula(trace, two).find("50.0") != std::string::npos);
  const StepDetail three = look_at(trace, at(trace, StepKind::three));
  REQUIRE(three.balanced->robots.size() == 3);
  // C divides the line from robot 3 to the middle of the others as 2 to 1.
  CHECK(testing::number_of(trace, three, "arm_of_two") ==
        Approx(length(three.balanced->robots[2].position - trace.centre) / 2));
  CHECK(look_at(trace, at(trace, StepKind::many)).balanced->robots.size() == 6);
  // Three robots have no step for many.
  CHECK(traced(document_of("grand-piano", 3)).count(StepKind::many) == 0);
  CHECK(traced(document_of("grand-piano", 2)).count(StepKind::three) == 0);
}

TEST_CASE("main steps of balanced robots are few, and tell each chapter",
          "[trace][balanced][slow]") {
  for (const std::string& name : samples) {
    for (const std::uint32_t robots : {2u, 3u, 6u, 7u}) {
      INFO(name << ", " << robots);
      const Trace trace = traced(document_of(name, robots));
      const std::vector<std::uint32_t> steps = main_steps(trace);
      CHECK(steps.size() <= most_main_steps);
      CHECK(steps.front() == 0);
      CHECK(steps.back() == trace.size() - 1);
      CHECK(std::is_sorted(steps.begin(), steps.end()));
      for (std::uint32_t c = 0; c < chapter_count; ++c) {
        const auto chapter = static_cast<Chapter>(c);
        CHECK(trace.chapter_begin(chapter).has_value() ==
              std::any_of(steps.begin(), steps.end(),
                          [&](std::uint32_t k) { return trace.step(k).chapter == chapter; }));
      }
      for (const std::uint32_t k : steps)
        if (trace.step(k).kind == StepKind::exchange && further_like(trace, trace.step(k)) > 0)
          CHECK(further_like(trace, trace.step(k)) + 3 == trace.count(StepKind::exchange));
    }
  }
}

TEST_CASE("why no robot stands at a place: the best set with one there is no better",
          "[trace][balanced][slow]") {
  int compared = 0;
  for (const std::string& name : samples) {
    INFO(name);
    const Trace trace = traced(document_of(name, 6));
    const set_oracle::Object object = object_of(trace.polygon(), trace.centre);
    const std::uint32_t last = trace.size() - 1;
    for (const set_oracle::Point& stand : set_oracle::stands(object)) {
      const Vec2 place(stand[0], stand[1]);
      const WhyNoRobot answer = why_no_robot(trace, last, place, 0);
      const std::string text = why_no_robot_text(trace, answer);
      CHECK(text.back() == '.');
      if (answer.why != WhyNoRobot::Why::other_set) continue;
      // The search tried this stand.
      CHECK_FALSE(answer.comparison.better);
      CHECK(answer.set.robots.size() == 6);
      CHECK(set_oracle::imbalance(object, plain(answer.set.robots)) <
            1e-9 * set_oracle::diameter(object));
      CHECK(std::any_of(
          answer.set.robots.begin(), answer.set.robots.end(), [&](const LiftingPoint& robot) {
            return length(robot.position - place) < 1e-9 * set_oracle::diameter(object);
          }));
      ++compared;
    }
  }
  CHECK(compared > 200);
}

TEST_CASE("a robot that stands at a place came there by the swap that is named",
          "[trace][balanced]") {
  const Trace trace = traced(document_of("worktop", 6));
  const std::uint32_t last = trace.size() - 1;
  const std::vector<LiftingPoint> robots = lifting_points(trace.placement.teams);
  int came_later = 0;
  for (std::uint32_t i = 0; i < robots.size(); ++i) {
    const WhyNoRobot answer = why_no_robot(trace, last, robots[i].position, 1);
    CHECK(answer.robot == i);
    if (answer.why == WhyNoRobot::Why::stands_from_start) continue;
    REQUIRE(answer.why == WhyNoRobot::Why::stands);
    const std::vector<LiftingPoint>& came = trace.history.moves[answer.move].set.came;
    CHECK(std::any_of(came.begin(), came.end(), [&](const LiftingPoint& robot) {
      return robot.position == robots[i].position;
    }));
    ++came_later;
  }
  CHECK(came_later > 0);
  // With fewer than three robots, the answer is about the last set.
  for (const std::uint32_t step : {0u, at(trace, StepKind::lever)}) {
    const WhyNoRobot answer = why_no_robot(trace, step, robots[2].position, 1);
    CHECK(answer.robot == 2);
    CHECK(answer.why != WhyNoRobot::Why::no_set);
  }
  CHECK(why_no_robot(traced(document_of("worktop", 2)), 0, robots[0].position, 0).why ==
        WhyNoRobot::Why::no_set);
}

TEST_CASE("if a robot fails the step shows the others, and whether they carry the object",
          "[trace][balanced]") {
  const Trace trace = traced(document_of("worktop", 6));
  REQUIRE(trace.count(StepKind::failure) == 6);
  std::size_t falls = 0;
  for (std::uint32_t robot = 0; robot < 6; ++robot) {
    const StepDetail detail = look_at(trace, at(trace, StepKind::failure, robot));
    CHECK(detail.balanced->robots.size() == 5);
    const bool carried = trace.report.failures[robot].has_value();
    CHECK(detail.balanced->loads.empty() == !carried);
    CHECK((caption(trace, detail).find("tips over") != std::string::npos) == !carried);
    falls += !carried;
  }
  CHECK(falls == 1);
  // As many robots in teams can lose two without harm, and have less coverage.
  const StepDetail pairs = look_at(trace, at(trace, StepKind::pairs));
  CHECK(trace.in_pairs->teams.size() == 3);
  CHECK(trace.in_pairs->coverage < trace.placement.coverage);
  CHECK(
      caption(trace, pairs)
          .find("3 teams still carry the object after any 2 failures at once, wherever they stand; "
                "here it stays steady after any 1 failure.") != std::string::npos);
  CHECK(traced(document_of("worktop", 5)).count(StepKind::pairs) == 0);
}

TEST_CASE("two pairs carry any one failure, but on a knife's edge", "[trace][balanced]") {
  const Trace trace = traced(document_of("worktop", 4));
  REQUIRE(trace.count(StepKind::pairs) == 1);
  const StepDetail pairs = look_at(trace, at(trace, StepKind::pairs));
  CHECK(
      caption(trace, pairs)
          .find("2 teams still carry the object after any 1 failure at once, wherever they stand; "
                "but a single failure can leave it on a knife's edge.") != std::string::npos);
}

TEST_CASE("the law of the centroid says what equal loads presume", "[trace][balanced]") {
  const Trace trace = traced(document_of("worktop", 6));
  REQUIRE(trace.count(StepKind::many) == 1);
  const std::string text = caption(trace, look_at(trace, at(trace, StepKind::many)));
  CHECK(text.find("can carry equal loads") != std::string::npos);
  CHECK(text.find("if forces are controlled, or if all are equally stiff and level") !=
        std::string::npos);
}

TEST_CASE("a search that is too long for a lesson is refused in a sentence", "[trace][balanced]") {
  const Placement start = *place(document_of("gear", 12), Effort::start);
  const Result<Trace> trace = make_trace(start);
  REQUIRE_FALSE(trace.ok());
  CHECK(testing::is_one_sentence(trace.error().message));
  // During a drag, only a quick start is traced.
  const Result<Trace> begun = make_trace(start, HistoryLength::start);
  REQUIRE(begun.ok());
  CHECK(begun->history.moves.empty());
  CHECK_FALSE(begun->placement.search_ended);
}

TEST_CASE("where no robot can be placed the trace says so, and draws no robots",
          "[trace][balanced]") {
  // C is at a corner: no chord has it strictly between its ends.
  Document document;
  document.vertices = {{0, 0}, {2, 0}, {2, 4}, {0, 4}};
  document.centre_of_mass = Vec2(5.594368733352286e-12, 6.3308809186457644e-12);
  document.settings.method = Method::balanced;
  for (const std::uint32_t robots : {2u, 3u, 5u}) {
    INFO(robots);
    document.settings.robots = robots;
    REQUIRE(testing::placed(document).teams.empty());
    const Trace trace = traced(document);
    CHECK(trace.count(StepKind::fewer) == 1);
    for (std::uint32_t k = 0; k < trace.size(); ++k) {
      const StepDetail detail = look_at(trace, k);
      CHECK_FALSE(detail.balanced.has_value());
      CHECK_FALSE(caption(trace, detail).empty());
      for (const Figure& figure : figures(trace, detail)) {
        CHECK(figure.kind != FigureKind::robot);
        CHECK(figure.kind != FigureKind::arm);
      }
      for (const Number& number : numbers(trace, detail)) CHECK(std::isfinite(number.value));
    }
  }
}
