// tests/consumers/check_c.py compares the answers with the program's output.
#include "evenlift/request.h"

#include <string>

#include "evenlift/experiment/outputs.h"
#include "evenlift/link.h"
#include "evenlift/output/json.h"
#include "evenlift/output/json_text.h"
#include "evenlift/output/poses.h"
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
  const auto subject = experiment::prepare(l_document(), 0.7);
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
        std::string("{\"polygon\": [[0, 0, 0], [1, 0], [0, 1]]}"),
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
