// No value overrides another silently, and notices report the facts.
#include <string>

#include "evenlift/import.h"
#include "evenlift/request.h"
#include "kit/catch.h"

using namespace evenlift;

namespace {

constexpr const char* square = R"("polygon": [[0, 0], [4, 0], [4, 4], [0, 4]])";

std::string with_settings(const std::string& settings) {
  return answer("{" + std::string(square) + ", \"settings\": {" + settings + "}}");
}

std::string ring(const std::string& properties, bool with_hole) {
  return R"({"type": "Feature", "properties": {)" + properties +
         R"(}, "geometry": {"type": "Polygon", "coordinates": [[[0,0],[9,0],[9,9],[0,9],[0,0]])" +
         (with_hole ? ",[[1,1],[2,1],[2,2],[1,1]]" : "") + "]}}";
}

std::string notes(const std::string& text) {
  const Result<Import> import = read_shapes(text);
  REQUIRE(import.ok());
  std::string all;
  for (const std::string& note : import->notes) all += note + "\n";
  return all;
}

std::string refusal(const std::string& text) {
  const Result<Import> import = read_shapes(text);
  REQUIRE_FALSE(import.ok());
  return import.error().message;
}

}  // namespace

TEST_CASE("a setting given twice in a request is refused", "[request][errors]") {
  const std::string twice = with_settings(R"("teams": 1, "weight": 7, "teams": 2)");
  CHECK(twice.find("\"bad_setting\"") != std::string::npos);
  CHECK(twice.find("The setting \\\"teams\\\" is given twice") != std::string::npos);
  CHECK(with_settings(R"("teams": null, "teams": null)").find("given twice") != std::string::npos);
  CHECK(with_settings(R"("metric": "area", "method": "area")")
            .find("\\\"metric\\\" and \\\"method\\\" are the same setting") != std::string::npos);
  CHECK(with_settings(R"("teams": 1, "weight": 7)").find("error") == std::string::npos);
}

TEST_CASE("the order of settings in a request means nothing", "[request]") {
  const std::string first = with_settings(R"("robot": "r=0.1,gap=0.2", "robot_radius": 0.05)");
  CHECK(first.find("\"radius\": 0.05") != std::string::npos);
  CHECK(first.find("\"gap\": 0.2") != std::string::npos);
  CHECK(with_settings(R"("robot_radius": 0.05, "robot": "r=0.1,gap=0.2")") == first);
}

TEST_CASE("a feature with a hole needs no notice, with or without a centre of mass",
          "[import][geojson][holes]") {
  CHECK(notes(ring(R"("centre_of_mass": [2, 3])", true)).empty());
  CHECK(notes(ring("", true)) == notes(ring("", false)));
}

TEST_CASE("a list of robots is refused by name, and is no polygon", "[import][errors]") {
  for (
      const char* text :
      {"robot,x,y\n1,0,0\n2,4,0\n3,4,4\n", "x,y,robot\n0,0,1\n4,0,2\n4,4,3\n",
       "\"Robot\";\"x\";\"y\"\n1;0;0\n2;4;0\n3;4;4\n",
       "robot,team,x,y,heading_deg,load,unit,weight_unit\n1,1,0,0,90,5,,kg\n2,1,4,4,0,5,,kg\n",
       R"([{"robot": 1, "x": 0, "y": 0}, {"robot": 2, "x": 4, "y": 0}, {"robot": 3, "x": 4, "y": 4}])"}) {
    INFO(text);
    CHECK(refusal(text).starts_with("these are the robots of a result, not a polygon"));
  }
  // Other columns do no harm.
  CHECK(read_shapes("corner,x,y\n1,0,0\n2,4,0\n3,4,4\n").ok());
  CHECK(read_shapes(R"([{"corner": 1, "x": 0, "y": 0}, {"x": 4, "y": 0}, {"x": 4, "y": 4}])").ok());
}
