#include "evenlift/result.h"
#include "kit/catch.h"

using namespace evenlift;

TEST_CASE("a result holds a value or an error", "[result]") {
  const Result<int> good = 7;
  CHECK(good.ok());
  CHECK(*good == 7);
  const Result<int> bad = InputError{ErrorCode::bad_syntax, "no", {Place::Kind::line, 3, 1, {}}};
  CHECK(!bad.ok());
  CHECK(bad.error().code == ErrorCode::bad_syntax);
  CHECK(bad.error().place.index == 3);
}

TEST_CASE("places are told as people count", "[result]") {
  using Kind = Place::Kind;
  CHECK(describe(Place{}).empty());
  CHECK(describe(Place{Kind::line, 4, 0, {}}) == "line 4");
  CHECK(describe(Place{Kind::line, 4, 7, {}}) == "line 4, column 7");
  CHECK(describe(Place{Kind::line, 4, 4, {}}) == "line 4, column 4");
  CHECK(describe(Place{Kind::vertex, 0, 0, {}}) == "vertex 1");
  CHECK(describe(Place{Kind::vertex, 2, 2, {}}) == "vertex 3");
  CHECK(describe(Place{Kind::vertex, 2, 0, {}}) == "vertex 3");
  CHECK(describe(Place{Kind::vertex, 2, 6, {}}) == "vertices 3 and 7");
  CHECK(describe(Place{Kind::edge, 1, 1, {}}) == "edge 2");
  CHECK(describe(Place{Kind::edge, 0, 6, {}}) == "edges 1 and 7");
  CHECK(describe(Place{Kind::centre_of_mass, 0, 0, {}}) == "centre of mass");
  CHECK(describe(Place{Kind::option, 0, 0, "min_ratio"}) == "min_ratio");
  CHECK(describe(Place{Kind::link, 0, 0, {}}) == "link");
  CHECK(describe(Place{Kind::link, 5, 0, {}}) == "link, character 5");
}
