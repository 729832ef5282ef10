#include <string>

#include "evenlift/import.h"
#include "evenlift/output/json.h"
#include "evenlift/output/svg.h"
#include "evenlift/output/words.h"
#include "evenlift/placement.h"
#include "kit/catch.h"
#include "kit/corpus.h"
#include "kit/json.h"
#include "kit/texts.h"

using namespace evenlift;
using evenlift::testing::Json;
using evenlift::testing::occurrences;

namespace {

Placement piano(const RobotSize& robot, std::vector<EdgePart> no_go) {
  Document document = corpus::polygon("grand-piano");
  document.settings.robot = robot;
  document.settings.no_go = std::move(no_go);
  return *place(document);
}

}  // namespace

TEST_CASE("a picture has every body, hand and marked edge", "[svg][stands]") {
  const std::string svg = placement_svg(piano({30, 20, 40, 60, 10}, {{37, 0, 1}}));
  CHECK(occurrences(svg, "class=\"body\"") == 6);
  CHECK(occurrences(svg, "class=\"hand\"") == 6);
  CHECK(occurrences(svg, "class=\"arm\"") == 6);
  CHECK(occurrences(svg, "class=\"no-go\"") == 1);
  CHECK(occurrences(svg, "class=\"unusable\"") > 0);
  const std::string points = placement_svg(piano({}, {}));
  for (const char* name : {"body", "hand", "arm", "no-go", "unusable"})
    CHECK(occurrences(points, "class=\"" + std::string(name) + '"') == 0);
}

TEST_CASE("JSON says where robots stand and what they cannot use", "[json][stands]") {
  const auto json = Json::parse(placement_json(piano({30, 20, 40, 60, 10}, {{37, 0, 1}}), true));
  CHECK(json["robot"] ==
        Json::parse(R"({"radius": 30, "reach": 20, "depth": 40, "width": 60, "gap": 10})"));
  CHECK(json["no_go"] == "38");
  bool marked = false;
  for (const auto& part : json["unusable"]) {
    CHECK(part[1].number() < part[2].number());
    CHECK(part[2].number() <= 1 + 1e-12);
    marked = marked || (part[0] == 38 && part[3] == "no_go");
  }
  CHECK(marked);
  REQUIRE(json["robots"].size() == 6);
  for (const auto& robot : json["robots"]) {
    const auto point = [&](const char* name) {
      return Vec2(robot[name][0].number(), robot[name][1].number());
    };
    const Vec2 at = point("at"), contact = point("contact"), stand = point("stand");
    CHECK(length(at - contact) == Approx(40));
    CHECK(length(stand - contact) == Approx(50));
    CHECK(length(stand - at) == Approx(90));
  }
  CHECK_FALSE(Json::parse(placement_json(piano({}, {}), true)).contains("unusable"));
  const Placement placement = piano({30, 0, 40, 60.5, 0}, {{37, 0, 1}, {1, 0.25, 0.5}});
  const auto read = read_shapes(placement_json(placement, false));
  REQUIRE(read.ok());
  CHECK(read->shapes.at(0).document.settings.robot == placement.settings.robot);
  CHECK(read->shapes.at(0).document.settings.no_go == placement.settings.no_go);
}

TEST_CASE("fewer teams than were asked for come with the reason", "[stands]") {
  const Placement placement = piano({500, 0, 0, 0, 0}, {});
  CHECK(placement.teams.size() < placement.requested_teams);
  CHECK(shortage_in_words(placement).find("would be too close to each other") != std::string::npos);
  for (std::size_t why = 0; why < why_unusable_count; ++why)
    CHECK_FALSE(unusable_in_words(static_cast<WhyUnusable>(why), {1, 2, 3, 4, 5}, {}).empty());
}
