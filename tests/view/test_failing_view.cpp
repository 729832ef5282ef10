#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "derive/derive.h"
#include "evenlift/output/robustness_words.h"
#include "kit/catch.h"
#include "panels/summary.h"
#include "tools/pick.h"
#include "view/view_page.h"

using namespace evenlift;
using namespace evenlift::view;
using namespace view_page;

namespace {

const std::string piano = asset(EVENLIFT_ASSETS_DIR "/polygons/grand-piano.txt");

AppState state_of(Method method) {
  AppState state;
  Document shown = document(piano);
  shown.settings.method = method;
  begin(state, placed(shown));
  return state;
}

std::size_t robots(const AppState& state) { return count_robots(state.derived().placement->teams); }

}  // namespace

TEST_CASE("a robot that fails is left out of the base and of the loads, with every method",
          "[view][failing]") {
  for (const Method method : all_methods) {
    AppState state = state_of(method);
    INFO(name(method));
    const Points base = state.derived().placement->lifting_base;
    REQUIRE(state.derived().report.failures.size() == robots(state));
    for (std::size_t robot = 0; robot < robots(state); ++robot) {
      give(state, Fail{robot});
      REQUIRE(failing(state));
      const Placement& shown = shown_placement(state);
      CHECK(shown.coverage < state.derived().placement->coverage);
      CHECK(verdict(state).headline == failure_in_words(*state.derived().placement, robot,
                                                        state.derived().report.failures[robot]));
      CHECK(verdict(state).detail.starts_with(rest_in_words(shown)));
      const Report& report = shown_report(state);
      double sum = 0;
      for (const LoadRange& load : report.loads) sum += load.greatest;
      CHECK(report.loads[robot].greatest == 0);
      CHECK(shown.loads.has_value() == state.derived().report.failures[robot].has_value());
      if (!shown.loads) continue;
      CHECK(std::abs(sum - 100) < 1e-9);
      CHECK(report.greatest == state.derived().report.failures[robot]->greatest_by_springs);
      CHECK(std::abs(shown.coverage - state.derived().report.failures[robot]->coverage) < 1e-12);
      CHECK(shown.closure.form_closure == state.derived().report.failures[robot]->form_closure);
      CHECK(report.robustness.tipping_distance ==
            state.derived().report.failures[robot]->tipping_distance);
    }
    give(state, Fail{});
    CHECK_FALSE(failing(state));
    CHECK(shown_placement(state).lifting_base == base);
  }
}

TEST_CASE("letting a robot fail places nothing and is no step of undo", "[view][failing]") {
  AppState state = state_of(Method::area);
  const std::uint64_t before = computed().placements, revision = state.derived().revision;
  const std::uint64_t traces = computed().traces;
  give(state, Fail{2});
  give(state, Fail{4});
  give(state, showing(state, &Shown::overlays, {}));
  give(state, SetLoadModel{LoadModel::springs});
  give(state, Fail{});
  CHECK(computed().placements == before);
  CHECK(computed().traces == traces);
  CHECK(state.derived().revision > revision);
  CHECK_FALSE(state.work.history.can_undo());
}

TEST_CASE("a change of settings, of the polygon or by undo brings the robot back",
          "[view][failing]") {
  AppState state = state_of(Method::area);
  const auto fails_until = [&](Command command) {
    give(state, Fail{1});
    REQUIRE(failing(state));
    give(state, std::move(command));
    return !failing(state) && state.derived().report.failures.size() == robots(state);
  };
  Settings fewer = settings(state);
  fewer.teams = 2;
  CHECK(fails_until(SetSettings{fewer}));
  CHECK(fails_until(Undo{}));
  CHECK(fails_until(MoveVertex{0, state.work.document().vertices[0] + Vec2(1, 1)}));
  give(state, EndEdit{});
  CHECK(fails_until(MoveCentre{state.derived().placement->centre_of_mass + Vec2(1, 1)}));
  give(state, EndEdit{});
  // Edits that place no robots keep the failure.
  give(state, Fail{1});
  give(state, showing(state, &Shown::capacity, 30.0));
  give(state, showing(state, &Shown::com_radius, 1.0));
  CHECK(failing(state));
}

TEST_CASE("a lesson shows no failure", "[view][failing]") {
  AppState state = state_of(Method::area);
  give(state, Fail{1});
  give(state, OpenWalkthrough{});
  CHECK_FALSE(failing(state));
  give(state, CloseWalkthrough{});
  CHECK(failing(state));
}

TEST_CASE("better places that a search finds bring the robot back", "[view][failing][balanced]") {
  AppState state = state_of(Method::balanced);
  REQUIRE(state.derived().search.under_way);
  give(state, Fail{0});
  REQUIRE(failing(state));
  const std::string found = robots_text(lifting_points(place(state.work.document())->teams));
  REQUIRE(take_robots(state, state.derived().search.number, found, true));
  CHECK_FALSE(failing(state));
  CHECK(state.derived().report.failures.size() == 6);
}

TEST_CASE("keys let one robot after another fail, and Esc brings all back", "[view][failing]") {
  Page page;
  AppState& state = page.app.state;
  const std::size_t all = robots(state);
  for (std::size_t robot = 0; robot < all; ++robot) {
    page.press({"F"});
    REQUIRE(failing(state));
    CHECK(failing(state)->robot == robot);
  }
  page.press({"F"});
  CHECK_FALSE(failing(state));
  give(state, Explain{Pick{Pick::Kind::robot, 1, 0, Vec2{}}});
  page.press({"F"});
  CHECK(failing(state)->robot == 2);
  page.press({"Escape"});
  CHECK_FALSE(failing(state));
  CHECK_FALSE(state.derived().explanation);
}

TEST_CASE("a press on the ground brings the robot back, and one on a robot opens its card",
          "[view][failing]") {
  Page page;
  page.frame();
  AppState& state = page.app.state;
  give(state, Fail{0});
  page.click(state.derived().placement->teams[1].robots[0].point.position);
  CHECK(failing(state));
  REQUIRE(state.derived().explanation);
  CHECK(state.derived().explanation->robot == 2);
  page.click(Vec2(300, 250));  // beside the L
  CHECK_FALSE(failing(state));
  CHECK_FALSE(state.derived().explanation);
}

TEST_CASE("while a robot fails the verdict has the row's sign", "[view][failing]") {
  AppState state = state_of(Method::area);
  for (std::size_t i = 0; i < robots(state); ++i) {
    give(state, Fail{i});
    REQUIRE(failing(state));
    CHECK(verdict(state).mood == mood_of(state, state.derived().report.failures[i]));
  }
}

TEST_CASE("what happens if a robot fails is said and has its sign", "[view][failing]") {
  AppState state = state_of(Method::area);
  for (std::size_t i = 0; i < robots(state); ++i) {
    CHECK(failure_words(state, i) ==
          failure_in_words(*state.derived().placement, i, state.derived().report.failures[i]));
    CHECK(mood_of(state, state.derived().report.failures[i]) == Mood::good);
  }
  give(state, showing(state, &Shown::capacity, 25.0));
  const auto overloaded =
      std::count_if(state.derived().report.failures.begin(), state.derived().report.failures.end(),
                    [&](const auto& rest) { return mood_of(state, rest) == Mood::not_quite; });
  CHECK(overloaded > 0);
  CHECK(mood_of(state, std::nullopt) == Mood::falls);
}

TEST_CASE("too many robots are not looked at each", "[view][failing]") {
  AppState state;
  Document many = document(piano);
  many.settings.method = Method::distributed;
  many.settings.teams = 64;
  begin(state, placed(many));
  CHECK(state.derived().report.failures.size() == most_failures_known);
  Settings more = settings(state);
  more.teams = 65;
  give(state, SetSettings{more});
  CHECK(state.derived().report.failures.empty());
  give(state, Fail{129});  // but one of them can still fail
  REQUIRE(failing(state));
  CHECK(verdict(state).headline.find("Robot 130 fails: ") == 0);
}

TEST_CASE("the verdict's tip says what loads and stability presume of the robots",
          "[view][failing]") {
  AppState state = state_of(Method::area);
  const std::string presumed = presumed_in_words(state);
  CHECK(presumed.find("controlled forces") != std::string::npos);
  CHECK(presumed.find("push back") != std::string::npos);
  give(state, Fail{1});
  REQUIRE(failing(state));
  CHECK(presumed_in_words(state).find("equally stiff") != std::string::npos);
  CHECK(presumed_in_words(state).find("sudden") != std::string::npos);
  give(state, Fail{});
  CHECK(presumed_in_words(state) == presumed);
  // Where no robot can stand, the verdict does not mention any.
  Document square = document("(0,0)\n(100,0)\n(100,100)\n(0,100)\n");
  square.settings.robot = {.radius = 100, .gap = 10000};
  begin(state, placed(square));
  REQUIRE(state.derived().placement->teams.empty());
  CHECK(presumed_in_words(state).empty());
}

TEST_CASE("a C uncertainty makes the program's ranges, and sentences that say how far they hold",
          "[view][uncertainty]") {
  AppState state = state_of(Method::area);
  CHECK(uncertainty_words(state).empty());
  give(state, showing(state, &Shown::com_radius, 20));
  CHECK(shown(state).com_radius == 20);
  const ModelLoads models = *model_loads(*state.derived().placement, {.com_radius = 20});
  REQUIRE(models.springs.same_within > 20);
  const auto expected = loads_by(LoadModel::plan, *state.derived().placement, models);
  for (std::size_t i = 0; i < expected.size(); ++i) {
    CHECK(state.derived().report.loads[i].least == expected[i].least);
    CHECK(state.derived().report.loads[i].greatest == expected[i].greatest);
  }
  CHECK(summary(state).find(uncertainty_in_words(reported(state))) != std::string::npos);
  CHECK(verdict(state).headline == loads_in_words({*state.derived().placement, shown(state)}));
  CHECK(verdict(state, Words::in_panel).headline ==
        loads_in_words({*state.derived().placement, shown(state)}, TellWeight::no));
  const double beyond = models.springs.same_within * 1.5;
  give(state, showing(state, &Shown::com_radius, beyond));
  const auto wider = loads_by(LoadModel::plan, *state.derived().placement,
                              model_loads(*state.derived().placement, {.com_radius = beyond}));
  for (std::size_t i = 0; i < wider.size(); ++i) {
    CHECK(state.derived().report.loads[i].least == wider[i].least);
    CHECK(state.derived().report.loads[i].greatest == wider[i].greatest);
  }
  CHECK(state.work.history.depth() == 2);
  const double tips = robustness(*state.derived().placement).tipping_distance;
  CHECK(verdict(state).headline.find("It can tip") == std::string::npos);
  give(state, showing(state, &Shown::com_radius, tips * 1.1));
  CHECK(verdict(state).mood == Mood::falls);
  CHECK(verdict(state).headline.starts_with("It can tip: the centre of mass may be off by "));
  give(state, Undo{});
  give(state, Undo{});
  CHECK(shown(state).com_radius == 20);
}

TEST_CASE(
    "the grip of the C uncertainty is there with its overlay only, and its drag is one step of undo",
    "[view][uncertainty]") {
  Page page;
  page.frame();
  AppState& state = page.app.state;
  CHECK_FALSE(uncertainty_grip(state));
  give(state, showing(state, &Shown::overlays, {.halo = true}));
  REQUIRE(uncertainty_grip(state));
  const std::uint64_t before = computed().placements;
  const Vec2 from = state.view.camera.to_world(*uncertainty_grip(state));
  const Vec2 centre = state.derived().placement->centre_of_mass, out = unit(from - centre);
  page.drag(from, from + out * 40);
  CHECK(std::abs(shown(state).com_radius - 40) < 1.5 / state.view.camera.scale);
  CHECK(computed().placements == before);
  CHECK(state.work.history.depth() == 1);
  page.drag(state.view.camera.to_world(*uncertainty_grip(state)), centre);
  CHECK(shown(state).com_radius == 0);
}

TEST_CASE("units are labels: words follow, and nothing is placed anew", "[view][units]") {
  AppState state = state_of(Method::area);
  give(state, showing(state, &Shown::com_radius, 20));
  give(state, showing(state, &Shown::capacity, 25.0));
  const std::vector<Team> before = state.derived().placement->teams;
  const std::string usual = summary(state);
  REQUIRE(usual.find("\u00A0kg") != std::string::npos);
  give(state, showing(state, &Shown::units, {LengthUnit::mm, WeightUnit::lb}));
  CHECK(shown(state).units == Units{LengthUnit::mm, WeightUnit::lb});
  const std::string labelled = summary(state) + need_in_words(state) + uncertainty_words(state);
  CHECK(labelled.find("\u00A0lb") != std::string::npos);
  CHECK(labelled.find("20\u00A0mm") != std::string::npos);
  CHECK(labelled.find("kg") == std::string::npos);
  REQUIRE(state.derived().placement->teams.size() == before.size());
  for (std::size_t t = 0; t < before.size(); ++t)
    CHECK(state.derived().placement->teams[t].robots[0].load == before[t].robots[0].load);
  give(state, showing(state, &Shown::units, {}));
  CHECK(summary(state) == usual);
  give(state, OpenWalkthrough{});
  give(state, showing(state, &Shown::units, {LengthUnit::mm, WeightUnit::lb}));
  CHECK(state.view.walkthrough.trace->units == shown(state).units);  // for later captions
}

TEST_CASE("the loads of each model are shown, and what they presume is said", "[view][failing]") {
  AppState state = state_of(Method::area);
  const ModelLoads models = *model_loads(*state.derived().placement);
  for (const LoadModel model : all_load_models) {
    give(state, SetLoadModel{model});
    const auto expected = loads_by(model, *state.derived().placement, models);
    for (std::size_t i = 0; i < expected.size(); ++i)
      CHECK(state.derived().report.loads[i].greatest == expected[i].greatest);
    CHECK(model_words(state) ==
          model_in_words({*state.derived().placement, evenlift::Asked{.model = model}}));
    // The headline's loads are the plan's, marked as planned beside another model's.
    CHECK(verdict(state).headline.starts_with("As planned, ") == (model != LoadModel::plan));
  }
}

TEST_CASE("while a robot fails, a capacity speaks of the others by their numbers",
          "[view][failing][capacity]") {
  AppState state = state_of(Method::area);
  give(state, showing(state, &Shown::capacity, 16.0));
  REQUIRE(state.derived().plan);
  give(state, Fail{1});
  REQUIRE(failing(state));
  const std::string words = need_in_words(state);
  CHECK(words.find("the other 5 robots") != std::string::npos);
  CHECK(words.find("team") == std::string::npos);
  CHECK(words.find(state.derived().plan->possible
                       ? "Considering load only, with no failures, this method needs"
                       : "Considering load only, with no failures, even") != std::string::npos);
  give(state, Fail{});
  CHECK(need_in_words(state).find("With no failures") == std::string::npos);
}
