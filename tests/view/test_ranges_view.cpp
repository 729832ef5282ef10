#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "edits/undo.h"
#include "evenlift/generate.h"
#include "evenlift/link.h"
#include "evenlift/output/words.h"
#include "evenlift/placed_robots.h"
#include "evenlift/stands.h"
#include "kit/catch.h"
#include "panels/summary.h"
#include "state/derived.h"
#include "tools/pick.h"
#include "view/view_page.h"
#include "walkthrough/walkthrough.h"

using namespace evenlift;
using namespace evenlift::view;
using namespace view_page;

namespace {

AppState state_in_ranges(std::optional<Goal> goal = {}) {
  AppState state;
  Document opened_first = document(asset(EVENLIFT_ASSETS_DIR "/polygons/guitar.txt"));
  opened_first.settings.positions = Positions::range;
  opened_first.settings.goal = goal;
  begin(state, placed(opened_first));
  return state;
}

// A tangent for the angle is accurate enough here.
Vec2 turned(const Vec2& from_centre, double tangent) {
  return from_centre + tangent * left_normal(from_centre);
}

Vec2 place_of(const AppState& state, std::size_t team, std::size_t robot) {
  return state.derived().placement->teams[team].robots[robot].point.position;
}

}  // namespace

TEST_CASE("a team goes along its range by hand, its loads with it, and back", "[view][ranges]") {
  AppState state = state_in_ranges();
  const Pick pick{Pick::Kind::robot, 1, 0, place_of(state, 1, 0)};
  REQUIRE(can_take_robot(state, pick));
  const std::string before = summary(state);
  const auto range =
      range_of(state.derived().placement->polygon(), state.derived().placement->centre_of_mass,
               chord_of(state.derived().placement->teams[1]), 0.8);
  REQUIRE(range);
  const Vec2 other = place_of(state, 0, 0), was = place_of(state, 1, 0);
  for (const double s : {0.1, 0.5, 0.9}) {
    const Chord wanted =
        chord_at(state.derived().placement->centre_of_mass, *range, place_at(*range, s));
    give(state,
         MoveRobot{2, wanted.r1.edge == state.derived().placement->teams[1].robots[0].point.edge
                          ? wanted.r1.position
                          : wanted.r2.position});
    REQUIRE(by_hand(state));
    const Team& team = state.derived().placement->teams[1];
    CHECK(team.ratio == Approx(wanted.ratio).epsilon(1e-9));
    CHECK(team.ratio >= 0.8 - 1e-9);
    CHECK(team.robots[0].load + team.robots[1].load ==
          Approx(state.derived().placement->settings.weight / 3).epsilon(1e-12));
    CHECK(place_of(state, 0, 0) == other);
  }
  CHECK(state.work.history.undoes() == Edit::robots_moved);
  CHECK(link_lacks_in_words(state).empty());
  CHECK(explain(state, pick).reason.empty());
  // Far beyond its range, it stops at the end.
  give(state, MoveRobot{2, state.derived().placement->centre_of_mass + Vec2(1e-3, 1e6)});
  CHECK(state.derived().placement->teams[1].ratio >= 0.8 - 1e-9);
  give(state, EndEdit{});
  const Vec2 last = place_of(state, 1, 0);
  give(state, ResetRobots{});
  CHECK_FALSE(by_hand(state));
  CHECK(place_of(state, 1, 0) == was);
  CHECK(summary(state) == before);
  give(state, Undo{});
  CHECK(place_of(state, 1, 0) == last);
  give(state, Undo{});
  CHECK(place_of(state, 1, 0) == was);
  CHECK_FALSE(state.work.history.can_undo());
  give(state, Redo{});
  CHECK(place_of(state, 1, 0) == last);
  // Another edit puts them back, and undo restores them.
  Settings fewer = settings(state);
  fewer.teams = 2;
  give(state, SetSettings{fewer});
  CHECK_FALSE(by_hand(state));
  give(state, Undo{});
  CHECK(place_of(state, 1, 0) == last);
  AppState again;
  begin(again, placed(decode_link(*encode_link(last_good(state))).value()));
  CHECK(place_of(again, 1, 0) == last);
}

TEST_CASE("a team of robots with a size goes where they can stand, and not into others",
          "[view][ranges][stands][slow]") {
  for (const double depth : {0.0, 20.0}) {
    AppState state;
    Document opened = document(asset(EVENLIFT_ASSETS_DIR "/polygons/square.txt"));
    opened.settings.positions = Positions::range;
    opened.settings.teams = 4;
    opened.settings.robot = {20, 0, depth, 20, 60};
    begin(state, placed(opened));
    const std::size_t teams = state.derived().placement->teams.size();
    REQUIRE(teams == 4);
    const Vec2 c = state.derived().placement->centre_of_mass;
    int moved = 0, closed = 0;
    for (std::size_t team = 0; team < teams; ++team) {
      for (int step = 1; step <= 40; ++step) {
        const Vec2 was = place_of(state, team, 0);
        state.view.held = {Pick::Kind::robot, team, 0, was};
        give(state, MoveRobot{2 * team, c + turned(was - c, step <= 20 ? 0.05 : -0.05)});
        const std::vector<LiftingPoint> robots = lifting_points(state.derived().placement->teams);
        CHECK_FALSE(state.derived().placement->stands->any_collide(robots));
        for (const LiftingPoint& robot : robots)
          CHECK(state.derived().placement->stands->can_lift(robot));
        CHECK(state.derived().placement->teams[team].ratio >= 0.8 - 2e-9);
        moved += place_of(state, team, 0) != was;
        closed += state.view.closed_to.has_value();
        state.view.held = {};
      }
    }
    CHECK(moved > 10);
    CHECK(closed > 0);
  }
}

TEST_CASE("steps are those of teams where they were found", "[view][ranges]") {
  AppState state = state_in_ranges();
  const Vec2 was = place_of(state, 1, 0);
  give(state,
       MoveRobot{2, was + 0.01 * (state.derived().placement->centre_of_mass - was) + Vec2(3, 3)});
  REQUIRE(by_hand(state));
  give(state, OpenWalkthrough{});
  CHECK_FALSE(by_hand(state));
  CHECK(place_of(state, 1, 0) == was);
  CHECK(state.work.history.undoes() == Edit::robots_reset);
  CHECK(state.view.walkthrough.trace->count(StepKind::range) > 3);
  // Undo leaves the lesson, in which they would have other places.
  give(state, Undo{});
  CHECK(by_hand(state));
  CHECK_FALSE(walkthrough_is_open(state));
}

TEST_CASE("a robot of a team at its best place is taken over by hand", "[view][ranges]") {
  AppState state;
  begin(state, placed(document(asset(EVENLIFT_ASSETS_DIR "/polygons/guitar.txt"))));
  CHECK(can_take_robot(state, {Pick::Kind::robot, 1, 0, place_of(state, 1, 0)}));
  give(state, MoveRobot{2, state.derived().placement->centre_of_mass});
  CHECK_FALSE(by_hand(state));
  CHECK(settings(state).method == Method::given);
}

TEST_CASE("each step of swaps is shown, and a card tells of the swap", "[view][ranges]") {
  AppState state = state_in_ranges(Goal::hold);
  CHECK(state.derived().placement->goal_reached);
  give(state, OpenWalkthrough{});
  const Trace& trace = *state.view.walkthrough.trace;
  REQUIRE(trace.count(StepKind::swap) > 0);
  for (std::uint32_t i = 0; i < trace.count(StepKind::swap); ++i) {
    give(state, GoToStep{*trace.find(StepKind::swap, i)});
    CHECK(state.view.walkthrough.known.swaps == i + 1);
    CHECK_FALSE(state.view.walkthrough.caption.empty());
    CHECK(state.view.walkthrough.base.size() >= 3);
  }
  const std::uint32_t moved = trace.swaps->swaps.back().teams[0];
  const Explanation card = explain(state, {Pick::Kind::robot, moved, 0, place_of(state, moved, 0)});
  CHECK(card.reason.find("swaps candidate") != std::string::npos);
}

TEST_CASE("a few swaps are predicted, and a wrong guess is told what it would come to",
          "[view][ranges]") {
  AppState state = state_in_ranges(Goal::hold);
  give(state, OpenWalkthrough{});
  give(state, ShowAllSteps{true});
  give(state, SetPredict{true});
  const Trace& trace = *state.view.walkthrough.trace;
  const std::uint32_t first = *trace.find(StepKind::swap, 0);
  give(state, GoToStep{first - 1});
  std::array<std::size_t, question_kind_count> asked{};
  bool wrong = true;
  for (std::uint32_t step = first; step < *trace.find(StepKind::held, 0);) {
    give(state, MoveSteps{1});
    const auto& ask = state.view.walkthrough.ask;
    if (ask) {
      CHECK(ask->step == step);
      CHECK(state.view.walkthrough.at == step - 1);
      CHECK(ask->choices.size() > 1);
      CHECK_FALSE(ask->text.empty());
      ++asked[static_cast<std::size_t>(ask->question.kind)];
      const std::uint32_t answer = ask->question.answer;
      const std::uint32_t other = ask->choices[0] == answer ? ask->choices[1] : ask->choices[0];
      give(state, Guess{wrong ? other : answer});
      CHECK(state.view.walkthrough.was_right != wrong);
      CHECK((state.view.walkthrough.verdict.size() > 20) == wrong);
      wrong = !wrong;
    }
    CHECK(state.view.walkthrough.at == step);
    ++step;
  }
  const auto of_teams = asked[static_cast<std::size_t>(QuestionKind::leaving_team)],
             of_candidates = asked[static_cast<std::size_t>(QuestionKind::coming_candidate)];
  CHECK(of_teams + of_candidates > 0);
  CHECK(of_teams <= most_questions);
  CHECK(of_candidates <= most_questions);
}

TEST_CASE("among many candidates teams are swapped when a drag ends, and not before",
          "[view][ranges][slow]") {
  Document comb;
  comb.vertices = *generate(Family::comb, 200, 1);
  comb.settings.goal = Goal::hold;
  comb.settings.clear = 0;  // so that small margins count
  AppState state;
  begin(state, placed(comb));
  const auto taken = [](const Document& document) {
    return evenlift::place(document)->team_candidates;
  };
  CHECK_FALSE(waits_for_swap(*state.derived().placement));
  const Vec2 to = comb.vertices[0] + Vec2(-1, -1);
  give(state, MoveVertex{0, to});
  comb.vertices[0] = to;
  CHECK(waits_for_swap(*state.derived().placement));
  CHECK(state.derived().placement->settings.goal == Goal::hold);
  CHECK(state.derived().placement->goal_reached == state.derived().placement->closure.form_closure);
  Document selected = comb;
  selected.settings.goal = Goal::cover;
  CHECK(state.derived().placement->team_candidates == taken(selected));
  // The lesson's steps are those of the teams on the screen.
  give(state, OpenWalkthrough{});
  CHECK(state.view.walkthrough.trace->count(StepKind::swap) == 0);
  give(state, EndEdit{});
  CHECK_FALSE(waits_for_swap(*state.derived().placement));
  CHECK(state.derived().placement->team_candidates == taken(comb));
  CHECK(taken(comb) != taken(selected));
  CHECK(state.view.walkthrough.trace->count(StepKind::swap) > 0);
  CHECK(state.session.notice.text.empty());
}

TEST_CASE("few candidates are swapped during a drag, too", "[view][ranges]") {
  AppState state = state_in_ranges(Goal::hold);
  const Vec2 to = state.work.document().vertices[0] + Vec2(1, 1);
  give(state, MoveVertex{0, to});
  CHECK_FALSE(waits_for_swap(*state.derived().placement));
  CHECK(state.derived().placement->goal_reached);
  give(state, EndEdit{});
  CHECK(state.derived().placement->goal_reached);
}

TEST_CASE("teams that would be swapped for minutes are not, and a notice says so",
          "[view][ranges][slow]") {
  Document comb;
  comb.vertices = *generate(Family::comb, 1000, 1);
  comb.settings.goal = Goal::hold;
  comb.settings.teams = 8;
  AppState state;
  begin(state, placed(comb));
  CHECK(waits_for_swap(*state.derived().placement));
  CHECK(state.session.notice.text.find("The teams are not swapped here until they hold: with ") ==
        0);
}

TEST_CASE("a robot is dragged along its range with the pointer, and drawn with its range",
          "[view][ranges]") {
  Page page;
  Document document = view_page::document(asset(EVENLIFT_ASSETS_DIR "/polygons/square.txt"));
  document.settings.positions = Positions::range;
  document.shown.overlays.candidates = true;
  page.open(document);
  page.frame();
  // A press takes a vertex before its robot, so this picks a robot away from vertices.
  const AppState& state = page.app.state;
  const auto stands_apart = [&](const Vec2& at) {
    const Points& vertices = state.derived().placement->vertices();
    return std::all_of(vertices.begin(), vertices.end(), [&](const Vec2& v) {
      return length(state.view.camera.to_screen(v) - state.view.camera.to_screen(at)) > 20;
    });
  };
  std::size_t team = 0;
  while (team < 3 && !stands_apart(place_of(state, team, 0))) ++team;
  REQUIRE(team < 3);
  const Vec2 at = place_of(state, team, 0), c = state.derived().placement->centre_of_mass;
  // Around C, to both sides: one is possible.
  for (const double turn : {0.05, -0.05})
    page.drag(place_of(state, team, 0), c + (at - c) + turn * left_normal(at - c));
  CHECK(by_hand(state));
  CHECK(state.work.document().vertices == document.vertices);
  CHECK(state.derived().placement->teams[team].ratio >= 0.8 - 1e-9);
  CHECK(length(place_of(state, team, 0) - at) > 0);
  page.open(document);
  CHECK_FALSE(by_hand(page.app.state));
}

TEST_CASE("a robot on a vertex is taken there while its card is open", "[view][ranges]") {
  Page page;
  Document document;
  document.vertices = {{0, 0}, {400, 0}, {400, 200}, {0, 200}};
  document.settings.positions = Positions::range;
  document.settings.min_ratio = 0.5;
  page.open(document);
  page.frame();
  const AppState& state = page.app.state;
  const Vec2 corner = place_of(state, 0, 0), c = state.derived().placement->centre_of_mass;
  REQUIRE(std::find(document.vertices.begin(), document.vertices.end(), corner) !=
          document.vertices.end());
  const Vec2 to = corner + 0.3 * left_normal(corner - c);
  // Without the card, the vertex moves instead.
  page.drag(corner, corner + Vec2(-8, -8));
  CHECK_FALSE(by_hand(state));
  CHECK(state.work.document().vertices != document.vertices);
  page.open(document);
  page.frame();
  page.click(corner);
  REQUIRE(state.derived().explanation);
  page.drag(corner, to);
  CHECK(state.work.document().vertices == document.vertices);
  CHECK(by_hand(state));
  CHECK(length(place_of(state, 0, 0) - corner) > 10);
  CHECK(state.work.history.undoes() == Edit::robots_moved);
}
