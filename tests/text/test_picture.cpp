#include <algorithm>

#include "evenlift/output/picture.h"
#include "evenlift/placement.h"
#include "kit/corpus.h"

using namespace evenlift;

TEST_CASE("a picture shows what the overlays ask for, back to front", "[picture]") {
  const Result<Placement> placed = place(corpus::polygon("kidney-table"));
  REQUIRE(placed.ok());
  const Placement& placement = *placed;
  const auto roles = [&](const Overlays& overlays) {
    std::vector<Role> seen;
    for (const Shape& shape : make_picture(placement, overlays)) seen.push_back(shape.role);
    return seen;
  };
  const auto number = [](const std::vector<Role>& seen, Role role) {
    return static_cast<std::size_t>(std::count(seen.begin(), seen.end(), role));
  };
  const std::vector<Role> usual = roles({});
  CHECK(usual.front() == Role::object);
  CHECK(number(usual, Role::lifting_base) == 1);
  CHECK(number(usual, Role::candidate) == 0);
  CHECK(number(usual, Role::chord) == 3);
  CHECK(number(usual, Role::robot) == 6);
  CHECK(usual.back() == Role::robot);
  const std::vector<Role> bare = roles({.candidates = false,
                                        .chords = false,
                                        .lifting_base = false,
                                        .clockwise = false,
                                        .counterclockwise = false});
  CHECK(bare.size() == 8);  // the object, its centre of mass and six robots
  const std::vector<Role> all = roles({.candidates = true});
  CHECK(number(all, Role::candidate) + 3 == placement.candidates.size());
}

TEST_CASE("a line joins each balanced robot with the centre of mass", "[picture][balanced]") {
  Document document = corpus::polygon("kidney-table");
  document.settings.method = Method::balanced;
  document.settings.robots = 5;
  const Result<Placement> placement = place(document);
  REQUIRE(placement.ok());
  std::size_t lines = 0, robots = 0;
  for (const Shape& shape : make_picture(*placement, {})) {
    if (shape.role == Role::robot) ++robots;
    if (shape.role != Role::chord) continue;
    ++lines;
    CHECK(shape.points.back() == placement->centre_of_mass);
  }
  CHECK(lines == 5);
  CHECK(robots == 5);
}
