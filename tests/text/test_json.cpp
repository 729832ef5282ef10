
#include "evenlift/generate.h"
#include "evenlift/output/json.h"
#include "evenlift/output/json_text.h"
#include "evenlift/placement.h"
#include "exact/pseudo_angle.h"
#include "kit/corpus.h"
#include "kit/json.h"
#include "kit/placed.h"
#include "kit/texts.h"

using namespace evenlift;
using evenlift::testing::Json;
using evenlift::testing::placed;

namespace {

using evenlift::same_bits;  // of doubles

bool same_bits(const Json& json, const Vec2& point) {
  return json.size() == 2 && same_bits(json[0].number(), point.x) &&
         same_bits(json[1].number(), point.y);
}

bool same_bits(const Json& json, const Points& points) {
  if (json.size() != points.size()) return false;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (!same_bits(json[i], points[i])) return false;
  return true;
}

}  // namespace

TEST_CASE("JSON on one line has the same items", "[json]") {
  CHECK(json::on_one_line("") == "");
  CHECK(json::on_one_line("{\n  \"a  \\n\": [\n    [1, 2],\n    3\n  ],\n  \"b\": []\n}\n") ==
        R"({"a  \n": [[1, 2], 3], "b": []})");
  const std::string text = placement_json(placed(corpus::polygon("thesis-sample")), true);
  const std::string line = json::on_one_line(text);
  CHECK(line.find('\n') == std::string::npos);
  CHECK(line.find(",\"") == std::string::npos);
  CHECK(Json::parse(line) == Json::parse(text));
}

TEST_CASE("the JSON of a placement has cli.md's shape", "[json]") {
  using Names = std::vector<std::string>;
  for (const Method method : pair_methods) {
    Document document = corpus::polygon("thesis-sample-centroid");
    document.settings.method = method;
    const Placement placement = placed(document);
    const Json plain = Json::parse(placement_json(placement, false));
    CHECK(plain.names() == Names{"polygon",      "centre_of_mass", "own_centre_of_mass",
                                 "total_weight", "metric",         "min_ratio",
                                 "weight",       "seed",           "requested_teams",
                                 "teams",        "robots",         "hull",
                                 "coverage",     "loads",          "closure",
                                 "goal",         "goal_reached",   "stands",
                                 "held",         "verdict",        "clear",
                                 "robustness",   "accuracy",       "tilt",
                                 "effective",    "version"});
    const Json full = Json::parse(placement_json(placement, true));
    CHECK(full.contains("candidates"));
    CHECK(full["teams"][0].names() == Names{"ends", "ratio", "loads"});
    CHECK(full["candidates"][0].names() == Names{"ends", "ratio", "kind"});
    CHECK(full["loads"].names() == Names{"min", "mean", "max", "spread", "max_share", "models"});
    CHECK(full["closure"].names() == Names{"form_closure", "margin", "clearance", "tolerance",
                                           "second_order", "free", "slides", "depends_on",
                                           "clockwise", "counterclockwise"});
    CHECK(full["metric"] == std::string(name(method)));
  }
}

TEST_CASE("the JSON of teams that hold in ranges says so", "[json]") {
  Document document = corpus::polygon("thesis-sample-centroid");
  document.settings.positions = Positions::range;
  document.settings.goal = Goal::hold;
  const Json json = Json::parse(placement_json(placed(document), true));
  CHECK(json["positions"] == "range");
  CHECK(json["goal"] == "hold");
  CHECK(json["goal_reached"] == true);
  CHECK(json["min_margin"] == 0.05);
  const auto& candidates = json["candidates"];
  CHECK(std::any_of(candidates.begin(), candidates.end(),
                    [](const auto& candidate) { return candidate["kind"] == "range"; }));
}

TEST_CASE("the JSON of balanced robots says what they were asked for", "[json][balanced]") {
  Document document = corpus::polygon("grand-piano");
  document.settings.method = Method::balanced;
  document.settings.robots = 5;
  const Json json = Json::parse(placement_json(placed(document), false));
  CHECK(json["metric"] == "balanced");
  CHECK(json["requested_robots"] == 5);
  CHECK(json["goal"] == "hold");
  CHECK(json["goal_reached"] == true);
  CHECK(json["min_margin"] == 0.05);
  CHECK(json["apart"].is_null());
  CHECK(json["survive"] == 0);
  REQUIRE(json["teams"].size() == 1);
  CHECK(json["teams"][0]["ends"].size() == 5);
  CHECK(json["teams"][0]["loads"] == std::vector<double>(5, 20.0));
  CHECK(json["teams"][0]["ratio"] == 1);
}

TEST_CASE("the numbers of the JSON read back to the same doubles", "[json][slow]") {
  for (const std::string& name : corpus::polygon_names()) {
    CAPTURE(name);
    Document document = corpus::polygon(name);
    document.settings.teams = 5;
    document.settings.weight = 1.0 / 3;
    document.settings.seed = ~std::uint64_t{0};
    const Placement placement = placed(document);
    const Json json = Json::parse(placement_json(placement, true));
    CHECK(same_bits(json["polygon"], placement.vertices()));
    CHECK(same_bits(json["centre_of_mass"], placement.centre_of_mass));
    CHECK(same_bits(json["weight"].number(), 1.0 / 3));
    CHECK(json["seed"].whole_number() == ~std::uint64_t{0});
    CHECK(json["requested_teams"] == 5);
    CHECK(same_bits(json["hull"], placement.lifting_base));
    CHECK(same_bits(json["coverage"].number(), placement.coverage));
    REQUIRE(json["candidates"].size() == placement.candidates.size());
    REQUIRE(json["teams"].size() == placement.teams.size());
    for (std::size_t i = 0; i < placement.teams.size(); ++i) {
      const Team& team = placement.teams[i];
      CHECK(same_bits(json["teams"][i]["ends"],
                      Points{team.robots[0].point.position, team.robots[1].point.position}));
      CHECK(same_bits(json["teams"][i]["ratio"].number(), team.ratio));
      CHECK(same_bits(json["teams"][i]["loads"][1].number(), team.robots[1].load));
    }
    const Closure& closure = placement.closure;
    CHECK(json["closure"]["free"].empty() == closure.form_closure);
    CHECK(json["closure"]["margin"].is_null() == !closure.margin.has_value());
    CHECK(same_bits(json["closure"]["clockwise"], closure.clockwise.clipped));
    CHECK(same_bits(json["closure"]["counterclockwise"], closure.counterclockwise.clipped));
  }
}

TEST_CASE("with no team the loads are null and H is empty", "[json]") {
  Document document;
  // A wide U with C near one arm: no chord is nearly even.
  document.vertices = {{-1, -1}, {101, -1}, {101, 60}, {100, 60},
                       {100, 0}, {0, 0},    {0, 60},   {-1, 60}};
  document.centre_of_mass = Vec2(10, 50);
  const Placement placement = placed(document);
  REQUIRE(placement.teams.empty());
  const Json json = Json::parse(placement_json(placement, true));
  CHECK(json["candidates"].empty());
  CHECK(json["teams"].empty());
  CHECK(json["hull"].empty());
  CHECK(json["coverage"] == 0);
  CHECK(json["loads"].is_null());
  CHECK(json["closure"]["margin"].is_null());
  CHECK(json["closure"]["free"] ==
        Json::parse(R"(["clockwise", "counterclockwise", "translation"])"));
}

TEST_CASE("the JSON of a document holds its polygon and all settings", "[json]") {
  Document document = corpus::polygon("thesis-sample");
  document.settings = {
      .teams = std::nullopt, .method = Method::circle, .min_ratio = 0.25, .weight = 1e9, .seed = 7};
  document.shown = {.overlays = {.candidates = true, .chords = false}, .step = 4};
  Json json = Json::parse(document_json(document));
  CHECK(json["polygon"].size() == 11);
  CHECK(json["centre_of_mass"] == Json::parse("[278, 227]"));
  CHECK(json["teams"] == "max");
  CHECK(json["metric"] == "circle");
  CHECK(json["min_ratio"] == 0.25);
  CHECK(json["weight"] == 1e9);
  CHECK(json["seed"] == 7);
  CHECK(json["overlays"]["candidates"] == true);
  CHECK(json["overlays"]["chords"] == false);
  CHECK(json["step"] == 4);
  document.centre_of_mass.reset();
  document.settings = {};
  document.shown = {};
  json = Json::parse(document_json(document));
  CHECK(json["centre_of_mass"].is_null());
  CHECK(json["teams"] == 3);
  CHECK(json["step"].is_null());
}

// tests/expected/POLYGON.METRIC.json makes changes of the output with --candidates visible. The
// target update_expected rewrites the files.
TEST_CASE("known polygons give the expected results", "[expected]") {
  const std::filesystem::path folder = std::filesystem::path(EVENLIFT_TESTS_DIR) / "expected";
  const bool renew = std::getenv("EVENLIFT_UPDATE_EXPECTED") != nullptr;
  std::size_t count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".json") continue;
    ++count;
    const std::filesystem::path stem = entry.path().stem();
    INFO(entry.path().string());
    Document document = corpus::polygon(stem.stem().string());
    const std::optional<Method> method = method_from_name(stem.extension().string().substr(1));
    REQUIRE(method);
    document.settings.method = *method;
    const std::string json = placement_json(placed(document), true);
    if (renew) corpus::write_file(entry.path(), json);
    CHECK(json == corpus::read_file(entry.path()));
  }
  CHECK(count >= 10);
}
