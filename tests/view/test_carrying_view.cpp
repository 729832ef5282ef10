#include <string>

#include "actions/pointer.h"
#include "evenlift/output/carrying_words.h"
#include "kit/catch.h"
#include "kit/texts.h"
#include "panels/summary.h"
#include "tools/pick.h"
#include "view/view_page.h"

using namespace evenlift;
using namespace evenlift::view;
using namespace view_page;
using evenlift::testing::plainly;

namespace {

AppState piano() {
  AppState state;
  begin(state, placed(document(asset(EVENLIFT_ASSETS_DIR "/polygons/grand-piano.txt"))));
  return state;
}

void carry(AppState& state, const Carrying& carrying) {
  give(state, showing(state, &Shown::carrying, carrying));
}

bool says(const AppState& state, const std::string& words) {
  return plainly(summary(state)).find(words) != std::string::npos;
}

}  // namespace

TEST_CASE("a slope makes ranges of the loads, and a steep one tips the object", "[view][tilt]") {
  AppState state = piano();
  const double level = state.derived().report.greatest;
  const std::string before = verdict(state).detail;
  CHECK(carrying_words(state).empty());
  carry(state, {.com_height = 600});
  CHECK(says(state, "In the worst direction it tips at a slope of 27.8°"));
  CHECK(state.derived().report.greatest == level);
  carry(state, {.com_height = 600, .slope = 0.1});
  CHECK(state.derived().report.greatest > level);
  CHECK(state.derived().report.loads[0].least < state.derived().report.loads[0].greatest);
  CHECK(says(state, "on slopes up to 10 %"));
  CHECK(verdict(state).detail == before);
  carry(state, {.com_height = 600, .slope = 0.6});
  CHECK(verdict(state).mood == Mood::falls);
  CHECK(plainly(verdict(state).headline) == "On a slope of 60 % it tips.");
  CHECK(plainly(verdict(state).detail)
            .starts_with("On level ground and with C as given, 6 robots carry "));
  give(state, Undo{});
  CHECK(verdict(state).detail == before);
  CHECK(in_words(state.work.history.redoes()) == "changed the slope");
}

TEST_CASE("nothing of how the object is carried places robots", "[view][tilt]") {
  AppState state = piano();
  const Points before = positions(lifting_points(state.derived().placement->teams));
  const auto placed = state.derived().placed;
  carry(
      state,
      {.com_height = 100, .slope = 0.1, .acceleration = 0.2, .give = 3, .uneven = 1, .extra = 80});
  CHECK(positions(lifting_points(state.derived().placement->teams)) == before);
  CHECK(state.derived().placed.settings == placed.settings);
}

TEST_CASE("another load is followed as the capacity changes", "[view][tilt]") {
  AppState state = piano();
  CHECK_FALSE(state.derived().report.extra);
  carry(state, {.extra = 50});
  REQUIRE(state.derived().report.extra);
  const double free = state.derived().report.extra->share;
  CHECK(says(state, "Another 50 kg may stand "));
  give(state, showing(state, &Shown::capacity, 30));
  CHECK(state.derived().report.extra->share < free);
  give(state, showing(state, &Shown::capacity, std::optional<double>()));
  CHECK(state.derived().report.extra->share == free);
  give(state, SetMethod{Method::given});
  const double of_supports = state.derived().report.extra->share;
  give(state,
       showing(state, &Shown::support_capacities, std::vector<std::optional<double>>(6, 30)));
  CHECK(state.derived().report.extra->share < of_supports);
  carry(state, {});
  CHECK_FALSE(state.derived().report.extra);
}

TEST_CASE("the failures that tip it on a slope are told, and those that hold are not",
          "[view][tilt][failing]") {
  AppState state = piano();
  const auto mood = [&](std::size_t robot) {
    return mood_of(state, state.derived().report.failures[robot]);
  };
  CHECK(mood(4) == Mood::good);
  carry(state, {.com_height = 600, .slope = 0.5});
  CHECK(mood(4) == Mood::falls);
  give(state, Fail{4});
  CHECK(plainly(verdict(state).headline) == "Robot 5 fails: it tips on a slope of 50 %.");
  // What tips carries nothing, and no press is needed.
  CHECK_FALSE(says(state, "carries"));
  CHECK_FALSE(says(state, "pressed down"));
  carry(state, {.com_height = 600, .slope = 0.05});
  CHECK(plainly(verdict(state).headline).find("within the given conditions.") != std::string::npos);
}

TEST_CASE("the grip of the ring sets the C uncertainty beyond what a slope adds", "[view][tilt]") {
  AppState state = piano();
  Shown now = shown(state);
  now.overlays.halo = true;
  now.com_radius = 20;
  now.carrying = {.com_height = 600, .slope = 0.1};
  give(state, SetShown{now});
  const auto grip = uncertainty_grip(state);
  REQUIRE(grip);
  CHECK(std::abs(uncertainty_for_grip(state, *grip) - 20) < 1 / state.view.camera.scale);
}

TEST_CASE("a finger drags the load over the object, and pans the picture where none is asked about",
          "[view][tilt]") {
  AppState state = piano();
  const auto touch = [&](Pointer pointer) {
    pointer.present = pointer.touch = true;
    Commands commands;
    interact(state, pointer, commands);
    for (Command& command : commands) give(state, std::move(command));
  };
  // Between what can be taken.
  Vec2 from = state.view.camera.to_screen(state.derived().placement->centre_of_mass) + Vec2(30, 30);
  while (pick(state, from).kind != Pick::Kind::object) from += Vec2(3, 7);
  const Vec2 to = from + Vec2(20, 0);
  const auto drag = [&] {
    touch({.at = from, .pressed = true, .down = true});
    touch({.at = to, .down = true, .moved = 20});
    touch({.at = to, .released = true, .moved = 20});
  };
  const auto corner = [&] { return state.view.camera.to_world(Vec2(0, 0)); };
  const Vec2 before = corner();
  Shown now = shown(state);
  now.overlays.load = true;
  give(state, SetShown{now});
  carry(state, {.extra = 50});
  drag();
  CHECK(corner() == before);
  CHECK(state.view.hover.kind == Pick::Kind::object);
  CHECK(length(state.view.camera.to_screen(state.view.hover.at) - to) < 1e-6);
  carry(state, {});
  drag();
  CHECK_FALSE(corner() == before);
}
