// tests/consumers/check_c.py compares the answers with the program's output.
#include "evenlift/request.h"

#include <string>

#include "evenlift/experiment/outputs.h"
#include "evenlift/import.h"
#include "evenlift/link.h"
#include "evenlift/output/json.h"
#include "evenlift/output/json_text.h"
#include "evenlift/output/poses.h"
#include "evenlift/output/svg.h"
#include "evenlift/output/words.h"
#include "evenlift/settings.h"
#include "kit/catch.h"
#include "kit/corpus.h"
#include "kit/json.h"
#include "kit/placed.h"

using namespace evenlift;
using evenlift::testing::Json;
using evenlift::testing::placed;

namespace {

const char* const l_shape =
    R"("polygon": [[0, 0], [4, 0], [4, 1.5], [1.5, 1.5], [1.5, 3], [0, 3]])";

Document l_document() {
  Document document;
  document.vertices = {{0, 0}, {4, 0}, {4, 1.5}, {1.5, 1.5}, {1.5, 3}, {0, 3}};
  return document;
}

Json answer_json(const std::string& request) { return Json::parse(answer(request)); }

std::string with(const std::string& members) {
  return "{" + std::string(l_shape) + ", " + members + "}";
}

// The error in the answer.
Json refusal(const std::string& request) {
  const Json answered = answer_json(request);
  INFO(request);
  REQUIRE(answered.names() == std::vector<std::string>{"error"});
  return answered["error"];
}

}  // namespace

TEST_CASE("a request for a placement gets what the program prints", "[request]") {
  Document document = l_document();
  CHECK(answer(with(R"("settings": {})")) == placement_json(placed(document), false));
  document.settings.method = Method::circle;
  document.settings.teams = 2;
  document.settings.weight = 30;
  document.centre_of_mass = Vec2(1, 1);
  CHECK(answer(with(R"("command": "place", "candidates": true, "centre_of_mass": [1, 1],
                       "settings": {"metric": "circle", "teams": "2", "weight": 30})")) ==
        placement_json(placed(document), true));
}

TEST_CASE("settings are numbers or texts, and null is as usual", "[request]") {
  const std::string usual = answer(with(R"("settings": {})"));
  CHECK(answer(with(R"("settings": {"teams": 3, "min_ratio": "0.8", "capacity": null})")) == usual);
  CHECK(answer(with(R"("centre_of_mass": null)")) == usual);
  CHECK(answer("{" + std::string(l_shape) + "}") == usual);
  const Json seed =
      answer_json(with(R"("settings": {"metric": "random", "seed": 18446744073709551615})"));
  CHECK(seed["seed"].whole_number() == 18446744073709551615u);
}

TEST_CASE("a polygon may come as text or as a link, whose settings count", "[request]") {
  CHECK(answer(R"j({"text": "POLYGON ((0 0, 4 0, 4 1.5, 1.5 1.5, 1.5 3, 0 3, 0 0))"})j") ==
        answer("{" + std::string(l_shape) + "}"));
  Document document = l_document();
  document.settings.teams = 2;
  const std::string link = *encode_link(document);
  CHECK(answer("{\"text\": \"" + link + "\"}") == placement_json(placed(document), false));
  CHECK(answer_json("{\"command\": \"link\", \"text\": \"" + link + "\"}")["link"] == link);
  document.settings.teams = 1;
  CHECK(answer("{\"text\": \"" + link + "\", \"settings\": {\"teams\": 1}}") ==
        placement_json(placed(document), false));
}

TEST_CASE("cargo in the settings replaces that of the text", "[request]") {
  const Json answered = answer_json(
      R"j({"text": "(0,0)\n(4,0)\n(4,4)\n(0,4)\nCargo:(1,1) 5 motor\n",
           "settings": {"cargo": [{"at": [2, 2], "weight": 3}]}})j");
  REQUIRE(answered["cargo"].size() == 1);
  CHECK(answered["cargo"][0]["weight"] == 3);
}

TEST_CASE("robots that a link moved go back when the request says where C is", "[request]") {
  Document document;
  document.vertices = {{0, 0}, {4, 0}, {4, 4}, {0, 4}};
  document.settings.method = Method::balanced;
  document.settings.robots = 4;
  document.moved = *read_moved("1:0.5,2:0.5,3:0.5,4:0.5");
  const std::string text = "{\"text\": \"" + *encode_link(document) + "\"";
  CHECK(answer(text + "}") == placement_json(placed(document), false));
  document.moved = {};
  CHECK(answer(text + ", \"centre_of_mass\": null}") == placement_json(placed(document), false));
  document.centre_of_mass = Vec2(1, 2);
  CHECK(answer(text + ", \"centre_of_mass\": [1, 2]}") == placement_json(placed(document), false));
}

TEST_CASE("robots that a link moved to where they cannot stand are the fault of no setting",
          "[request][errors]") {
  Document document;
  document.vertices = {{0, 0}, {4, 0}, {4, 4}, {0, 4}};
  document.settings.method = Method::balanced;
  document.settings.robots = 4;
  document.moved = *read_moved("1:0.5,2:0.5,3:0.5,4:0.75");
  const Json error = refusal("{\"text\": \"" + *encode_link(document) + "\"}");
  CHECK(error["code"] == "bad_setting");
  CHECK(error["message"] ==
        "Robots moved by hand: the centroid of the robots is not the centre of mass");
  CHECK(error["place"].is_null());
}

TEST_CASE("candidates, pictures and poses are the core's own", "[request]") {
  const Document document = l_document();
  const Placement placement = placed(document);
  CHECK(answer(with(R"("command": "candidates")")) == candidates_json(placement.candidates));
  Document sized = document;
  sized.settings.positions = Positions::range;
  CHECK(placed(sized).candidates.size() > placement.candidates.size());
  CHECK(answer(with(R"("command": "candidates", "settings": {"positions": "range"})")) ==
        candidates_json(placed(sized).candidates));
  sized.settings.robot.radius = 0.1;
  CHECK(answer(with(
            R"("command": "candidates", "settings": {"positions": "range", "robot": "r=0.1"})")) ==
        candidates_json(placed(sized).candidates));
  sized.settings.no_go = {{0, 0, 0.25}};
  sized.settings.clear = 0.25;
  CHECK(answer(with(R"("command": "candidates", "settings": {"positions": "range", "robot": "r=0.1",
                       "no_go": "1:0-0.25", "clear": 0.25})")) ==
        candidates_json(placed(sized).candidates));
  CHECK(answer_json(with(R"("command": "svg")"))["svg"] ==
        placement_svg(placement, *encode_link(document)));
  CHECK(answer_json(with(
            R"("command": "poses", "format": "yaml", "frame": "map", "origin": "com")"))["poses"] ==
        poses_text(placement, PoseFormat::yaml, {PoseOrigin::com, "map"}));
}

TEST_CASE("an experiment of requests is that of the program", "[request]") {
  const std::string polygons = "[{\"name\": \"l\", " + std::string(l_shape) +
                               "}, {\"name\": \"bad\", \"text\": \"POLYGON (\"}]";
  const Json answered = answer_json(
      "{\"command\": \"experiment\", \"polygons\": " + polygons +
      R"(, "settings": {"samples": 2, "max_teams": 2, "max_balanced": 3, "min_ratio": 0.7}})");
  const experiment::ExperimentSettings settings{0.7, 2, 2, 3};
  const auto subject = experiment::prepare(l_document(), {.min_ratio = 0.7});
  REQUIRE(subject.ok());
  experiment::PolygonResult result = experiment::result_of("polygons", "l", *subject);
  for (const Method method : all_methods)
    for (const auto& m : experiment::measure(*subject, method, settings))
      result.measurements.push_back(m);
  experiment::PolygonResult alone = result;
  const auto sets = experiment::group_by_set({alone});
  CHECK(answered["measurements"] == experiment::measurements_csv(sets));
  REQUIRE(answered["refused"].size() == 1);
  CHECK(answered["refused"][0]["polygon"] == "bad");
}

TEST_CASE("a wrong request gets one sentence that says what and where", "[request][errors]") {
  const Json crossing = refusal(R"({"polygon": [[0, 0], [4, 4], [4, 0], [0, 4]]})");
  CHECK(crossing["code"] == "edges_cross");
  CHECK(crossing["message"] == "Edges 1 and 3 cross, touch or overlap");
  CHECK(crossing["place"] == Json::parse(R"({"edges": [0, 2]})"));
  CHECK(refusal(with(R"("settings": {"teams": 0})"))["place"]["setting"] == "teams");
  CHECK(refusal(with(R"("settings": {"teams": "max", "metric": "random"})"))["code"] ==
        "bad_setting");
  CHECK(refusal(R"({"text": "1.x"})")["code"] == "bad_checksum");
  for (const std::string& bad :
       {std::string(),
        std::string("{"),
        std::string("[]"),
        std::string("null"),
        std::string("{}"),
        std::string("{\"polygon\": 3}"),
        std::string("{\"polygon\": [[0]]}"),
        std::string("{\"polygon\": [[0, 0, 0, 0], [1, 0], [0, 1]]}"),
        std::string("{\"polygon\": [[0, 1e999], [1, 0], [0, 1]]}"),
        with(R"("text": "x")"),
        with(R"("setings": {})"),
        with(R"("settings": [])"),
        with(R"("settings": {"loads": "plan"})"),
        with(R"("settings": {"team": 3})"),
        with(R"("settings": {"teams": true})"),
        with(R"("settings": {"teams": [3]})"),
        with(R"("settings": {"weight": 1e999})"),
        with(R"("candidates": 1)"),
        with(R"("frame": "map")"),
        with(R"("failures": true, "failures": true)"),
        with(R"("command": "Place")"),
        with(R"("command": 3)"),
        with(R"("command": "svg", "failures": true)"),
        with(R"("command": "poses", "format": "xml")"),
        with(R"("command": "poses", "frame": "a b")"),
        with(R"("command": "poses", "origin": 3)"),
        with(R"("command": "version")"),
        with(R"("command": "experiment")"),
        std::string(R"({"command": "experiment"})"),
        std::string(R"({"command": "experiment", "polygons": [3]})"),
        std::string(R"({"command": "experiment", "polygons": [], "settings": {"samples": 0}})"),
        std::string(R"({"command": "experiment", "polygons": [], "settings": {"seed": 1}})"),
        std::string("\"\\ud800\""),
        std::string("\xFF"),
        std::string(200, '['),
        std::string("{\"") + std::string(1, '\0') + "\"}"}) {
    const Json error = refusal(bad);
    CHECK_FALSE(error["code"].text().empty());
    CHECK_FALSE(error["message"].text().empty());
    CHECK(error.contains("place"));
  }
}

TEST_CASE("the version is the package's", "[request]") {
  CHECK(answer_json(R"({"command": "version"})")["version"].text().find('.') == 1);
}

TEST_CASE("a program's own kinds of requests are answered beside those of the manual",
          "[request]") {
  const RequestKind kinds[] = {{"count", {"words", "factor"}, [](const RequestMembers& members) {
                                  double letters = 0;
                                  for (const std::string& word : members.texts("words"))
                                    letters += static_cast<double>(word.size());
                                  return json::number(members.number("factor") * letters);
                                }}};
  CHECK(answer(R"({"command": "count", "words": ["ab", "c", 1], "factor": 2})", kinds) == "6\n");
  CHECK(answer(R"({"command": "version"})", kinds) == answer(R"({"command": "version"})"));
  const Json wrong = Json::parse(answer(R"({"command": "count", "facter": 2})", kinds));
  CHECK(wrong["error"]["code"] == "unsupported");
  CHECK(Json::parse(answer(R"({"command": "count"})"))["error"]["code"] == "unsupported");
}

TEST_CASE("settings may stand beside the polygon or in an object of their own", "[request]") {
  const std::string nested = answer(with(R"("settings": {"metric": "circle", "weight": 30})"));
  CHECK(answer(with(R"("metric": "circle", "weight": 30)")) == nested);
  CHECK(answer(with(R"("weight": 30, "settings": {"metric": "circle"})")) == nested);
  const Json twice = refusal(with(R"("weight": 30, "settings": {"weight": 30})"));
  CHECK(twice["path"] == "weight");
}

TEST_CASE(
    "a document in a request is a file of evenlift, and the request's settings count after its own",
    "[request]") {
  Document document = l_document();
  document.settings.method = Method::balanced;
  document.settings.robots = 5;
  document.settings.cargo = {{{1, 1}, 5, "motor"}};
  document.settings.robot.radius = 0.1;
  document.shown.capacity = 40;
  document.shown.carrying = {.com_height = 2, .slope = 0.1};
  const std::string result =
      placement_json({placed(document), document.shown}, false, {.plans = true});
  const std::string members = result.substr(1);
  for (const std::string& text : {result, document_json(document)})
    CHECK(Json::parse(answer("{\"document\": " + text + "}")) == Json::parse(result));
  document.settings.weight = 7;
  CHECK(Json::parse(answer("{\"weight\": 7, \"document\": " + result + "}")) ==
        Json::parse(placement_json({placed(document), document.shown}, false, {.plans = true})));
  // A result's own members are no settings of a request.
  CHECK(refusal("{" + members)["code"] == "bad_setting");
}

TEST_CASE("a last vertex that repeats the first and third coordinates are left out, with a notice",
          "[request]") {
  const std::string plain = answer(R"({"polygon": [[0, 0], [4, 0], [4, 3], [0, 3]]})");
  const Json noticed = answer_json(R"({"polygon": [[0, 0, 1], [4, 0, 1], [4, 3], [0, 3], [0, 0]],
                      "holes": [[[1, 1], [2, 1], [2, 2], [1, 1]]]})");
  CHECK(noticed["polygon"].size() == 4);
  CHECK(noticed["holes"][0].size() == 3);
  CHECK(noticed["notices"] == Json::parse(R"(["third coordinates are left out",
                        "a last vertex that repeats the first is left out"])"));
  CHECK_FALSE(Json::parse(plain).contains("notices"));
  for (const char* command : {"candidates", "svg", "poses", "link", "optimum", "trace"})
    CHECK(answer_json("{\"command\": \"" + std::string(command) +
                      R"(", "polygon": [[0, 0], [4, 0], [4, 3], [0, 3], [0, 0]]})")["notices"]
              .size() == 1);
}

TEST_CASE("files are read as the program reads them, and one of several shapes is chosen",
          "[request][import]") {
  const std::string two = R"j("text": "x,y\n0,0\n4,0\n4,3\n0,3\n\n10,0\n12,0\n12,1\n10,1\n")j";
  const Json several = refusal("{" + two + "}");
  CHECK(several["message"] ==
        "It has 2 shapes; \"shape\" chooses one of them by its number or name");
  CHECK(answer_json("{" + two + R"(, "shape": 2})")["polygon"][0][0] == 10);
  CHECK(refusal("{" + two + R"(, "shape": 3})")["path"] == "shape");
  const Json shapes = answer_json(R"({"command": "shapes", )" + two + "}");
  REQUIRE(shapes["shapes"].size() == 2);
  CHECK(shapes["shapes"][1]["document"]["polygon"][1][0] == 12);
  // In base64: "POLYGON((0 0,4 0,4 3,0 3,0 0))".
  CHECK(answer_json(R"({"bytes": "UE9MWUdPTigoMCAwLDQgMCw0IDMsMCAzLDAgMCkp"})")["polygon"].size() ==
        4);
  CHECK(refusal(R"({"bytes": "UE9M*"})")["path"] == "bytes");
}

TEST_CASE("an error has the path of the member at fault, from 0, and a sentence that counts from 1",
          "[request][errors]") {
  const std::pair<std::string, std::pair<const char*, const char*>> faults[] = {
      {R"({"polygon": [[0, 0], [4, 0], [4]]})",
       {"polygon[2]", "Vertex 3: a point must be two numbers [x, y]"}},
      {R"({"polygon": [[0, 0], [4, NaN], [4, 3]]})",
       {"polygon[1]", "Vertex 2: this is not a finite number"}},
      {with(R"("holes": [[[1, 1], [2, 1], "x"]])"),
       {"holes[0][2]", "Hole 1, vertex 3: a point must be two numbers [x, y]"}},
      {with(R"("cargo": [{"at": [1, 1], "weight": 3}, {"at": [1, 1], "weight": 0}])"),
       {"cargo[1].weight",
        "Load 2: the weight of cargo must be a number greater than 0, from 1e-100 to 1e100"}},
      {with(R"("supports": [[0, 0], [4, 0], [9, 9]])"),
       {"supports[2]", "Robot 3: (9, 9) is 9.01 outside the object"}},
      {with(R"("supports": [[0, 0], {"at": [4, 0], "capacity": "x"}])"),
       {"supports[1].capacity",
        "Robot 2: the capacity of a robot must be a number greater than 0, from 1e-100 to 1e100, or none"}},
      {with(R"("settings": {"weight": [5]})"),
       {"weight", "The weight must be a number greater than 0, from 1e-100 to 1e100"}},
      {with(R"("wieght": 5)"),
       {"wieght", "There is no setting \"wieght\"; did you mean \"weight\"?"}},
      {with(R"("settings": {"minRatio": 5})"),
       {"minRatio", "There is no setting \"minRatio\"; did you mean \"min_ratio\"?"}},
      {with(R"("robot": {"radius": 1, "width": -1})"),
       {"robot.width", "The width of a robot's hand must be a number from 0 to 1000000000"}},
      {with(R"("com": [1, 1], "centre_of_mass": [1, 1])"),
       {"com", "\"com\" is another name of \"centre_of_mass\": give one of them"}},
      {R"({"command": "experiment", "polygons": [{"text": "x"}, {"polygon": [[0, 0], 3]}]})",
       {"polygons[1].polygon[1]", "polygons[1].polygon[1]: a point must be two numbers [x, y]"}},
      {with(R"("supports": [[0, 1.5], [4, 0.75]], "support_names": 5)"),
       {"support_names",
        "The names of the supports must be a name of at most 60 characters for each "
        "support, with spaces between them, such as north \"south west\"; or none"}},
      {with(R"("flatten": 0)"), {"flatten", "flatten: this length must be a number above 0"}},
      {with(R"("join": -1)"), {"join", "join: this length must be a number above 0"}},
      {with(R"("weight": 1e999)"), {"weight", "weight: this number is too large"}},
      {R"({"text": "\ud800"})", {"text", "text: this text has half a character"}}};
  for (const auto& [request, expected] : faults) {
    const Json error = refusal(request);
    CHECK(error["path"] == expected.first);
    CHECK(error["message"] == expected.second);
  }
  // What is no JSON at all is told by its line.
  CHECK(refusal("{\"polygon\": [[0, 0],")["place"].contains("line"));
}

TEST_CASE("a robot's size replaces all of the size that a link has", "[request]") {
  Document document = l_document();
  document.settings.robot = {.radius = 0.1, .reach = 0.2, .gap = 0.05};
  const std::string link = *encode_link(document);
  const Json placed_again =
      answer_json("{\"text\": \"" + link + R"(", "robot": {"radius": 0.07}})");
  CHECK(placed_again["robot"] ==
        Json::parse(R"({"radius": 0.07, "reach": 0, "depth": 0, "width": 0, "gap": 0})"));
}

TEST_CASE("a key given twice is refused in files, too", "[request][import][errors]") {
  const auto read = read_shapes(R"({"polygon": [[0,0],[4,0],[4,3]], "weight": 3,
 "weight": 5})");
  REQUIRE_FALSE(read.ok());
  CHECK(sentence(read.error()) == "Line 2, column 12: the setting \"weight\" is given twice");
}

TEST_CASE("what words say is data", "[request]") {
  const Json sliding = answer_json(with(R"("supports": [[0, 1.5], [4, 0.75]], "require": "held")"));
  CHECK(sliding["held"] == false);
  CHECK(sliding["closure"]["slides"].size() == 2);
  CHECK(sliding["verdict"]["codes"].size() == sliding["verdict"]["reasons"].size());
  const Json even = answer_json(
      R"({"polygon": [[0, 0], [10, 0], [10, 10], [0, 10]], "supports": [[0, 0], [10, 0], [9, 10], [0, 10]], "even_out": true})");
  REQUIRE(even["evened_out"].size() > 0);
  const Json& move = even["evened_out"][0];
  CHECK(move["from"] == Json::parse("[0, 0]"));
  CHECK(move["to"] == even["supports"][static_cast<std::size_t>(move["robot"].whole_number())]);
  CHECK(move["by"].number() > 0);
  const Json over = answer_json(with(R"("capacity": 40, "failures": true, "teams": 2)"));
  for (std::size_t i = 0; i < over["failures"].size(); ++i) {
    const Json& failure = over["failures"][i];
    if (failure["overloaded"].is_null()) continue;
    CHECK((failure["overloaded"].size() > 0) == (failure["over_capacity"] == true));
  }
  CHECK(over["effective"]["snap"].number() == Approx(5e-4));
  CHECK(over["version"] == answer_json(R"({"command": "version"})")["version"]);
}

TEST_CASE("parts are all shapes of a file, each with robots of its own", "[request]") {
  const std::string file =
      R"("text": "small\n0,0\n4,0\n4,3\n0,3\n\nlarge\n10,0\n18,0\n18,6\n10,6\n\nbow\n0,0\n4,4\n4,0\n0,4\n")";
  const auto parts = [&](const std::string& more) {
    return answer_json(R"({"command": "parts", )" + file + more + "}");
  };
  const Json all = parts(R"(, "weight_per_area": 2, "capacity": 20)");
  CHECK(all.names() == std::vector<std::string>{"notices", "parts", "csv"});
  REQUIRE(all["parts"].size() == 3);
  const Json &small = all["parts"][0], &large = all["parts"][1], &bow = all["parts"][2];
  CHECK(small["name"] == "small");
  CHECK(small["at"] == std::vector<double>{2, 1.5});
  CHECK(small["weight"] == 24);
  CHECK(small["robots"].size() == 4);
  CHECK(large["area"] == 48);
  CHECK(large["loads"]["max"].number() <= 20);
  CHECK(bow["error"]["code"] == "edges_cross");
  CHECK(all["csv"].text().starts_with("shape,name,x,y,"));

  SECTION("but not a sheet around them") {
    const std::string sheet =
        "<svg fill='none' stroke='black'><path d='M0 0H90V60H0Z'/><path d='M5 5h20v10h-20z'/>"
        "<path d='M7 7h4v4h-4z'/><path d='M40 5h20v10h-20z'/><path d='M42 7h4v4h-4z'/></svg>";
    const Json plates = answer_json(R"({"command": "parts", "text": ")" + sheet + "\"}");
    REQUIRE(plates["parts"].size() == 2);
    CHECK(plates["parts"][0]["area"] == 184);
  }

  SECTION("with names that are unique") {
    const Json named = answer_json(
        R"({"command": "parts", "text": "a\n0,0\n4,0\n4,3\n\na\n10,0\n14,0\n14,3\n\na (1)\n20,0\n24,0\n24,3\n"})");
    CHECK(named["parts"][0]["name"] == "a (2)");
    CHECK(named["parts"][1]["name"] == "a (3)");
    CHECK(named["parts"][2]["name"] == "a (1)");
  }
  SECTION("in the order that is asked for") {
    const Json sorted = parts(R"(, "weight_per_area": 2, "sort": "weight", "require": "max<=9")");
    CHECK(sorted["parts"][0]["name"] == "large");
    CHECK(sorted["parts"][0]["requirements"][0]["kept"] == false);
    CHECK(sorted["csv"].text().find(",kept,") != std::string::npos);
  }
  SECTION("and a number of robots that is asked for stays") {
    for (const char* teams : {R"(, "teams": 3)", R"(, "settings": {"teams": 3})"})
      CHECK(parts(R"(, "weight": 4, "capacity": 20)" + std::string(teams))["parts"][0]["robots"]
                .size() == 6);
  }
  SECTION("and a weight by area is also for a single polygon, whose unit may differ") {
    // 8 mm of a material of 7,850 kg a cubic metre weigh 62.8 kg a square metre.
    const double of_material =
        answer_json(with(R"("thickness": "8", "density": "7850/m3", "unit": "mm")"))["weight"]
            .number();
    CHECK(
        of_material ==
        Approx(
            answer_json(with(R"("weight_per_area": "62.8/m2", "unit": "mm")"))["weight"].number()));
    CHECK(answer_json(with(R"("weight_per_area": "3/m2", "unit": "cm")"))["weight"].number() ==
          Approx(3e-4 * 8.25));
    CHECK(
        parts(R"(, "weight_per_area": 3, "unit": "cm")")["notices"].texts().back() ==
        "weight_per_area: this was read as 3/cm2, in the unit of the coordinates; 3/m2 is another weight");
  }
  SECTION("and what is wrong is said once, with its path") {
    const auto refused = [&](const std::string& members) {
      const Json error = refusal(R"({"command": "parts", )" + members + "}");
      return error["path"].text() + ": " + error["message"].text();
    };
    CHECK(
        refused(file + R"(, "weight_per_area": "heavy")") ==
        "weight_per_area: The weight by area must be a number above 0, perhaps with its unit, such as "
        "15.6/m2, not \"heavy\"");
    CHECK(refused(file + R"(, "thickness": 8)") ==
          "thickness: The thickness needs a density as well");
    CHECK(refused(file + R"(, "density": 8, "settings": {"weight": 5})") ==
          "density: The weight by area applies without a weight");
    CHECK(refused(file + R"(, "sort": "size")") ==
          "sort: sort: expected file, number, name, area, weight or load");
    CHECK(
        refused(R"("shape": 2, )" + file).starts_with("shape: shape: this is of a single polygon"));
    CHECK(refused(l_shape).starts_with("polygon: "));
  }
}
