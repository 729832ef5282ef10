#include <algorithm>
#include <cmath>

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
  CHECK(bare.size() == 8);  // the object, C and six robots
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

TEST_CASE("a picture has the holes, and cargo with a lever from the object's own centre of mass",
          "[picture][holes][cargo]") {
  Document document;
  document.vertices = {{0, 0}, {10, 0}, {10, 10}, {0, 10}};
  document.holes = {{{2, 2}, {4, 2}, {4, 4}, {2, 4}}};
  document.settings.weight = 96;
  document.settings.cargo = {{{8, 8}, 24, "motor"}, {{1, 5}, 0.01, ""}};
  const Result<Placement> placed = place(document);
  REQUIRE(placed.ok());
  std::vector<Shape> cargo, levers, own;
  const std::vector<Shape> shapes = make_picture(*placed, {});
  for (const Shape& shape : shapes) {
    if (shape.role == Role::cargo) cargo.push_back(shape);
    if (shape.role == Role::cargo_lever) levers.push_back(shape);
    if (shape.role == Role::own_centre) own.push_back(shape);
  }
  CHECK(shapes.front().holes == document.holes);
  REQUIRE(cargo.size() == 2);
  CHECK(cargo[0].radius == Approx(largest_cargo_disc * std::sqrt(200.0)));
  CHECK(cargo[1].radius / cargo[0].radius == Approx(std::sqrt(0.01 / 24)));
  CHECK((cargo[1].item == 1 && cargo[1].load == 0.01));
  REQUIRE(levers.size() == 1);
  CHECK(levers[0].points == Points{placed->own_centre, placed->centre_of_mass});
  REQUIRE(own.size() == 1);
  CHECK(own[0].points == Points{placed->own_centre});

  // Light cargo is as large as the part of the object with its weight.
  document.settings.cargo = {{{8, 8}, 0.96, ""}};
  const std::vector<double> radii = cargo_radii(*place(document));
  CHECK(3.14159265358979 * radii.at(0) * radii.at(0) == Approx(0.96));
}
