#include <algorithm>
#include <cmath>

#include "evenlift/output/label_places.h"
#include "evenlift/output/picture.h"
#include "evenlift/output/svg.h"
#include "evenlift/placement.h"
#include "kit/catch.h"
#include "kit/corpus.h"
#include "kit/placed.h"
#include "kit/texts.h"

using namespace evenlift;
using evenlift::testing::occurrences;
using evenlift::testing::placed;

namespace {

// Some attributes of each element of a class.
std::vector<std::vector<double>> numbers_of(const std::string& svg, const std::string& of_class,
                                            const std::vector<std::string>& names) {
  std::vector<std::vector<double>> all;
  const std::string begin = "class=\"" + of_class + "\"";
  for (std::size_t at = svg.find(begin); at != std::string::npos; at = svg.find(begin, at + 1)) {
    const std::size_t start = svg.rfind('<', at);
    const std::string tag = svg.substr(start, svg.find('>', at) - start);
    all.emplace_back();
    for (const std::string& name : names)
      all.back().push_back(std::stod(tag.substr(tag.find(" " + name + "=\"") + name.size() + 3)));
  }
  return all;
}

// Tags are closed in order, attributes are quoted, and every character is in a valid place.
bool well_formed(const std::string& xml) {
  std::vector<std::string> open;
  for (std::size_t i = 0; i < xml.size(); ++i) {
    if (xml[i] == '>' || xml[i] == '"') return false;
    if (xml[i] != '<') continue;
    const std::size_t end = xml.find('>', i);
    if (end == std::string::npos) return false;
    const std::string tag = xml.substr(i + 1, end - i - 1);
    if (tag.find('<') != std::string::npos || std::count(tag.begin(), tag.end(), '"') % 2 != 0)
      return false;
    const std::string name = tag.substr(0, tag.find(' '));
    if (tag[0] == '/') {
      if (open.empty() || open.back() != tag.substr(1)) return false;
      open.pop_back();
    } else if (tag.back() != '/') {
      open.push_back(name);
    }
    i = end;
  }
  return open.empty();
}

void check_picture(const std::string& svg) {
  CHECK(svg.rfind("<svg xmlns=\"http://www.w3.org/2000/svg\"", 0) == 0);
  CHECK(well_formed(svg));
  CHECK(svg.find("nan") == std::string::npos);
  CHECK(svg.find("inf") == std::string::npos);
  CHECK(svg.find("e+") == std::string::npos);
  CHECK(occurrences(svg, "<title") == 1);
  CHECK(occurrences(svg, "<desc") == 1);
  CHECK(occurrences(svg, "class=\"centre-of-mass\"") == 2);  // the mark, and in the key
}

bool overlap(const labels::Box& a, const labels::Box& b) {
  return a.low.x < b.high.x && a.low.y < b.high.y && b.low.x < a.high.x && b.low.y < a.high.y;
}

}  // namespace

TEST_CASE("a picture of every sample is sound", "[svg][slow]") {
  for (const std::string& name : corpus::polygon_names()) {
    CAPTURE(name);
    for (const std::uint32_t teams : {1u, 3u, 50u}) {
      const Placement placement = placed(corpus::polygon(name), Method::area, teams);
      const std::string svg = placement_svg(placement);
      check_picture(svg);
      CHECK(occurrences(svg, "class=\"chord\"") == placement.teams.size());
      CHECK(occurrences(svg, "class=\"robot\"") >=
            std::min<std::size_t>(2, 2 * placement.teams.size()));
    }
  }
}

TEST_CASE("with three teams each robot of every sample has its load beside it", "[svg][slow]") {
  for (const std::string& name : corpus::polygon_names())
    for (const Method method : {Method::area, Method::distributed, Method::random}) {
      CAPTURE(name, evenlift::name(method));
      const std::string svg = placement_svg(placed(corpus::polygon(name), method, 3));
      CHECK(occurrences(svg, "class=\"load\"") == occurrences(svg, "class=\"robot\""));
    }
}

TEST_CASE("robots are numbered from 1 by every method, and partners share a tally", "[svg]") {
  const Document piano = corpus::polygon("grand-piano");
  for (const Method method : {Method::area, Method::circle, Method::balanced}) {
    CAPTURE(name(method));
    const Placement placement = placed(piano, method, 3);
    const std::string svg = placement_svg(placement);
    for (int robot = 1; robot <= 6; ++robot)
      CHECK(occurrences(svg, ">" + std::to_string(robot) + "</text>") == 1);
    CHECK(occurrences(svg, ">7</text>") == 0);
    CHECK(occurrences(svg, "class=\"small-body\"") == 6);
    // One stroke at the first team's robots, two at the second's, three at the third's.
    CHECK(occurrences(svg, "class=\"tally\"") == (is_one_team(method) ? 0 : 12));
  }
}

TEST_CASE("a tally counts a team in fives and ones, side by side and away from C", "[svg]") {
  const auto strokes = tally(12, {100, 50}, {3, 4}, 10);
  REQUIRE(strokes.size() == 4);
  CHECK((strokes[0].five && strokes[1].five && !strokes[2].five && !strokes[3].five));
  const Vec2 out(0.6, 0.8);
  for (const auto& [line, five] : strokes) {
    CHECK(dot(line.from - Vec2(100, 50), out) == Approx(10));
    CHECK(dot(line.to - line.from, out) == Approx(length(line.to - line.from)));
  }
  CHECK(tally(0, {0, 0}, {1, 0}, 10).empty());
  CHECK(tally(1, {0, 0}, {0, 0}, 10).size() == 1);
}

TEST_CASE("a sketch has all the robots and loads, and neither caption nor link", "[svg][slow]") {
  for (const std::string& name : corpus::polygon_names()) {
    CAPTURE(name);
    const Placement placement = placed(corpus::polygon(name), Method::area, 2);
    const std::string picture = placement_svg(placement, "#AbC"),
                      sketch = placement_sketch(placement);
    CHECK(well_formed(sketch));
    CHECK(occurrences(sketch, "class=\"robot\"") == occurrences(picture, "class=\"robot\""));
    CHECK(occurrences(sketch, "class=\"load\"") == occurrences(sketch, "class=\"robot\""));
    CHECK(occurrences(sketch, "class=\"centre-of-mass\"") == 1);  // the mark; there is no key
    CHECK(occurrences(sketch, "<metadata>") == 0);
  }
}

TEST_CASE("pictures of extreme shapes are sound", "[svg]") {
  const std::vector<Points> shapes = {
      {{0, 0}, {1e9, 0}, {1e9, 1}, {0, 1}},
      {{0, 0}, {1e-6, 0}, {0, 1e-6}},
      {{-1e9, -1e9}, {1e9, -1e9}, {1e9, 1e9}, {-1e9, 1e9}},
      {{0, 0}, {1, 0}, {1, 1e5}, {0, 1e5}},
  };
  for (const Points& vertices : shapes) {
    Document document;
    document.vertices = vertices;
    check_picture(placement_svg(placed(document, Method::area, 3)));
    check_picture(placement_svg(placed(document, Method::distributed, 200)));
  }
}

TEST_CASE("labels cover neither each other nor what they name", "[svg][slow]") {
  std::size_t asked = 0, found = 0;
  for (const std::string& name : corpus::polygon_names()) {
    CAPTURE(name);
    const Placement placement = placed(corpus::polygon(name), Method::area, 12);
    labels::Surroundings around{{Vec2(-200, -200), Vec2(1300, 1400)}, placement.vertices(), {}, {}};
    std::vector<labels::Request> requests;
    for (const Team& team : placement.teams)
      for (const Vec2& at : {team.robots[0].point.position, team.robots[1].point.position})
        requests.push_back(
            {{at - Vec2(12, 12), at + Vec2(12, 12)}, at - placement.centre_of_mass, {40, 14}});
    const std::vector<std::optional<labels::Box>> places = labels::place(requests, around);
    REQUIRE(places.size() == requests.size());
    asked += requests.size();
    for (std::size_t i = 0; i < places.size(); ++i) {
      if (!places[i]) continue;
      ++found;
      for (std::size_t j = 0; j < places.size(); ++j) {
        CHECK_FALSE(overlap(*places[i], requests[j].owner));
        if (j != i && places[j]) CHECK_FALSE(overlap(*places[i], *places[j]));
      }
    }
  }
  CHECK(found > asked * 3 / 4);
}

TEST_CASE("a picture shows in which direction nothing stops the object", "[svg]") {
  const std::string slides =
      placement_svg(placed(corpus::polygon("u-channel"), Method::distributed, 4));
  check_picture(slides);
  CHECK(occurrences(slides, "class=\"slide\"") == 1);
  CHECK(occurrences(slides, ">can slide this way<") == 1);
  const std::string held = placement_svg(placed(corpus::polygon("grand-piano"), Method::area));
  CHECK(occurrences(held, "slide") == 0);
}

TEST_CASE("loads keep clear of robots' bodies, and the key explains what is seen",
          "[svg][stands]") {
  Document document = corpus::polygon("worktop");
  document.settings.teams = 3;
  document.settings.robot = {40, 25, 10, 20, 10};
  document.settings.no_go = {{0, 0, 1}, {1, 0.1, 0.5}};
  document.shown.capacity = 17;
  const std::string svg = placement_svg({*place(document), document.shown});
  check_picture(svg);
  CHECK(svg.find(">robot's body<") != std::string::npos);
  CHECK(svg.find(">no-go edge<") != std::string::npos);
  CHECK(svg.find(">no robot fits here<") != std::string::npos);
  CHECK(svg.find(">more than a robot can carry<") != std::string::npos);
  CHECK(occurrences(svg, "class=\"load overload\"") >= 1);
  CHECK(occurrences(svg, "class=\"load\"") >= 1);
  CHECK(occurrences(svg, "\u00A0kg</text>") == 6);

  const auto bodies = numbers_of(svg, "body", {"cx", "cy", "r"});
  REQUIRE(bodies.size() == 6);
  auto loads = numbers_of(svg, "load", {"x", "y"});
  for (auto& over : numbers_of(svg, "load overload", {"x", "y"})) loads.push_back(over);
  REQUIRE(loads.size() == 6);
  for (const auto& load : loads)
    for (const auto& body : bodies) {
      const double dx = load[0] - body[0],
                   dy = load[1] - 5 - body[1];  // from the baseline to the middle
      CHECK(std::sqrt(dx * dx + dy * dy) > body[2]);
    }
}

namespace {

Document plate_with_cargo() {
  Document document;
  document.vertices = {{0, 0}, {10, 0}, {10, 10}, {0, 10}};
  document.holes = {{{2, 2}, {4, 2}, {4, 4}, {2, 4}}, {{6, 2}, {6, 4}, {7, 4}}};
  document.settings.weight = 96;
  document.settings.min_ratio = 0.5;
  document.settings.cargo = {{{8, 8}, 24, "motor & fan"}, {{12, 3}, 6, ""}};
  return document;
}

}  // namespace

TEST_CASE("holes are empty in a picture: one path with the even-odd rule", "[svg][holes]") {
  Document document = plate_with_cargo();
  document.settings.cargo.clear();
  const std::string svg = placement_svg(placed(document));
  check_picture(svg);
  const std::size_t at = svg.find("class=\"object\"");
  REQUIRE(at != std::string::npos);
  const std::string tag = svg.substr(at, svg.find('>', at) - at);
  CHECK(occurrences(tag, "M") == 3);
  CHECK(occurrences(tag, "Z") == 3);
  CHECK(occurrences(tag, "fill-rule=\"evenodd\"") == 1);
  CHECK(occurrences(svg, "class=\"object\"") == 1);
  CHECK(occurrences(svg, " lifting a polygonal object with 2 holes</title>") == 1);
  CHECK(svg.find("2\u00A0holes") != std::string::npos);
  // The lifting base does not cover them.
  const std::size_t base = svg.find("class=\"hull\""), holes = svg.find("class=\"holes\"");
  REQUIRE(base != std::string::npos);
  REQUIRE(holes != std::string::npos);
  CHECK(base < holes);
  CHECK(occurrences(svg, "cargo") == 0);
  document.holes.clear();
  CHECK(occurrences(placement_svg(placed(document)), "evenodd") == 0);
}

TEST_CASE("a lifting base of three corners is filled, one of two is a broad line", "[svg]") {
  const auto base = [](const Points& supports) {
    Document document = plate_with_cargo();
    document.settings.method = Method::given;
    document.settings.supports = supports;
    const std::string svg = placement_svg(placed(document));
    check_picture(svg);
    const std::size_t at = svg.find("class=\"hull\"");
    REQUIRE(at != std::string::npos);
    return svg.substr(at, svg.find('>', at) - at);
  };
  CHECK(occurrences(base({{0, 0}, {10, 0}, {9, 10}}), "fill-opacity") == 1);
  CHECK(occurrences(base({{0, 0}, {10, 10}}), "fill-opacity") == 0);
}

TEST_CASE("a picture shows cargo as discs whose area tells its weight", "[svg][cargo]") {
  const Placement placement = placed(plate_with_cargo());
  const std::string svg = placement_svg(placement);
  check_picture(svg);
  auto discs = numbers_of(svg, "cargo", {"cx", "cy", "r"});
  REQUIRE(discs.size() == 3);  // and one in the key
  CHECK(std::pow(discs[0][2] / discs[1][2], 2) == Approx(4).epsilon(1e-3));
  CHECK(discs[1][0] > discs[0][0]);
  const auto marks = numbers_of(svg, "own-centre", {"cx", "cy"});
  REQUIRE(marks.size() == 2);  // and one in the key
  CHECK(occurrences(svg, "class=\"cargo-lever\"") == 1);
  CHECK(occurrences(svg, ">motor &amp; fan</text>") == 1);
  CHECK(occurrences(svg, ">6\u00A0kg</text>") == 1);
  CHECK(occurrences(svg, ">centre of mass without cargo</text>") == 1);
  CHECK(occurrences(svg, ">cargo, by weight</text>") == 1);
  CHECK(svg.find("2\u00A0items") != std::string::npos);
  CHECK(occurrences(svg, " lifting a polygonal object with 2 holes and cargo</title>") == 1);
  // No name covers a disc.
  discs.pop_back();
  for (const auto& name : numbers_of(svg, "cargo-name", {"x", "y"}))
    for (const auto& disc : discs)
      CHECK(std::hypot(name[0] - disc[0], name[1] - 5 - disc[1]) > disc[2]);
  CHECK(well_formed(placement_sketch(placement)));
}

TEST_CASE("cargo far away leaves the object large, and long names are cut", "[svg][cargo]") {
  Document document = plate_with_cargo();
  const auto width_of = [](const std::string& svg) {
    return std::stod(svg.substr(svg.find(" width=\"") + 8));
  };
  document.settings.cargo = {{{5, 5}, 2, "änderungswürdiges Gerät mit Pumpe"}};
  const double alone = width_of(placement_svg(placed(document)));
  document.settings.cargo.push_back({{1e9, 5}, 1e-9, "far"});
  const std::string svg = placement_svg(placed(document));
  check_picture(svg);
  CHECK(width_of(svg) == alone);
  CHECK(occurrences(svg, ">far</text>") == 0);
  CHECK(occurrences(svg, ">änderungswürdiges Gerät…</text>") == 1);
}
