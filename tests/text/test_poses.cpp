// Tables, JSON and ROS 2 messages, which tests/consumers/check_poses.py reads with third-party
// readers.
#include "evenlift/output/poses.h"

#include <cmath>
#include <string>

#include "evenlift/angles.h"
#include "evenlift/placed_robots.h"
#include "kit/catch.h"
#include "kit/corpus.h"
#include "kit/json.h"
#include "kit/placed.h"
#include "kit/polygons.h"
#include "kit/solid.h"

using namespace evenlift;
using evenlift::testing::Json;
using evenlift::testing::placed;

namespace {

const std::string heading =
    "robot,team,x,y,heading_deg,load,unit,weight_unit,at_x,at_y,contact_x,contact_y,name\n";

// At this point of a square of side 4 with C at (2, 2).
Placement one_robot(const Vec2& at, std::uint32_t edge) {
  Placement placement(solid(testing::polygon({{0, 0}, {4, 0}, {4, 4}, {0, 4}})));
  placement.centre_of_mass = {2, 2};
  placement.teams = {Team{{Robot{{at, edge}, 1, 12.5}}, 1}};
  placement.loads = summarize_loads(placement.teams);
  return placement;
}

Shown in_units(LengthUnit length, WeightUnit weight) {
  Shown shown;
  shown.units = {length, weight};
  return shown;
}

// By name, of the message's only pose: its "position" or its "orientation".
Json numbers_of_pose(const std::string& yaml, const std::string& part) {
  std::string text = yaml.substr(yaml.find(part + ": {"));
  text = text.substr(text.find('{'), text.find('}') - text.find('{') + 1);
  for (const char* name : {"x", "y", "z", "w"}) {
    const std::size_t at = text.find(std::string(name) + ": ");
    if (at != std::string::npos) text.replace(at, 1, "\"" + std::string(name) + "\"");
  }
  return Json::parse(text);
}

}  // namespace

TEST_CASE("the ending of a file's name says the format of poses", "[poses]") {
  CHECK(pose_format_of_file("robots.csv") == PoseFormat::csv);
  CHECK(pose_format_of_file("a/b.c.json") == PoseFormat::json);
  CHECK(pose_format_of_file(".yaml") == PoseFormat::yaml);
  for (const char* other : {"", "csv", "robots", "robots.yml", "robots.CSV", "robots.csv "})
    CHECK_FALSE(pose_format_of_file(other));
}

TEST_CASE("a frame is a name that ROS 2 takes", "[poses]") {
  for (const std::string& good :
       {std::string("object"), std::string("map/table-1.a_B"), std::string(255, 'x')})
    CHECK(is_frame_name(good));
  for (const std::string& bad :
       {std::string(), std::string("/map"), std::string("a b"), std::string("a\"b"),
        std::string("a\nb"), std::string("\u00E4"), std::string(256, 'x')})
    CHECK_FALSE(is_frame_name(bad));
}

TEST_CASE("a table has a row for each robot, with its units", "[poses]") {
  CHECK(poses_text(one_robot({1, 0}, 0), PoseFormat::csv) ==
        heading + "1,1,1,0,90,12.5,,kg,1,0,1,0,\n");
  CHECK(poses_text({one_robot({1, 0}, 0), in_units(LengthUnit::mm, WeightUnit::lb)},
                   PoseFormat::csv, {PoseOrigin::com, "object"}) ==
        heading + "1,1,-1,-2,90,12.5,mm,lb,-1,-2,-1,-2,\n");
}

TEST_CASE("poses in JSON name their frame, origin and units", "[poses]") {
  const Json poses = Json::parse(poses_text(one_robot({1, 0}, 0), PoseFormat::json));
  CHECK(poses["frame"] == "object");
  CHECK(poses["origin"] == "file");
  CHECK(poses["unit"].is_null());
  CHECK(poses["weight_unit"] == "kg");
  REQUIRE(poses["robots"].size() == 1);
  const Json& robot = poses["robots"][0];
  CHECK(robot == Json::parse(R"({"robot": 1, "team": 1, "x": 1, "y": 0, "heading_deg": 90,
                                 "direction": [0, 1], "load": 12.5, "at": [1, 0],
                                 "contact": [1, 0]})"));
}

TEST_CASE("a message of ROS 2 is in metres", "[poses]") {
  const auto x = [](LengthUnit unit) {
    const std::string yaml =
        poses_text({one_robot({3, 0}, 0), in_units(unit, WeightUnit::kg)}, PoseFormat::yaml);
    CHECK((yaml.find("has no unit") != std::string::npos) == (unit == LengthUnit::none));
    return numbers_of_pose(yaml, "position")["x"].number();
  };
  CHECK(x(LengthUnit::none) == 3);
  CHECK(x(LengthUnit::m) == 3);
  CHECK(x(LengthUnit::cm) == 0.03);
  CHECK(x(LengthUnit::mm) == 0.003);
  CHECK(x(LengthUnit::in) == Approx(0.0762).epsilon(1e-15));
}

TEST_CASE("a heading is above -180 degrees, however little its direction is", "[poses]") {
  Placement placement(solid(testing::polygon({{-2, 0}, {0, 0}, {-1e-20, 1}, {-2, 1}})));
  placement.centre_of_mass = {-1, 0.5};
  placement.teams = {Team{{Robot{{{0, 0.5}, 1}, 1, 12.5}}, 1}};
  const PlacedRobot robot = placed_robots(placement).at(0);
  CHECK(robot.direction.y < 0);
  CHECK(robot.heading_deg == 180);
}

TEST_CASE("a pose's rotation turns x into the heading, wherever the robot stands", "[poses]") {
  // On the edges, and at vertices along the bisector of the normals.
  const struct {
    Vec2 at;
    std::uint32_t edge;
    double heading_deg;
  } robots[] = {{{1, 0}, 0, 90}, {{4, 1}, 1, 180}, {{1, 4}, 2, -90},  {{0, 1}, 3, 0},
                {{0, 0}, 0, 45}, {{4, 0}, 1, 135}, {{4, 4}, 2, -135}, {{0, 4}, 3, -45}};
  for (const auto& [at, edge, heading_deg] : robots) {
    INFO(heading_deg);
    const Json turn =
        numbers_of_pose(poses_text(one_robot(at, edge), PoseFormat::yaml), "orientation");
    const double z = turn["z"].number(), w = turn["w"].number();
    CHECK(turn["x"] == 0);
    CHECK(turn["y"] == 0);
    CHECK(w >= 0);
    CHECK(z * z + w * w == Approx(1).epsilon(1e-15));
    CHECK(w * w - z * z == Approx(cosine(heading_deg * pi / 180)).margin(1e-15));
    CHECK(2 * w * z == Approx(sine(heading_deg * pi / 180)).margin(1e-15));
  }
}

TEST_CASE("the rotations of all samples' robots are their headings", "[poses]") {
  for (const std::string& name : corpus::polygon_names()) {
    Document document = corpus::polygon(name);
    document.settings.method = Method::distributed;
    document.settings.teams = 5;
    const Placement placement = placed(document);
    INFO(name);
    for (const PlacedRobot& robot : placed_robots(placement)) {
      const double angle = robot.heading_deg * pi / 180;
      CHECK(robot.direction.x == Approx(cosine(angle)).margin(1e-14));
      CHECK(robot.direction.y == Approx(sine(angle)).margin(1e-14));
      CHECK(length(robot.direction) == Approx(1).epsilon(1e-15));
    }
  }
}

TEST_CASE("a placement without robots has no poses", "[poses]") {
  Placement placement(solid(testing::polygon(testing::square)));
  CHECK(poses_text(placement, PoseFormat::csv) == heading);
  CHECK(Json::parse(poses_text(placement, PoseFormat::json))["robots"].empty());
  CHECK(poses_text(placement, PoseFormat::yaml).ends_with("poses: []\n"));
}
