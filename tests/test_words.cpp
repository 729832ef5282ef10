#include "catch.h"
#include "evenlift/output/words.h"

using namespace evenlift;

namespace {

Placement three_teams() {
  Placement placement;
  placement.requested_teams = 3;
  placement.teams.resize(3);
  placement.hull = {{0, 0}, {1, 0}, {0, 1}};
  placement.coverage = 0.814;
  placement.loads = LoadSummary{15.24, 100.0 / 6, 18.06, 2.82, 0.54};
  placement.closure.margin = -0.1;
  placement.closure.translation_free = false;
  placement.closure.clockwise.exists = true;
  return placement;
}

}  // namespace

TEST_CASE("the verdict is a few plain sentences", "[words]") {
  Placement placement = three_teams();
  CHECK(verdict(placement) ==
        "6 robots, each 15.2–18.1 kg of 100. 81 % of the object is safe to push on. "
        "It can still turn clockwise.");
  placement.requested_teams = 5;
  placement.loads = LoadSummary{16.66, 16.66, 16.66, 0, 0.5};
  CHECK(loads_in_words(placement) ==
        "6 robots, each 16.7 kg of 100. Only 3 of the 5 teams asked for could be placed.");
  placement.teams.clear();
  CHECK(verdict(placement).rfind("No team can be placed", 0) == 0);
}

TEST_CASE("what can still move is named", "[words]") {
  Placement placement = three_teams();
  placement.closure.translation_free = true;
  CHECK(closure_in_words(placement) == "It can still turn clockwise and slide.");
  placement.closure.counterclockwise.exists = true;
  CHECK(closure_in_words(placement) == "It can still turn either way and slide.");
  placement.closure.clockwise.exists = false;
  CHECK(closure_in_words(placement) == "It can still turn counter-clockwise and slide.");
  placement.closure.counterclockwise.exists = false;
  CHECK(closure_in_words(placement) == "It can still slide.");
  placement.closure.translation_free = false;
  placement.closure.form_closure = true;
  CHECK(closure_in_words(placement) == "It cannot move: form closure.");
}

TEST_CASE("numbers for people are rounded, never away to nothing or everything", "[words]") {
  CHECK(percentage(0) == "0 %");
  CHECK(percentage(1e-9) == "0.1 %");
  CHECK(percentage(0.0514) == "5.1 %");
  CHECK(percentage(0.814) == "81 %");
  CHECK(percentage(0.99999) == "99.9 %");
  CHECK(percentage(1) == "100 %");
  CHECK(fixed(2.345, 2) == "2.35");
  CHECK(fixed(-0.001, 2) == "0.00");
  CHECK(fixed(-1.5, 0) == "-2");
  CHECK(fixed(0.05, 1) == "0.1");
  CHECK(fixed(1e20, 3) == "100000000000000000000");
  CHECK(decimals_for(16.7) == 1);
  CHECK(decimals_for(100) == 0);
  CHECK(decimals_for(0.0123) == 4);
  CHECK(decimals_for(0) == 9);
}
