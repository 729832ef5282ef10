// The start at once, and a search's later results.
#include <string>
#include <utility>
#include <vector>

#include "app/update.h"
#include "derive/derive.h"
#include "edits/undo.h"
#include "evenlift/balanced.h"
#include "evenlift/link.h"
#include "evenlift/main_steps.h"
#include "evenlift/output/words.h"
#include "kit/catch.h"
#include "panels/summary.h"
#include "state/method.h"
#include "tools/drawing.h"
#include "tools/pick.h"
#include "view/view_page.h"
#include "walkthrough/walkthrough.h"

using namespace evenlift;
using namespace evenlift::view;
using namespace view_page;

namespace {

const std::string piano = asset(EVENLIFT_ASSETS_DIR "/polygons/grand-piano.txt");

AppState balanced_state(std::uint32_t robots = 6) {
  AppState state;
  Document opened_first = document(piano);
  opened_first.settings.method = Method::balanced;
  opened_first.settings.robots = robots;
  begin(state, placed(opened_first));
  return state;
}

std::vector<LiftingPoint> standing(const AppState& state) {
  return lifting_points(state.derived().placement->teams);
}

// Of the whole search.
std::string last_robots(const AppState& state) {
  return robots_text(lifting_points(place(state.work.document())->teams));
}

}  // namespace

TEST_CASE("the view shows the start of the search and then what it finds", "[view][balanced]") {
  AppState state = balanced_state();
  REQUIRE(state.derived().search.under_way);
  CHECK_FALSE(state.derived().placement->search_ended);
  CHECK(verdict(state).searching);
  const double before = state.derived().placement->coverage;
  const std::uint64_t revision = state.derived().revision;
  REQUIRE(take_robots(state, state.derived().search.number, last_robots(state), true));
  CHECK(state.derived().revision > revision);
  CHECK_FALSE(state.derived().search.under_way);
  CHECK_FALSE(verdict(state).searching);
  CHECK(state.derived().placement->coverage > before);
  CHECK(robots_text(standing(state)) == last_robots(state));
  CHECK(state.derived().placement->goal_reached == place(state.work.document())->goal_reached);
  CHECK_FALSE(state.work.history.can_undo());
}

TEST_CASE("where the start is slow, nothing is shown until the search has found it",
          "[view][balanced][slow]") {
  AppState state;
  Document comb = document(asset(EVENLIFT_ASSETS_DIR "/polygons/comb.txt"));
  comb.settings.method = Method::balanced;
  comb.settings.robots = 4;
  begin(state, placed(comb));
  REQUIRE(state.derived().search.under_way);
  CHECK(state.derived().placement->teams.empty());
  CHECK(verdict(state).headline == "Still looking for places for 4 robots.");
  CHECK(verdict(state).detail == "The search is under way.");
  SECTION("the robots are taken over") {
    REQUIRE(take_robots(state, state.derived().search.number, last_robots(state), true));
    CHECK(robots_text(standing(state)) == last_robots(state));
    CHECK_FALSE(state.derived().search.under_way);
  }
  SECTION("that there are none is said only at the end") {
    CHECK_FALSE(take_robots(state, state.derived().search.number, "", false));
    CHECK(state.derived().search.under_way);
    REQUIRE(take_robots(state, state.derived().search.number, "", true));
    CHECK(verdict(state).headline == "No robots can be placed.");
    CHECK_FALSE(state.derived().search.under_way);
  }
}

TEST_CASE("what a search finds for another document is dropped", "[view][balanced]") {
  AppState state = balanced_state();
  const std::uint64_t number = state.derived().search.number;
  const std::string found = last_robots(state);
  Settings fewer = state.work.document().settings;
  fewer.robots = 5;
  give(state, SetSettings{fewer});
  CHECK(state.derived().search.number > number);
  CHECK_FALSE(take_robots(state, number, found, true));
  CHECK_FALSE(take_robots(state, state.derived().search.number, found, true));  // six instead of
                                                                                // five
  CHECK(standing(state).size() == 5);
  CHECK(state.derived().search.under_way);
}

TEST_CASE("texts that are no robots change nothing", "[view][balanced]") {
  AppState state = balanced_state(2);
  // Two robots need no search.
  CHECK_FALSE(state.derived().search.under_way);
  const Polygon& polygon = state.derived().placement->polygon();
  const std::string good = robots_text(standing(state));
  REQUIRE(read_robots(good, 2, polygon));
  for (const std::string& bad :
       {std::string(), good + " ", good + " 1 2 3", "x" + good, std::string("0 1 2 99999 1 2"),
        std::string("0 1 2 0 1"), std::string("0 1 2 0 nan 1"), std::string("0 1 2 0 1e300 1"),
        std::string("-1 1 2 0 1 1")})
    CHECK_FALSE(read_robots(bad, 2, polygon));
}

TEST_CASE("during a drag no search goes on, and one begins after it", "[view][balanced]") {
  AppState state = balanced_state();
  const std::uint64_t number = state.derived().search.number;
  const Vec2 to = state.work.document().vertices[0] + Vec2(1, 1);
  give(state, MoveVertex{0, to});
  REQUIRE(state.work.edit_open);
  CHECK_FALSE(state.derived().search.under_way);
  CHECK_FALSE(state.derived().placement->search_ended);
  give(state, EndEdit{});
  CHECK(state.derived().search.under_way);
  CHECK(state.derived().search.number == number + 1);
}

TEST_CASE("what changes no placement leaves the search alone", "[view][balanced]") {
  AppState state = balanced_state();
  const std::uint64_t number = state.derived().search.number;
  give(state, showing(state, &Shown::capacity, 20.0));
  give(state, Compare{Method::area});
  give(state, Compare{std::nullopt});
  give(state, showing(state, &Shown::overlays, {}));
  CHECK(state.derived().search.number == number);
  CHECK(state.derived().search.under_way);
}

TEST_CASE("how many balanced robots it takes if any one may fail is taken over when it is counted",
          "[view][balanced][capacity][slow]") {
  AppState state = balanced_state();
  give(state, showing(state, &Shown::capacity, 20.0));
  conclude(state);
  CHECK_FALSE(state.derived().search.counting);  // they have not settled
  take_robots(state, state.derived().search.number, last_robots(state), true);
  conclude(state);
  REQUIRE(state.derived().search.counting);
  CHECK_FALSE(verdict(state).searching);
  const std::uint64_t number = state.derived().search.number;
  const FailurePlan plan = plan_for_failures(*state.derived().placement, 20);
  SECTION("texts that are no count change nothing") {
    for (const char* bad :
         {"", " ", "x", "9 ", "9 x", "9 nan", "65", "9 20 66", "9 20 9 9", "-9 20", "09 20"})
      CHECK_FALSE(take_robots(state, number, bad, true));
    CHECK(state.derived().search.counting);
    CHECK_FALSE(state.derived().spare);
    take_robots(state, number,
                std::nullopt);  // no further search begins, and no notice mentions a search
    conclude(state);
    CHECK(state.derived().search.number == number);
    CHECK(state.session.notice.text.empty());
  }
  SECTION("it is shown, and kept while it can have stayed the same") {
    REQUIRE(take_robots(state, number, plan_text(plan), true));
    CHECK(state.derived().spare == plan);
    CHECK(need_in_words(state).find("To allow for any one failure: ") != std::string::npos);
    Settings fewer = settings(state);
    fewer.robots = 5;
    give(state, SetSettings{fewer});
    take_robots(state, state.derived().search.number, last_robots(state), true);
    conclude(state);
    CHECK(state.derived().spare == plan);
    CHECK_FALSE(state.derived().search.counting);
  }
  SECTION("another capacity and a drag drop it") {
    give(state, showing(state, &Shown::capacity, 25.0));
    CHECK_FALSE(take_robots(state, number, plan_text(plan), true));
    conclude(state);
    REQUIRE(state.derived().search.number == number + 1);
    give(state, MoveVertex{0, state.work.document().vertices[0] + Vec2(1, 1)});
    conclude(state);
    CHECK_FALSE(state.derived().search.counting);
    CHECK_FALSE(take_robots(state, number + 1, plan_text(plan), true));
    CHECK_FALSE(state.derived().spare);
  }
  for (const FailurePlan& each :
       {plan, FailurePlan{.tried = 17},
        FailurePlan{.can_tip = true, .robots = 4, .greatest_load = 25.5, .tried = 11}})
    CHECK(read_plan(plan_text(each)) == each);
}

TEST_CASE("a search that was cut short says so", "[view][balanced]") {
  AppState state = balanced_state();
  REQUIRE(state.derived().search.under_way);
  give(state, TakeRobots{state.derived().search.number, last_robots(state), true, true});
  CHECK(state.derived().placement->search_ended);
  CHECK(state.derived().placement->cut_short);
  CHECK(verdict(state).detail.find("cut short by its limit of work") != std::string::npos);
}

TEST_CASE("the second method is searched for, too", "[view][balanced]") {
  AppState state;
  begin(state, placed(document(piano)));
  CHECK_FALSE(state.derived().search.under_way);
  give(state, Compare{Method::balanced});
  REQUIRE(state.derived().second);
  REQUIRE(state.derived().search.under_way);
  Document other = state.work.document();
  other.settings.method = Method::balanced;
  const Result<Placement> whole = place(other);
  REQUIRE(take_robots(state, state.derived().search.number,
                      robots_text(lifting_points(whole->teams)), true));
  CHECK(state.derived().second->coverage == whole->coverage);
  CHECK(state.derived().placement->settings.method == Method::area);
  give(state, Compare{std::nullopt});
  CHECK_FALSE(state.derived().search.under_way);
}

TEST_CASE("another method takes what it can have of the settings", "[view][balanced]") {
  Settings settings;
  settings.teams.reset();
  CHECK(with_method(settings, Method::random, 4).teams == 4);
  CHECK_FALSE(with_method(settings, Method::balanced, 4).teams);
  settings.goal = Goal::hold;
  settings.method = Method::balanced;
  CHECK(with_method(settings, Method::balanced, 4).goal == Goal::hold);
  CHECK_FALSE(with_method(settings, Method::area, 4).goal);
  // The goal of teams stays where the method supports it.
  settings.method = Method::area;
  CHECK(with_method(settings, Method::circle, 4).goal == Goal::hold);
  CHECK_FALSE(with_method(settings, Method::random, 4).goal);
}

TEST_CASE("every key of a number changes the robots of balanced ones", "[view][balanced]") {
  AppState state = balanced_state();
  Commands commands;
  action(ActionId::more_teams).run(state, commands);
  apply(state, commands);
  CHECK(state.derived().placement->settings.robots == 7);
  CHECK(state.derived().placement->settings.teams == 3);
  for (int i = 0; i < 9; ++i) {
    action(ActionId::fewer_teams).run(state, commands);
    apply(state, commands);
  }
  CHECK(state.derived().placement->settings.robots == 2);
}

TEST_CASE("balanced robots have no chords and no candidates to press", "[view][balanced]") {
  AppState state = balanced_state();
  state.work.show().overlays.candidates = true;
  frame_view(state);
  const Vec2 centre = state.derived().placement->centre_of_mass;
  REQUIRE(standing(state).size() == 6);
  for (const LiftingPoint& robot : standing(state)) {
    const Vec2 between = centre + (robot.position - centre) * 0.6;
    CHECK(pick_explained(state, state.view.camera.to_screen(between)).kind == Pick::Kind::none);
    CHECK(pick_explained(state, state.view.camera.to_screen(robot.position)).kind ==
          Pick::Kind::robot);
  }
}

TEST_CASE("one of three balanced robots is moved by hand, and the others follow",
          "[view][balanced]") {
  AppState state = balanced_state(3);
  take_robots(state, state.derived().search.number, last_robots(state), true);
  const std::string found = robots_text(standing(state));
  const Points& vertices = state.derived().placement->vertices();
  const std::vector<LiftingPoint> before = standing(state);
  const std::uint32_t edge = before[0].edge;
  const Vec2 along = vertices[(edge + 1) % vertices.size()] - vertices[edge];
  give(state, MoveRobot{0, before[0].position + along * 0.02});
  REQUIRE(by_hand(state));
  const std::vector<LiftingPoint> now = standing(state);
  Vec2 sum;
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(length(now[i].position - before[i].position) > 0);
    sum += now[i].position;
  }
  const double size = state.derived().placement->polygon().diagonal();
  CHECK(length(sum / 3 - state.derived().placement->centre_of_mass) < 1e-9 * size);
  CHECK(state.derived().placement->loads->spread == 0);
  CHECK(state.work.history.undoes() == Edit::robots_moved);
  CHECK(link_lacks_in_words(state).empty());
  CHECK_FALSE(state.derived().search.under_way);
  // A drag is one undo step.
  give(state, MoveRobot{0, before[0].position + along * 0.03});
  give(state, EndEdit{});
  const std::string moved = robots_text(standing(state));
  give(state, MoveRobot{0, before[0].position + along * 0.04});
  give(state, EndEdit{});
  CHECK(state.work.history.depth() == 2);
  give(state, Undo{});
  CHECK(robots_text(standing(state)) == moved);
  CHECK_FALSE(state.derived().search.under_way);
  // Another weight moves no robot.
  Settings heavier = settings(state);
  heavier.weight = 300;
  give(state, SetSettings{heavier});
  CHECK(robots_text(standing(state)) == moved);
  CHECK(state.derived().placement->loads->max == Approx(100));
  give(state, Undo{});
  // The link restores them.
  AppState again;
  begin(again, placed(decode_link(*encode_link(last_good(state))).value()));
  CHECK(robots_text(standing(again)) == moved);
  CHECK(by_hand(again));
  CHECK_FALSE(again.derived().search.under_way);

  give(state, ResetRobots{});
  CHECK_FALSE(by_hand(state));
  give(state, Undo{});
  CHECK(robots_text(standing(state)) == moved);
  give(state, Redo{});
  take_robots(state, state.derived().search.number, last_robots(state), true);
  CHECK(robots_text(standing(state)) == found);
}

TEST_CASE("a balanced robot stops where the others cannot follow", "[view][balanced]") {
  AppState state = balanced_state(3);
  const Points& piano_outline = state.derived().placement->vertices();
  const Vec2 far_out = state.derived().placement->centre_of_mass * 0.4 + piano_outline[0] * 0.6;
  give(state, MoveCentre{far_out});
  give(state, EndEdit{});
  const Vec2 centre = state.derived().placement->centre_of_mass;
  const Points& vertices = state.derived().placement->vertices();
  std::size_t stopped = 0, moved = 0;
  give(state, SetHeld{{Pick::Kind::robot, 0, 1, standing(state)[1].position}});
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const std::vector<LiftingPoint> before = standing(state);
    give(state, MoveRobot{1, vertices[i]});
    const bool stays = robots_text(standing(state)) == robots_text(before);
    ++(stays ? stopped : moved);
    Vec2 sum;
    for (const LiftingPoint& robot : standing(state)) sum += robot.position;
    CHECK(length(sum / 3 - centre) < 1e-9 * state.derived().placement->polygon().diagonal());
    if (!stays) CHECK(standing(state)[1].position == vertices[i]);
    // The outline is marked as blocked for the robot up to the requested place.
    CHECK(state.view.closed_to.has_value() == stays);
    if (stays) CHECK(state.view.closed_to->position == vertices[i]);
  }
  CHECK(moved > 0);
  CHECK(stopped > 0);
  give(state, SetHeld{});
  CHECK_FALSE(state.view.closed_to);

  // By keys, it gives a message.
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    state.session.notice = {};
    const std::vector<LiftingPoint> before = standing(state);
    give(state, MoveRobot{1, vertices[i]});
    const bool stays = robots_text(standing(state)) == robots_text(before);
    CHECK((state.session.notice.text.find("Robot 2 cannot go there: ") == 0) ==
          (stays && standing(state)[1].position != vertices[i]));
    CHECK_FALSE(state.view.closed_to);
  }
}

TEST_CASE("the shorter way along the outline goes round the corners between two places", "[view]") {
  const Points square{{0, 0}, {4, 0}, {4, 4}, {0, 4}};
  const LiftingPoint foot{{1, 0}, 0}, end{{3, 0}, 0}, right{{4, 1}, 1}, left{{0, 3}, 3};
  CHECK(shorter_way(square, foot, end) == Points{{1, 0}, {3, 0}});
  CHECK(shorter_way(square, end, foot) == Points{{3, 0}, {1, 0}});
  CHECK(shorter_way(square, end, right) == Points{{3, 0}, {4, 0}, {4, 1}});
  CHECK(shorter_way(square, right, end) == Points{{4, 1}, {4, 0}, {3, 0}});
  CHECK(shorter_way(square, foot, left) == Points{{1, 0}, {0, 0}, {0, 3}});
  CHECK(shorter_way(square, {{0, 1}, 3}, left) == Points{{0, 1}, {0, 3}});
}

TEST_CASE("every robot of the first picture can be taken, unless others are shown",
          "[view][balanced]") {
  const auto takes = [](const AppState& state) {
    const LiftingPoint robot = standing(state)[0];
    const Pick on{Pick::Kind::robot, 0, 0, robot.position};
    return can_take_robot(state, on);
  };
  CHECK(takes(balanced_state(3)));
  CHECK(takes(balanced_state(2)));
  AppState teams;
  begin(teams, placed(document(piano)));
  CHECK(takes(teams));
  AppState embedded = balanced_state(3);
  embedded.session.screen.embed = true;
  CHECK(takes(embedded));
  give(teams, OpenWalkthrough{});
  CHECK_FALSE(takes(teams));
}

TEST_CASE("arrows move the robot whose card is open", "[view][balanced]") {
  AppState state = balanced_state(3);
  frame_view(state);
  const Vec2 at = standing(state)[0].position;
  Commands commands;
  CHECK_FALSE(action(ActionId::up).enabled(state));
  int moved = 0;
  give(state, Explain{Pick{Pick::Kind::robot, 0, 0, at}});
  for (const ActionId id : {ActionId::up, ActionId::right, ActionId::down, ActionId::left}) {
    REQUIRE(action(id).enabled(state));
    const Vec2 before = standing(state)[0].position;
    action(id).run(state, commands);
    apply(state, commands);
    REQUIRE(state.derived().explanation);
    CHECK(state.derived().explanation->of.at == standing(state)[0].position);
    moved += standing(state)[0].position != before;
  }
  // It cannot cross to the edge's other side.
  CHECK(moved >= 2);
}

TEST_CASE("the summary names each balanced robot", "[view][balanced]") {
  const AppState state = balanced_state();
  const std::string text = summary(state);
  CHECK(text.find("6 robots carry equal loads of 16.7\u00A0kg (100\u00A0kg in all).") == 0);
  CHECK(text.find("6 robots of 6 requested, method balanced, goal hold.") != std::string::npos);
  CHECK(text.find("Robot 6 at (") != std::string::npos);
}

TEST_CASE("the lesson of balanced robots searches to the end, and nothing searches beside",
          "[view][balanced][walkthrough]") {
  AppState state = balanced_state();
  REQUIRE(state.derived().search.under_way);
  give(state, OpenWalkthrough{});
  REQUIRE(walkthrough_is_open(state));
  CHECK_FALSE(state.derived().search.under_way);
  CHECK(robots_text(standing(state)) == last_robots(state));
  CHECK(timeline(state).count <= most_main_steps);
  // To the end, with words at each step.
  for (std::uint32_t step = 0; step < timeline(state).count; ++step) {
    CHECK(summary(state).find("Step " + std::to_string(step + 1) + " of ") != std::string::npos);
    give(state, MoveSteps{1});
  }
  CHECK(state.view.walkthrough.detail.step.kind == StepKind::result);
}

TEST_CASE("during a drag the lesson traces the start, and after it the whole search",
          "[view][balanced][walkthrough]") {
  AppState state = balanced_state();
  give(state, OpenWalkthrough{});
  const Vec2 corner = state.work.document().vertices[0];
  give(state, MoveVertex{0, corner + Vec2(1, 1)});
  REQUIRE(walkthrough_is_open(state));
  CHECK(state.view.walkthrough.trace->count(StepKind::exchange) == 0);
  CHECK(state.view.walkthrough.trace->history.found);
  give(state, EndEdit{});
  CHECK(state.view.walkthrough.trace->count(StepKind::settled) == 1);
  CHECK(state.derived().placement->search_ended);
  CHECK_FALSE(state.derived().search.under_way);
  CHECK(robots_text(standing(state)) == last_robots(state));
}

TEST_CASE("a press on the edge asks why no robot stands there", "[view][balanced][walkthrough]") {
  AppState state = balanced_state();
  give(state, OpenWalkthrough{});
  Walkthrough& walk = state.view.walkthrough;
  give(state, GoToStep{walk.trace->size() - 1});
  const Vec2 robot = standing(state)[0].position;
  give(state, AskWhy{robot});
  CHECK(walk.why_taken);
  CHECK(walk.why.find("Robot 1 ") == 0);
  const Vec2 middle = (state.work.document().vertices[0] + state.work.document().vertices[1]) / 2;
  give(state, AskWhy{middle});
  CHECK_FALSE(walk.why_taken);
  CHECK(walk.why.find("With a robot here, ") == 0);
  CHECK(length(walk.asked_places.front() - middle) < 1e-6);
  // The next step forgets it.
  give(state, MoveSteps{-1});
  CHECK(walk.asked_places.empty());
}

TEST_CASE("a learner guesses which chord two balanced robots take",
          "[view][balanced][walkthrough][slow]") {
  AppState state;
  Document guitar = document(asset(EVENLIFT_ASSETS_DIR "/polygons/guitar.txt"));
  guitar.settings.method = Method::balanced;
  begin(state, placed(guitar));
  give(state, OpenWalkthrough{});
  Walkthrough& walk = state.view.walkthrough;
  give(state, SetPredict{true});
  give(state, GoToStep{*walk.trace->find(StepKind::mirror, 0)});
  give(state, MoveSteps{1});
  REQUIRE(walk.ask.has_value());
  CHECK(walk.ask->question.kind == QuestionKind::even_chord);
  CHECK(walk.ask->choices.size() == 3);
  const std::uint32_t answer = walk.ask->question.answer;
  SECTION("right") {
    give(state, Guess{answer});
    CHECK(walk.verdict == "Right.");
  }
  SECTION("wrong: what that chord would come to is said") {
    give(state, Guess{answer == 0 ? 1u : 0u});
    CHECK(walk.verdict.find("Not this time: it is chord ") == 0);
    CHECK_FALSE(walk.was_right);
  }
  CHECK(walk.detail.step.kind == StepKind::completion);
}
