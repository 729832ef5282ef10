#include <algorithm>
#include <string>

#include "actions/pointer.h"
#include "edits/undo.h"
#include "edits/vertices.h"
#include "evenlift/link.h"
#include "evenlift/output/verdict.h"
#include "evenlift/supports.h"
#include "kit/catch.h"
#include "panels/summary.h"
#include "state/method.h"
#include "tools/drawing.h"
#include "tools/pick.h"
#include "tools/transform.h"
#include "view/view_page.h"

using namespace evenlift;
using namespace evenlift::view;
using namespace view_page;

namespace {

AppState piano_state() {
  AppState state;
  begin(state, placed(document(asset(EVENLIFT_ASSETS_DIR "/polygons/grand-piano.txt"))));
  frame_view(state);
  return state;
}

const Placement& placement(const AppState& state) { return *state.derived().placement; }

Points robots(const AppState& state) { return positions(lifting_points(placement(state).teams)); }

const Points& supports(const AppState& state) { return settings(state).supports; }

// As a press does.
void hold(AppState& state, std::size_t robot) {
  const auto [team, end] = find_robot(placement(state).teams, robot);
  give(state, SetHeld{{Pick::Kind::robot, team, static_cast<int>(end), Vec2(0, 0)}});
}

void let_go(AppState& state) {
  give(state, SetHeld{});
  give(state, EndEdit{});
}

}  // namespace

TEST_CASE("a drag of any robot takes all over, with one step of undo", "[view][supports]") {
  AppState state = piano_state();
  const Points before = robots(state);
  const std::size_t depth = state.work.history.depth();
  const Vec2 centre = placement(state).centre_of_mass;
  hold(state, 3);
  for (const double part : {0.2, 0.5, 0.8})
    give(state, MoveRobot{3, before[3] + part * (centre - before[3])});
  REQUIRE(settings(state).method == Method::given);
  CHECK(supports(state).size() == before.size());
  CHECK(placement(state).settings.method == Method::given);
  CHECK(placement(state).teams.at(0).robots.at(3).point.edge == beneath);
  for (const std::size_t other : {0u, 1u, 2u, 4u, 5u})
    CHECK(length(supports(state)[other] - before[other]) < 1e-6);
  CHECK(state.session.notice.undo == "Back to Area");
  let_go(state);
  CHECK(state.work.history.depth() == depth + 1);
  CHECK(state.work.history.undoes() == Edit::robots_moved);
  give(state, Undo{});
  CHECK(settings(state).method == Method::area);
  CHECK(robots(state) == before);
}

TEST_CASE("a robot sticks to the outline, to vertices and to even places", "[view][supports]") {
  AppState state = piano_state();
  give(state, SetMethod{Method::given});
  const Polygon& polygon = placement(state).polygon();
  const double pixel = 1 / state.view.camera.scale;
  const Vec2 vertex = polygon.vertex(0);
  CHECK(support_spot(state, vertex + Vec2(5 * pixel, 4 * pixel), 0) == vertex);
  const Vec2 middle = (polygon.edge_start(0) + polygon.edge_end(0)) / 2;
  const auto edge = support_spot(state, middle + Vec2(0, 9 * pixel), 0);
  REQUIRE(edge);
  CHECK(length(*edge - middle) < pixel);
  CHECK_FALSE(support_spot(state, middle - Vec2(0, 30 * pixel), 0));
  const Vec2 opposite = 2 * placement(state).centre_of_mass - robots(state)[1];
  CHECK(even_spot(state, opposite + Vec2(3 * pixel, 0), 0, even_reach) == opposite);
  CHECK_FALSE(even_spot(state, opposite + Vec2(30 * pixel, 0), 0, even_reach));
  // Opposite to its own place is no even place for a robot.
  const Vec2 own = 2 * placement(state).centre_of_mass - robots(state)[0];
  CHECK(even_spot(state, own, 1, even_reach) == own);
  CHECK_FALSE(even_spot(state, own, 0, even_reach));
}

TEST_CASE(
    "in a challenge no robot is taken away: one that is dragged out waits where it last stood",
    "[view][supports]") {
  AppState state = piano_state();
  give(state, SetMethod{Method::given});
  give(state, SetChallenge{true});
  const Points before = supports(state);
  const Vec2 inside = before[2] + Vec2(1, 1);
  hold(state, 2);
  give(state, MoveRobot{2, inside});
  const Points moved = supports(state);
  give(state, MoveRobot{2, placement(state).vertices()[0] - Vec2(1e4, 1e4)});
  let_go(state);
  CHECK(supports(state) == moved);
  CHECK(moved.size() == before.size());
}

TEST_CASE("outside the object a robot is taken away, and comes back until it is let go",
          "[view][supports]") {
  AppState state = piano_state();
  give(state, SetMethod{Method::given});
  const Points before = supports(state);
  const Vec2 outside = placement(state).vertices()[0] - Vec2(1e4, 1e4), was = before[2];
  Shown capacities = shown(state);
  capacities.support_capacities = {10, 20, 30, 40, 50, 60};
  give(state, SetShown{capacities});
  hold(state, 2);
  give(state, MoveRobot{2, was + Vec2(1, 1)});
  give(state, MoveRobot{2, outside});
  CHECK(supports(state).size() == before.size());
  CHECK(robots(state).size() == before.size() - 1);
  CHECK(placement(state).number_of(2) == 4);  // the others keep their numbers
  CHECK(state.view.held.kind == Pick::Kind::left_out);
  CHECK(state.view.dragged_out == 2u);
  give(state, MoveRobot{2, was});
  CHECK(state.view.held.kind == Pick::Kind::robot);
  CHECK(supports(state).size() == before.size());
  CHECK_FALSE(state.view.dragged_out);
  CHECK(shown(state).support_capacities[2] == 30.0);
  give(state, MoveRobot{2, outside});
  let_go(state);
  CHECK(supports(state).size() == before.size() - 1);
  CHECK(supports(state)[2] == before[3]);
  CHECK(shown(state).support_capacities.size() == before.size() - 1);
  give(state, Undo{});
  CHECK(supports(state) == before);
  // The last robot stays.
  while (supports(state).size() > 1) give(state, RemoveRobot{});
  hold(state, 0);
  give(state, MoveRobot{0, outside});
  let_go(state);
  CHECK(supports(state).size() == 1);
}

TEST_CASE("robots are added where they widen the base, and removed", "[view][supports]") {
  AppState state = piano_state();
  give(state, SetMethod{Method::given});
  const double before = placement(state).coverage;
  const std::size_t number = supports(state).size();
  give(state, AddRobot{});
  CHECK(supports(state).size() == number + 1);
  CHECK(placement(state).coverage > before);
  give(state, AddRobot{placement(state).centre_of_mass});
  CHECK(supports(state).size() == number + 2);
  give(state, AddRobot{Vec2(1e6, 1e6)});
  CHECK(supports(state).size() == number + 2);
  give(state, RemoveRobot{0});
  give(state, RemoveRobot{});
  CHECK(supports(state).size() == number);
  CHECK(score(state).starts_with(std::to_string(number) + " robots"));
  // A robot that is added has no capacity of its own.
  Shown limited = shown(state);
  limited.support_capacities = std::vector<std::optional<double>>(number, 1000);
  give(state, SetShown{limited});
  give(state, AddRobot{});
  REQUIRE(shown(state).support_capacities.size() == number + 1);
  CHECK_FALSE(shown(state).support_capacities.back());
}

TEST_CASE("with the tool Robot a click adds a robot there, and a press on a robot grabs it",
          "[view][supports]") {
  AppState state = piano_state();
  const Points before = robots(state);
  const auto frame = [&](Pointer pointer) {
    pointer.present = true;
    Commands commands;
    interact(state, pointer, commands);
    for (Command& command : commands) give(state, std::move(command));
  };
  const auto click = [&](const Vec2& at) {
    frame({.at = at, .pressed = true, .down = true});
    frame({.at = at, .released = true});
  };
  give(state, SetTool{Tool::robot});
  const Polygon& polygon = placement(state).polygon();
  const Vec2 middle = (polygon.edge_start(0) + polygon.edge_end(0)) / 2;
  click(state.view.camera.to_screen(middle) + Vec2(3, -4));
  REQUIRE(supports(state).size() == before.size() + 1);
  CHECK(settings(state).method == Method::given);
  CHECK(placement(state).teams[0].robots.back().point.edge == 0);
  CHECK(state.view.tool == Tool::robot);
  click(state.view.camera.to_screen(robots(state)[2]));  // only grabs it
  CHECK(supports(state).size() == before.size() + 1);
  click({5, 5});  // far outside
  CHECK(supports(state).size() == before.size() + 1);
  give(state, Undo{});
  CHECK(robots(state) == before);
}

TEST_CASE("a typed place is taken exactly, and none outside the object", "[view][supports]") {
  AppState state = piano_state();
  const Points before = supports_now(state);
  CHECK(before.size() == 6);
  const Vec2 to = placement(state).centre_of_mass + Vec2(0.123456789, 1e-7);
  give(state, PutRobot{4, to});
  REQUIRE(settings(state).method == Method::given);
  CHECK(supports(state)[4] == to);
  for (const std::size_t other : {0u, 1u, 2u, 3u, 5u})
    CHECK(supports(state)[other] == before[other]);
  give(state, PutRobot{4, Vec2(1e6, 1e6)});
  CHECK(supports(state)[4] == to);
  give(state, PutRobot{6, to});
  CHECK(supports(state).size() == 6);
}

TEST_CASE("robots placed by hand are evened out, compared, and kept in the link",
          "[view][supports]") {
  AppState state = piano_state();
  give(state, SetMethod{Method::given});
  hold(state, 0);
  const Vec2 was = robots(state)[0];
  give(state, MoveRobot{0, was + 0.3 * (placement(state).centre_of_mass - was)});
  let_go(state);
  CHECK(placement(state).loads->spread > 1);
  give(state, EvenOut{});
  CHECK(placement(state).loads->spread < 1e-6);
  give(state, Compare{Method::balanced});
  REQUIRE(state.derived().second);
  CHECK(count_robots(state.derived().second->teams) == supports(state).size());
  const auto back = decode_link(*encode_link(state.work.document()));
  REQUIRE(back.ok());
  CHECK(back->settings.supports == supports(state));
  CHECK(summary(state).find("placed by hand") != std::string::npos);
}

TEST_CASE("a support above its own capacity is told and marked", "[view][supports]") {
  AppState state = piano_state();
  give(state, SetMethod{Method::given});
  Shown limited = shown(state);
  limited.support_capacities = {1000, 1, 1000, 1000, 1000, 1000};
  give(state, SetShown{limited});
  CHECK(is_overloaded(state));
  CHECK(is_overloaded(state, 1));
  CHECK_FALSE(is_overloaded(state, 0));
  CHECK(verdict(state).headline == "1 of 6 robots is overloaded: robot 2.");
  CHECK(verdict(state).mood == Mood::falls);
  CHECK(summary(state).find("1 of 6 robots is overloaded: robot 2.") != std::string::npos);
}

TEST_CASE("robots placed by hand belong to the object: they are moved, turned and scaled with it",
          "[view][supports]") {
  AppState state = piano_state();
  give(state, SetMethod{Method::given});
  const Points places = supports(state);
  const Placement before = placement(state);
  for (const SetPolygon& edited : {moved_polygon(state, 7, -3), turned_polygon(state, 2),
                                   scaled_polygon(state, 0.37), scaled_polygon(state, 2.5)}) {
    give(state, edited);
    REQUIRE_FALSE(state.derived().refusal);
    CHECK(std::abs(placement(state).coverage - before.coverage) < 1e-3);
    for (std::size_t i = 0; i < places.size(); ++i)
      CHECK(std::abs(placement(state).teams[0].robots[i].load - before.teams[0].robots[i].load) <
            0.1);
    give(state, EndEdit{});
    give(state, Undo{});
    CHECK(supports(state) == places);
  }
}

TEST_CASE("a dragged vertex takes along the robots on its edges, and leaves out those beneath",
          "[view][supports]") {
  AppState state;
  begin(state, placed(document("(0,0)\n(400,0)\n(400,300)\n(0,300)\n")));
  frame_view(state);
  Settings own = settings(state);
  own.method = Method::given;
  own.supports = {{400, 75}, {100, 300}, {0, 150}, {350, 250}};
  give(state, SetSettings{own});
  const Points places = supports(state);
  give(state, MoveVertex{2, Vec2(200, 200)});
  REQUIRE_FALSE(state.derived().refusal);
  CHECK(supports(state)[0] == Vec2(350, 50));  // a quarter of its edge, as before
  CHECK(length(supports(state)[1] - Vec2(50, 275)) < 1e-9);
  CHECK(supports(state)[2] == places[2]);
  CHECK(supports(state)[3] == places[3]);  // it stays, now outside
  CHECK(placement(state).left_out == std::vector<Misplaced>{{Misplaced::Kind::support, 3, {}}});
  CHECK(robots(state).size() == 3);
  CHECK(left_out_in_words(placement(state)) ==
        std::vector<std::string>{"Robot 4 is outside the object: it carries nothing."});
  give(state, MoveVertex{2, Vec2(400, 300)});
  for (std::size_t i = 0; i < places.size(); ++i)
    CHECK(length(supports(state)[i] - places[i]) < 1e-9);
  give(state, MoveVertex{2, Vec2(150, 120)});
  give(state, EndEdit{});
  CHECK(supports(state).size() == places.size());
  give(state, Undo{});
  CHECK(supports(state) == places);

  SECTION("and so do holes, that are drawn or moved over them") {
    give(state, SetTool{Tool::hole});
    for (const Vec2& corner : {Vec2(300, 200), Vec2(380, 200), Vec2(380, 280), Vec2(300, 280)})
      give(state, AddPoint{corner});
    give(state, FinishDrawing{});
    REQUIRE(state.work.document().holes.size() == 1);
    REQUIRE_FALSE(state.derived().refusal);
    CHECK(supports(state) == places);
    CHECK(placement(state).left_out == std::vector<Misplaced>{{Misplaced::Kind::support, 3, 0u}});
    CHECK(left_out_in_words(placement(state)) ==
          std::vector<std::string>{"Robot 4 is in hole 1: it carries nothing."});
  }
  SECTION("and a removed vertex") {
    give(state, RemoveVertex{2});
    REQUIRE_FALSE(state.derived().refusal);
    CHECK(supports(state) == places);
    CHECK(placement(state).left_out.size() == 3);
    CHECK(placement(state).number_of(0) == 3);
  }
  SECTION("all of them, and one is dragged back") {
    give(state, MoveVertex{2, Vec2(200, 1)});
    give(state, EndEdit{});
    Settings far = settings(state);
    for (Vec2& support : far.supports) support = Vec2(1000, 1000) + support;
    give(state, SetSettings{far});
    REQUIRE_FALSE(state.derived().refusal);
    CHECK(placement(state).teams.empty());
    CHECK(placement(state).left_out.size() == 4);
    state.view.held = left_out_at(state, state.view.camera.to_screen(far.supports[1]));
    CHECK(state.view.held.index == 1);
    give(state, MoveRobot{1, Vec2(900, 900)});  // anywhere
    CHECK(supports(state)[1] == Vec2(900, 900));
    give(state, MoveRobot{1, Vec2(100, 0)});
    let_go(state);
    CHECK(robots(state) == Points{Vec2(100, 0)});
    CHECK(placement(state).number_of(0) == 2);
    CHECK(supports(state).size() == 4);
  }
}

TEST_CASE("an edit of the outline is not refused for C, but a C that is typed outside is",
          "[view][supports]") {
  AppState state;
  Document plate = document("(0,0)\n(400,0)\n(400,300)\n(0,300)\n");
  plate.centre_of_mass = Vec2(230, 170);
  begin(state, placed(plate));
  frame_view(state);
  const std::size_t before = robots(state).size();
  REQUIRE(before > 0);
  give(state, MoveVertex{2, Vec2(150, 120)});
  REQUIRE_FALSE(state.derived().refusal);
  CHECK(robots(state).empty());
  CHECK(placement(state).centre_of_mass == Vec2(230, 170));
  CHECK(judge({placement(state), shown(state)}).kind == VerdictKind::bad);
  for (const Method method : all_methods) {
    give(state, SetMethod{method});
    REQUIRE_FALSE(state.derived().refusal);
    CHECK(robots(state).empty());
  }
  give(state, SetMethod{Method::area});
  // What was outside before may stay during other edits.
  Document heavier = state.work.document();
  heavier.settings.weight = 50;
  CHECK_FALSE(edit_by_script(state, heavier));
  give(state, MoveVertex{2, Vec2(400, 300)});
  CHECK(robots(state).size() == before);
  Document typed = state.work.document();
  typed.centre_of_mass = Vec2(500, 200);
  CHECK(edit_by_script(state, typed)->code == ErrorCode::centre_outside_hull);
  typed = state.work.document();
  typed.settings = with_method(typed.settings, Method::given, 1);
  typed.settings.supports = {{0, 0}, {400, 0}, {900, 0}};
  CHECK(edit_by_script(state, typed)->place.option == "supports[2]");
  CHECK(robots(state).size() == before);
}

TEST_CASE("an edit of the outline is not refused for a hole: it is left out until it fits",
          "[view][supports]") {
  AppState state;
  begin(state, placed(document("(0,0)\n(400,0)\n(400,300)\n(0,300)\n")));
  frame_view(state);
  for (const double x : {50.0, 300.0}) {
    give(state, SetTool{Tool::hole});
    for (const Vec2& corner : {Vec2(x, 200), Vec2(x + 50, 200), Vec2(x + 50, 250), Vec2(x, 250)})
      give(state, AddPoint{corner});
    give(state, FinishDrawing{});
  }
  const Placement before = placement(state);
  REQUIRE(before.object.holes().size() == 2);
  give(state, MoveVertex{3, Vec2(100, 300)});
  REQUIRE_FALSE(state.derived().refusal);
  CHECK(placement(state).left_out == std::vector<Misplaced>{{Misplaced::Kind::hole, 0, {}}});
  CHECK(placement(state).object.holes().size() == 1);
  CHECK(left_out_in_words(placement(state)) ==
        std::vector<std::string>{"Hole 1 does not fit the object, and is left out."});
  CHECK(state.work.document().holes.size() == 2);
  give(state, MoveVertex{3, Vec2(0, 300)});
  CHECK(placement(state).left_out.empty());
  CHECK(placement(state).coverage == before.coverage);
}

TEST_CASE("the settings of another polygon include robots placed by hand", "[view][supports]") {
  AppState state = piano_state();
  give(state, SetMethod{Method::given});
  Document edited =
      with_settings_of(document("(0,0)\n(90,0)\n(90,90)\n(0,90)\n"), state.work.document());
  CHECK(edited.settings.supports == supports(state));
  CHECK_FALSE(place(edited).ok());  // the program refuses what the page leaves out
  CHECK(place(edited, Effort::whole, Misfitting::left_out).ok());
}

TEST_CASE("a new outline begins with the method before, and one undo brings the robots back",
          "[view][supports]") {
  AppState state = piano_state();
  give(state, SetMethod{Method::circle});
  give(state, PlaceYourself{4});
  const Points places = supports(state);
  give(state, SetTool{Tool::draw});
  for (const Vec2& corner : {Vec2(5000, 0), Vec2(5400, 0), Vec2(5400, 300), Vec2(5000, 300)})
    give(state, AddPoint{corner});
  give(state, FinishDrawing{});
  CHECK(state.work.document().vertices.size() == 4);
  REQUIRE_FALSE(state.derived().refusal);
  CHECK(settings(state).method == Method::circle);
  CHECK(settings(state).teams == 2u);
  CHECK(state.session.notice.text ==
        "The robots are placed by circle: yours stay with the former object.");
  CHECK(state.session.notice.undo == "Back to mine");
  give(state, Undo{});
  CHECK(supports(state) == places);
}

TEST_CASE("another method leaves the supports, and by hand takes its robots over",
          "[view][supports]") {
  AppState state = piano_state();
  give(state, SetMethod{Method::given});
  give(state, SetMethod{Method::circle});
  CHECK(supports(state).empty());
  const Points circle = robots(state);
  give(state, SetMethod{Method::given});
  for (std::size_t i = 0; i < circle.size(); ++i)
    CHECK(length(supports(state)[i] - circle[i]) < 1e-6);
}

TEST_CASE("the steps of supports tell where they stand and what they carry",
          "[view][supports][trace]") {
  AppState state = piano_state();
  give(state, SetMethod{Method::given});
  give(state, OpenWalkthrough{});
  REQUIRE(walkthrough_is_open(state));
  const Trace& trace = *state.view.walkthrough.trace;
  CHECK(trace.count(StepKind::support) == 6);
  for (std::uint32_t k = 0; k < trace.size(); ++k) {
    give(state, GoToStep{k});
    INFO(name(trace.step(k).kind));
    CHECK_FALSE(state.view.walkthrough.caption.empty());
    frame_view(state);
  }
  give(state, CloseWalkthrough{});
  while (supports(state).size() > 1) give(state, RemoveRobot{});
  give(state, OpenWalkthrough{});  // one robot: the object falls
  CHECK(state.view.walkthrough.trace->count(StepKind::falls) == 1);
  CHECK(state.view.walkthrough.trace->count(StepKind::loads) == 0);
  for (std::uint32_t k = 0; k < state.view.walkthrough.trace->size(); ++k) {
    give(state, GoToStep{k});
    frame_view(state);
  }
}
