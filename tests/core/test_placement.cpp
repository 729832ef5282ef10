// Every sample keeps the rules with every metric; refusals; the thesis's numbers.
#include "evenlift/placement.h"

#include <array>
#include <limits>
#include <string>

#include "kit/catch.h"
#include "kit/check_placement.h"
#include "kit/corpus.h"
#include "shapes/problem_document.h"
#include "shapes/small_polygons.h"

using namespace evenlift;

namespace {

const Points thesis_sample{{539, 220}, {403, 115}, {386, 219}, {278, 306}, {149, 187}, {263, 124},
                           {88, 101},  {82, 320},  {133, 437}, {546, 446}, {665, 426}};
const Points square{{0, 0}, {2, 0}, {2, 2}, {0, 2}};

Document document(Points vertices, const std::optional<Vec2>& centre = {}) {
  Document d;
  d.vertices = std::move(vertices);
  d.centre_of_mass = centre;
  return d;
}

void check_samples(Method method) {
  int placed = 0;
  for (const std::string& name : corpus::polygon_names()) {
    Document d = corpus::polygon(name);
    d.settings.method = method;
    for (const double min_ratio : {0.5, 0.8, 1.0}) {
      for (const std::uint32_t teams : {1u, 3u, 10u}) {
        d.settings.min_ratio = min_ratio;
        d.settings.teams = teams;
        const auto placement = place(d);
        INFO(name << ", minimum load ratio " << min_ratio << ", teams " << teams);
        REQUIRE(placement.ok());
        const std::string wrong = check::check_placement(*placement);
        INFO(wrong);
        CHECK(wrong.empty());
        placed += static_cast<int>(placement->teams.size());
      }
    }
  }
  CHECK(placed > 2000);
}

InputError refusal(const Document& d) {
  const auto placement = place(d);
  REQUIRE_FALSE(placement.ok());
  CHECK_FALSE(placement.error().message.empty());
  return placement.error();
}

}  // namespace

TEST_CASE("every sample polygon is placed by the rules: area", "[placement][slow]") {
  check_samples(Method::area);
}
TEST_CASE("every sample polygon is placed by the rules: circle", "[placement][slow]") {
  check_samples(Method::circle);
}
TEST_CASE("every sample polygon is placed by the rules: distance", "[placement][slow]") {
  check_samples(Method::distance);
}
TEST_CASE("every sample polygon is placed by the rules: distributed", "[placement][slow]") {
  check_samples(Method::distributed);
}
TEST_CASE("every sample polygon is placed by the rules: random", "[placement][slow]") {
  check_samples(Method::random);
}

TEST_CASE("thousands of small polygons are placed by the rules", "[placement][thorough]") {
  int with_area = 0, closed = 0, second_order = 0;
  for (std::uint64_t number = 0; number < 2000; ++number) {
    const small_polygons::Case c = small_polygons::make_case(number);
    Document d = evenlift::testing::document_of(c.problem);
    d.settings.method = pair_methods[number % std::size(pair_methods)];
    d.settings.seed = number;
    const auto placement = place(d);
    INFO("case " << number << ", " << c.name << ", " << name(d.settings.method));
    REQUIRE(placement.ok());
    const std::string wrong = check::check_placement(*placement);
    INFO(wrong);
    CHECK(wrong.empty());
    with_area += placement->lifting_base.size() > 2;
    closed += placement->closure.form_closure;
    second_order += placement->closure.second_order;
  }
  CHECK(with_area > 750);
  CHECK(closed > 50);
  CHECK(second_order > 5);
}

TEST_CASE("the thesis's sample has 3 candidates, covers 8.2 % and is not closed", "[placement]") {
  const auto placement = place(corpus::polygon("thesis-sample"));
  REQUIRE(placement.ok());
  CHECK(placement->centre_of_mass == Vec2(278, 227));
  CHECK(placement->candidates.size() == 3);
  CHECK(placement->teams.size() == 3);
  CHECK(placement->coverage == Approx(0.082).margin(0.0005));
  CHECK_FALSE(placement->closure.form_closure);
  CHECK_FALSE(placement->closure.second_order);
}

TEST_CASE("the thesis's sample about its centroid has 9 candidates and covers about 80 %",
          "[placement]") {
  const auto placement = place(document(thesis_sample));
  REQUIRE(placement.ok());
  CHECK(placement->candidates.size() == 9);
  CHECK(placement->teams.size() == 3);
  CHECK(placement->coverage == Approx(0.80).margin(0.01));
}

TEST_CASE("a square is covered by teams on its diagonals and held by those at its sides' midpoints",
          "[placement]") {
  Document four = document(square);
  four.settings.teams = 4;
  const auto placement = place(four);
  REQUIRE(placement.ok());
  REQUIRE(placement->teams.size() == 4);
  CHECK(placement->team_candidates == std::vector<std::uint32_t>{0, 2, 1, 3});
  CHECK(placement->candidates[0].kind == CandidateKind::bisecting);
  CHECK(placement->candidates[1].kind == CandidateKind::midpoint);
  CHECK(placement->lifting_base == Points{{0, 0}, {2, 0}, {2, 2}, {0, 2}});
  CHECK(placement->coverage == 1);
  for (const Robot& robot : placement->teams[0].robots) CHECK(robot.load == 12.5);
  CHECK_FALSE(placement->closure.translation_free);
  CHECK_FALSE(placement->closure.form_closure);
  CHECK(placement->closure.second_order);
}

TEST_CASE("with max every candidate carries a part", "[placement]") {
  Document d = document(thesis_sample);
  d.settings.teams = std::nullopt;
  const auto placement = place(d);
  REQUIRE(placement.ok());
  CHECK(placement->requested_teams == 9);
  CHECK(placement->teams.size() == 9);
  for (const Method method : {Method::distributed, Method::random}) {
    d.settings.method = method;
    const InputError error = refusal(d);
    CHECK(error.code == ErrorCode::bad_setting);
    CHECK(error.place.option == "teams");
  }
}

TEST_CASE("settings out of range are refused by name", "[placement][refusal]") {
  const double infinity = std::numeric_limits<double>::infinity();
  const auto option = [](auto change) {
    Document d = document(square);
    change(d.settings);
    const InputError error = refusal(d);
    CHECK(error.code == ErrorCode::bad_setting);
    CHECK(error.place.kind == Place::Kind::option);
    return error.place.option;
  };
  CHECK(option([](Settings& s) { s.teams = 0; }) == "teams");
  CHECK(option([](Settings& s) { s.teams = max_teams + 1; }) == "teams");
  for (const double ratio : {-0x1p-1074, std::nextafter(1.0, 2.0), std::nan(""), infinity})
    CHECK(option([&](Settings& s) { s.min_ratio = ratio; }) == "min_ratio");
  for (const double weight : {0.0, -1.0, 5e-324, 1.797e308, std::nan(""), infinity})
    CHECK(option([&](Settings& s) { s.weight = weight; }) == "weight");
}

TEST_CASE("settings at the ends of their ranges are taken", "[placement]") {
  Document d = document(square);
  for (const double ratio : {0.0, 1.0}) {
    for (const double weight : {min_weight, max_weight}) {
      d.settings.min_ratio = ratio;
      d.settings.weight = weight;
      d.settings.teams = 1;
      const auto placement = place(d);
      REQUIRE(placement.ok());
      CHECK(placement->teams.at(0).robots[0].load == 0.5 * weight);
    }
  }
}

TEST_CASE("a polygon is refused with its reason and place", "[placement][refusal]") {
  const double infinity = std::numeric_limits<double>::infinity();
  const auto is = [](Points vertices, ErrorCode code, Place::Kind kind, std::size_t index,
                     std::size_t other) {
    const InputError error = refusal(document(std::move(vertices)));
    CHECK(error.code == code);
    CHECK(error.place.kind == kind);
    CHECK(error.place.index == index);
    CHECK(error.place.other == other);
  };
  using Kind = Place::Kind;
  is({}, ErrorCode::too_few_vertices, Kind::nowhere, 0, 0);
  is({{0, 0}, {1, 0}}, ErrorCode::too_few_vertices, Kind::nowhere, 0, 0);
  is({{0, 0}, {1, 0}, {std::nan(""), 1}}, ErrorCode::bad_coordinate, Kind::vertex, 2, 2);
  is({{0, 0}, {1, -infinity}, {0, 1}}, ErrorCode::bad_coordinate, Kind::vertex, 1, 1);
  is({{std::nextafter(1e9, 2e9), 0}, {1, 0}, {0, 1}}, ErrorCode::bad_coordinate, Kind::vertex, 0,
     0);
  is({{0, 0}, {1, 0}, {0, 1}, {1, 0}}, ErrorCode::repeated_vertex, Kind::vertex, 1, 3);
  is({{0, 0}, {-0.0, 0.0}, {0, 1}}, ErrorCode::repeated_vertex, Kind::vertex, 0, 1);
  is({{0, 0}, {1, 1}, {3, 3}, {2, 2}}, ErrorCode::no_area, Kind::nowhere, 0, 0);
  is({{0, 0}, {1, 1}, {1, 0}, {0, 1}}, ErrorCode::edges_cross, Kind::edge, 0, 2);
  // A vertex on an edge, and an edge along its neighbour.
  const InputError touch = refusal(document({{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}}));
  CHECK(touch.code == ErrorCode::edges_cross);
  CHECK(touch.place.index == 0);
  CHECK((touch.place.other == 2 || touch.place.other == 3));
  is({{0, 0}, {4, 0}, {2, 0}, {2, 4}}, ErrorCode::edges_cross, Kind::edge, 0, 1);
  // The bounds themselves are valid.
  CHECK(place(document({{-1e9, -1e9}, {1e9, -1e9}, {1e9, 1e9}, {-1e9, 1e9}})).ok());
}

TEST_CASE("a centre of mass that is not inside the convex hull is refused",
          "[placement][refusal]") {
  const auto code = [](const Vec2& centre) {
    const InputError error = refusal(document(square, centre));
    CHECK(error.place.kind == Place::Kind::centre_of_mass);
    return error.code;
  };
  CHECK(code({0, 1}) == ErrorCode::centre_outside_hull);
  CHECK(code({2, 2}) == ErrorCode::centre_outside_hull);
  CHECK(code({3, 1}) == ErrorCode::centre_outside_hull);
  CHECK(code({std::nextafter(2.0, 3.0), 1}) == ErrorCode::centre_outside_hull);
  CHECK(code({std::nan(""), 1}) == ErrorCode::bad_coordinate);
  CHECK(code({1, 1.1e9}) == ErrorCode::bad_coordinate);
  CHECK(place(document(square, Vec2(std::nextafter(2.0, 0.0), 1))).ok());
  CHECK(place(document(square, Vec2(1e-100, 1))).ok());
}

TEST_CASE("a triangle thinner than products of doubles can tell is still no line", "[placement]") {
  const auto code = [](double y) {
    const auto placement = place(document({{0, 0}, {1e9, 1e9}, {5e8, y}}));
    return placement.ok() ? std::optional<ErrorCode>() : placement.error().code;
  };
  CHECK(code(5e8) == ErrorCode::no_area);
  CHECK(code(std::nextafter(5e8, 0)) != ErrorCode::no_area);
  CHECK(code(std::nextafter(5e8, 1e9)) != ErrorCode::no_area);
}
