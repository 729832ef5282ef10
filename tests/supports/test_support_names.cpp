// Names of robots, and tables of supports with names, units and the lifting points of bodies.
#include <string>
#include <vector>

#include "evenlift/import.h"
#include "evenlift/link.h"
#include "evenlift/output/json.h"
#include "evenlift/output/poses.h"
#include "evenlift/output/robustness_words.h"
#include "evenlift/output/svg.h"
#include "evenlift/settings.h"
#include "kit/catch.h"
#include "kit/corpus.h"
#include "kit/json.h"
#include "kit/placed.h"

using namespace evenlift;
using evenlift::testing::Json;
using evenlift::testing::placed;

namespace {

using Names = std::vector<std::string>;

Document square_on(const std::string& supports) {
  Document document = corpus::polygon("square");
  REQUIRE_FALSE(read_setting(Setting::supports, supports, document));
  return document;
}

SupportFile table(const std::string& text) {
  const Result<SupportFile> read = read_support_file(text);
  INFO(text);
  REQUIRE(read.ok());
  return *read;
}

}  // namespace

TEST_CASE("supports have names in text, links and JSON", "[supports][settings]") {
  const Document document =
      square_on("200,0:north 1000,200@30:\"south \"\"west\"\"\" 800,1000@20:a\\b 0,800");
  const Names names = {"north", "south \"west\"", "a\\b", ""};
  CHECK(document.settings.support_names == names);
  CHECK(document.shown.support_capacities ==
        std::vector<std::optional<double>>{std::nullopt, 30, 20, std::nullopt});
  CHECK(text_of(Setting::support_names, document) == "north \"south \"\"west\"\"\" a\\b \"\"");
  CHECK(decode_link(*encode_link(document))->settings.support_names == names);
  const Placement placement = placed(document);
  const Json json = Json::parse(placement_json({placement, document.shown}, false));
  CHECK(json["support_names"] == Json::parse(R"(["north", "south \"west\"", "a\\b", null])"));
  CHECK(json["robots"][1]["name"] == "south \"west\"");
  CHECK_FALSE(json["robots"][3].contains("name"));
  CHECK(table(placement_json({placement, document.shown}, false)).names == names);
  // Without a name there is no list, and other supports have none of the names.
  CHECK(square_on("0,0:\"\" 1000,0 500,900").settings.support_names.empty());
  Document other = document;
  REQUIRE_FALSE(read_setting(Setting::supports, "0,0 1000,0 500,900", other));
  CHECK(other.settings.support_names.empty());
}

TEST_CASE("a wrong name of a support is refused", "[supports][settings]") {
  Document document = corpus::polygon("square");
  const std::string long_name(61, 'a');
  for (const std::string& bad : std::initializer_list<std::string>{
           std::string("0,0:"), "0,0:a\"b", "0,0:" + long_name, std::string("0,0:a\x01"),
           std::string("0,0:\xff"), std::string("0,0@:a"), std::string(":a"),
           std::string("0,0:\"a\u2028b\""), std::string("0,0:a\u202eb")}) {
    INFO(bad);
    CHECK(read_setting(Setting::supports, bad, document));
  }
  Document few = square_on("0,0 1000,0 500,900");
  few.settings.support_names = {"a", "b"};
  const Result<Placement> placement = place(few);
  REQUIRE_FALSE(placement.ok());
  CHECK(placement.error().message == "2 names are given for 3 supports");
}

TEST_CASE("words and pictures call a robot by its name, too", "[supports][words]") {
  Document document = square_on("200,0:north 1000,200@10:south 800,1000 0,800:east");
  document.settings.weight = 64;
  const Placement placement = placed(document);
  const Reported of(ShownPlacement(placement, document.shown), Asked{.failures = true});
  CHECK(failures_in_words(of).find("robots 1 (north), 2 (south), 3 and 4 (east)") !=
        std::string::npos);
  const std::string picture = placement_svg(of);
  CHECK(picture.find("north 16.0") != std::string::npos);
  // One that falls carries nothing, but its robots still have names.
  const Document falls = square_on("0,0:a 300,0:b 0,300:c");
  const Placement fallen = placed(falls);
  CHECK(placement_svg(Reported(fallen, falls.shown)).find(">b</text>") != std::string::npos);
}

TEST_CASE("a table of supports has names, capacities and readings in the usual languages",
          "[supports][import]") {
  for (const std::string& heading :
       {std::string("jack,x,y,SWL (kg)"), std::string("Name,x,y,max. load kg"),
        std::string("St\u00fctze,x,y,Tragf\u00e4higkeit [kg]"),
        std::string("v\u00e9rin,x,y,capacit\u00e9 (kg)"),
        std::string("apoyo,x,y,Capacidad (kg)")}) {
    const SupportFile read = table(heading + "\nleft,0,0,30\nright,160,0,40\n");
    INFO(heading);
    CHECK(read.names == Names{"left", "right"});
    CHECK(read.capacities == std::vector<std::optional<double>>{30, 40});
    CHECK(read.capacity_unit == 1.0);
    CHECK(read.notes.empty());
  }
  // A number of the row is no name.
  CHECK(table("robot,x,y\n1,0,0\n2,9,0\n").names.empty());
  CHECK(table("robot,x,y\n7,0,0\n9,9,0\n").names == Names{"7", "9"});
  CHECK(table("x,y,Anzeige (kN)\n0,0,1\n").reading_unit.value() == Approx(101.97).epsilon(1e-4));
}

TEST_CASE("columns of a table of supports that are not used are named", "[supports][import]") {
  const SupportFile read = table("jack,x,y,z,Type,capacity (lb)\nA,0,0,5,hydraulic,40\n");
  CHECK(read.notes == Names{"the column \"z\" was left out", "the column \"Type\" was left out"});
  CHECK(read.capacity_unit.value() == Approx(0.45359237));
}

TEST_CASE("supports in feet are in inches, and an unknown unit is refused", "[supports][import]") {
  const SupportFile read = table("x (ft),y (ft)\n7,0\n0,2.5\n");
  CHECK(read.places == Points{{84, 0}, {0, 30}});
  CHECK(read.unit == LengthUnit::in);
  CHECK(read_support_file("x (furlong),y (furlong)\n1,2\n").error().message ==
        "the unit of x and y is not known; it may be mm, cm, m, in or ft");
  CHECK(read_support_file("x,y,capacity (stone)\n1,2,3\n").error().message ==
        "the unit of the capacities is not known; it may be kg, t, N, kN or lb");
  CHECK(table("x (from the left),y (up)\n1,2\n").places == Points{{1, 2}});
}

TEST_CASE("names come back from each format of poses, whatever they are", "[supports][poses]") {
  Document document = square_on("200,0 1000,200 800,1000 0,800");
  document.shown.units.length = LengthUnit::mm;
  document.settings.support_names = {"say \"hi\", you", "=1+1", "position: {x: 50, y: 50}",
                                     "lifts at {x: 1, y: 2} \u00e4"};
  const Placement placement = placed(document);
  for (const PoseFormat format : {PoseFormat::csv, PoseFormat::json, PoseFormat::yaml}) {
    const std::string text = poses_text({placement, document.shown}, format);
    INFO(text);
    const SupportFile read = table(text);
    CHECK(read.names == document.settings.support_names);
    CHECK(read.places.size() == 4);
    CHECK(read.is_own);
  }
}

TEST_CASE("labels of a table are made names, and what is no load does not count",
          "[supports][import]") {
  CHECK(table("Name;x;y\nS\xfc"
              "d;0;0\n" +
              std::string(70, 'a') + ";9;0\n")
            .names.at(1) == std::string(60, 'a'));
  CHECK(table("ID,x,y\nJ1,0,0\nJ2,9,0\n").names == Names{"J1", "J2"});
  CHECK(table("No,x,y\n1,0,0\n2,9,0\n").names.empty());
  CHECK(table("n,x,y,load\n1,0,0,50\n2,9,0,60\n").readings == std::vector<double>{50, 60});
  CHECK(table("x,y,Scale,reading\n0,0,S1,50\n").readings == std::vector<double>{50});
  CHECK(table("x,y,capacity (max)\n0,0,50\n").capacities.at(0) == 50.0);
  CHECK(table("x,y,remark\n0,0,position: north\n").places == Points{{0, 0}});
  CHECK(read_support_file("x (ft),y\n0,0\n").error().message == "x and y are in different units");
}

TEST_CASE("poses of robots with bodies come back as supports in each format", "[supports][poses]") {
  for (const char* size :
       {"r=30,reach=10,gap=5", "r=29.5,reach=8.85,depth=8.85,width=14.8,gap=8.85"}) {
    Document document = corpus::polygon("grand-piano");
    document.settings.method = Method::balanced;
    document.settings.robots = 5;
    document.shown.units.length = LengthUnit::mm;
    REQUIRE_FALSE(read_setting(Setting::robot, size, document));
    const Placement placement = placed(document);
    REQUIRE_FALSE(placement.teams.empty());
    const std::vector<PlacedRobot> robots = placed_robots(placement);
    for (const PoseFormat format : {PoseFormat::csv, PoseFormat::json, PoseFormat::yaml}) {
      const SupportFile read = table(poses_text({placement, document.shown}, format));
      REQUIRE(read.places.size() == robots.size());
      REQUIRE(read.contacts.size() == robots.size());
      const double unit = format == PoseFormat::yaml ? 1000 : 1;
      for (std::size_t i = 0; i < robots.size(); ++i) {
        CHECK(length(unit * read.places[i] - robots[i].at) < 1e-9);
        CHECK(length(unit * read.contacts[i] - robots[i].contact) < 1e-9);
      }
    }
  }
}
