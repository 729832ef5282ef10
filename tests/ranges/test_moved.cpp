#include <algorithm>
#include <cmath>
#include <string>

#include "evenlift/balanced.h"
#include "evenlift/link.h"
#include "evenlift/moved.h"
#include "evenlift/output/json.h"
#include "evenlift/random.h"
#include "evenlift/settings.h"
#include "evenlift/tolerance.h"
#include "evenlift/trace.h"
#include "kit/catch.h"
#include "kit/corpus.h"
#include "kit/placed.h"

using namespace evenlift;
using evenlift::testing::placed;

namespace {

Document in_ranges(const std::string& name) {
  Document document = corpus::polygon(name);
  document.settings.positions = Positions::range;
  return document;
}

Placement moved_to(const Placement& placement, const Moved& moved) {
  auto result = with_moved(placement, moved);
  INFO((result ? "" : result.error().message));
  REQUIRE(result.ok());
  return *std::move(result);
}

std::string why_not(const Document& document, const std::string& moved) {
  Document wrong = document;
  const auto read = read_moved(moved);
  REQUIRE(read);
  wrong.moved = *read;
  const Result<Placement> placement = place(wrong);
  REQUIRE_FALSE(placement.ok());
  CHECK(placement.error().code == ErrorCode::bad_setting);
  CHECK(placement.error().place.kind == Place::Kind::nowhere);  // no setting is named
  const std::string of_whom = "robots moved by hand: ", message = placement.error().message;
  CHECK(message.starts_with(of_whom));
  return message.substr(of_whom.size());
}

double distance_to_edge(const Placement& placement, const LiftingPoint& point) {
  const Vec2 &a = placement.polygon().edge_start(point.edge),
             &b = placement.polygon().edge_end(point.edge);
  const double along = std::clamp(dot(point.position - a, b - a) / dot(b - a, b - a), 0.0, 1.0);
  return length(point.position - (a + along * (b - a)));
}

// By its points alone, wherever it stands.
void check_team(const Placement& placement, const Team& team) {
  const double near = near_distance(placement.polygon().diameter());
  const Vec2& centre = placement.centre_of_mass;
  const Vec2 a = team.robots[0].point.position - centre, b = team.robots[1].point.position - centre;
  for (const Robot& robot : team.robots) CHECK(distance_to_edge(placement, robot.point) <= near);
  CHECK(std::fabs(cross(a, b)) <= near * std::max(length(a), length(b)));
  CHECK(dot(a, b) < 0);
  const double ratio = std::min(length(a), length(b)) / std::max(length(a), length(b));
  CHECK(ratio >= placement.settings.min_ratio - 1e-9);
  CHECK(team.ratio == Approx(ratio).epsilon(1e-9));
}

}  // namespace

TEST_CASE("a team that is moved stays even, on the outline and through C", "[moved][slow]") {
  Rng rng(7);
  std::size_t moves = 0, passed = 0;
  for (const std::string& name : corpus::polygon_names()) {
    Placement placement = placed(in_ranges(name));
    INFO(name);
    if (placement.teams.empty()) continue;
    for (int i = 0; i < 12; ++i) {
      const auto robot = static_cast<std::size_t>(rng.below(count_robots(placement.teams)));
      const Vec2& c = placement.centre_of_mass;
      const double size = placement.polygon().diagonal(), x = rng.uniform(), y = rng.uniform();
      const Vec2 to(c.x + size * (x - 0.5), c.y + size * (y - 0.5));
      const auto moved = moved_along_range(placement, robot, to);
      if (!moved) continue;
      ++moves;
      const std::size_t team = find_robot(placement.teams, robot).team;
      const Placement now = moved_to(placement, *moved);
      for (const Team& each : now.teams) check_team(now, each);
      for (std::size_t k = 0; k < now.teams.size(); ++k) {
        if (k == team) continue;
        for (std::size_t end = 0; end < 2; ++end)
          CHECK(now.teams[k].robots[end].point.position ==
                placement.teams[k].robots[end].point.position);
      }
      const auto other_edge = [&](const Placement& p) {
        const auto [t, r] = find_robot(p.teams, robot);
        return p.teams[t].robots[r].point.edge;
      };
      passed += other_edge(now) != other_edge(placement);
      placement = now;
    }
  }
  CHECK(moves > 500);
  CHECK(passed > 50);  // vertices
}

TEST_CASE("a second team that is moved leaves the first where it was moved to", "[moved]") {
  Placement placement = placed(in_ranges("guitar"));
  const auto turn = [&](std::size_t robot) {
    const auto [team, end] = find_robot(placement.teams, robot);
    const Vec2 at = placement.teams[team].robots[end].point.position, c = placement.centre_of_mass;
    const auto moved = moved_along_range(placement, robot, at + 0.05 * left_normal(at - c));
    REQUIRE(moved);
    placement = moved_to(placement, *moved);
  };
  turn(2);
  const Team second = placement.teams[1];
  turn(0);
  CHECK(placement.moved.teams.size() == 2);
  for (const std::size_t end : {0u, 1u})
    CHECK(placement.teams[1].robots[end].point.position == second.robots[end].point.position);
}

TEST_CASE("a team on a vertex goes along either edge", "[moved]") {
  Document document;
  document.vertices = {{0, 0}, {400, 0}, {400, 200}, {0, 200}};
  document.settings.positions = Positions::range;
  document.settings.min_ratio = 0.5;
  const Placement placement = placed(document);
  std::size_t on_vertex = 0;
  for (std::size_t robot = 0; robot < count_robots(placement.teams); ++robot) {
    const auto [team, end] = find_robot(placement.teams, robot);
    const Vec2 at = placement.teams[team].robots[end].point.position;
    const auto& v = document.vertices;
    if (std::find(v.begin(), v.end(), at) == v.end()) continue;
    ++on_vertex;
    for (const double turn : {0.1, -0.1}) {
      const Vec2 c = placement.centre_of_mass, to = at + turn * left_normal(at - c);
      const auto moved = moved_along_range(placement, robot, to);
      REQUIRE(moved);
      const Placement now = moved_to(placement, *moved);
      check_team(now, now.teams[team]);
      const auto towards = [&](const Robot& r) {
        const Vec2 d = r.point.position - c;
        return dot(d, to - c) / (length(d) * length(to - c));
      };
      CHECK(std::max(towards(now.teams[team].robots[0]), towards(now.teams[team].robots[1])) ==
            Approx(1).epsilon(1e-12));
    }
  }
  CHECK(on_vertex > 0);
}

TEST_CASE("a link brings moved robots back bit for bit", "[moved][link][slow]") {
  Rng rng(11);
  for (const char* name : {"guitar", "square", "grand-piano", "labyrinth"}) {
    INFO(name);
    Document document = in_ranges(name);
    for (const std::uint32_t balanced : {0u, 3u, 5u}) {
      if (balanced > 0) {
        document.moved = {};
        document.settings = {};
        document.settings.method = Method::balanced;
        document.settings.robots = balanced;
      }
      Placement placement = placed(document);
      for (int i = 0; i < 8; ++i) {
        const auto robot = static_cast<std::size_t>(rng.below(count_robots(placement.teams)));
        const auto edge = static_cast<std::uint32_t>(rng.below(document.vertices.size()));
        const double part = rng.uniform();
        const Vec2 to = (1 - part) * placement.polygon().edge_start(edge) +
                        part * placement.polygon().edge_end(edge);
        const auto moved = balanced > 0 ? moved_along_outline(placement, robot, {to, edge})
                                        : moved_along_range(placement, robot, to);
        if (moved) placement = moved_to(placement, *moved);
      }
      REQUIRE(placement.moved.any());
      document.moved = placement.moved;
      const auto link = encode_link(document);
      REQUIRE(link.ok());
      CHECK(link->starts_with("2."));
      const auto back = decode_link(*link);
      REQUIRE(back.ok());
      CHECK(back->moved == document.moved);
      const Placement again = placed(*back);
      CHECK(placement_json(again, true, {}, {}) == placement_json(placement, true, {}, {}));
      CHECK(placement_json(again, false, {}, {}).find("\"moved\"") != std::string::npos);
      if (balanced > 0) {
        CHECK(again.loads->spread == 0);
        continue;
      }
      // The steps are as for teams at computed places.
      document.moved = {};
      const auto trace = make_trace(again);
      REQUIRE(trace.ok());
      CHECK(trace->placement.team_candidates == placed(document).team_candidates);
    }
  }
}

TEST_CASE("moved robots that cannot stand there are refused with a sentence", "[moved][errors]") {
  const Document square = in_ranges("square");
  CHECK(why_not(square, "99@1:0.5/3") == "there is no team 99");
  CHECK(why_not(square, "1@99:0.5/3") == "there is no edge 99");
  CHECK(why_not(square, "1@1:0.5/99") == "there is no edge 99");
  CHECK(why_not(square, "1@1:0.5/1") == "team 1 is outside its range there");
  CHECK(why_not(square, "1@1:0.5/2") == "team 1 is outside its range there");
  CHECK(why_not(square, "1:0.5,2:0.5,3:0.5") == "3 balanced robots were not requested");
  Document best = square;
  best.settings.positions = Positions::best;
  CHECK(why_not(best, "1@1:0.5/3") == "teams can be moved only with the positions range");
  Document balanced = corpus::polygon("square");
  balanced.settings.method = Method::balanced;
  balanced.settings.robots = 4;
  CHECK(why_not(balanced, "1:0.5,2:0.5,3:0.5") == "3 balanced robots were not requested");
  CHECK(why_not(balanced, "1:0.5,2:0.5,3:0.5,9:0.5") == "there is no edge 9");
  CHECK(why_not(balanced, "1:0.5,2:0.5,3:0.5,4:0.75") ==
        "the centroid of the robots is not the centre of mass");
  CHECK(why_not(balanced, "1@1:0.5/3") == "teams can be moved only with the positions range");
  balanced.settings.robot.radius = 10;
  balanced.moved = *read_moved("1:0.5,2:0.5,3:0.5,4:0.5");
  CHECK(place(balanced).ok());
  CHECK(why_not(balanced, "1:0.5,1:0.5,3:0.5,3:0.5") == "two robots collide");
  balanced.settings.no_go = {{0, 0.25, 0.75}};
  CHECK(why_not(balanced, "1:0.5,2:0.5,3:0.5,4:0.5") == "robot 1 has no room there");
}

TEST_CASE("moved robots as text", "[moved]") {
  for (const std::string text :
       {"1:0", "3:0.25,5:0.5,9:1", "2@3:0.25/9", "1@1:0.5/2,2@3:0.25/9", ""}) {
    const auto moved = text.empty() ? std::optional(Moved{}) : read_moved(text);
    REQUIRE(moved);
    CHECK(moved_text(*moved) == text);
  }
  std::string many;
  for (std::uint32_t i = 0; i <= most_robots; ++i) many += (i == 0 ? "1:0" : ",1:0");
  for (const std::string& text :
       {std::string(), std::string("0:0.5"), std::string("1"), std::string("1:"),
        std::string("1:1.5"), std::string("1:-0.5"), std::string("1:0.5,"), std::string("1: 0.5"),
        std::string("1:nan"), std::string("1@2:0.5"), std::string("0@2:0.5/1"),
        std::string("1@2:0.5/0"), std::string("1@2:0.5/3,4:0.5"),
        std::string("2@2:0.5/3,1@2:0.5/3"), std::string("1@2:0.5/3,1@2:0.5/3"),
        std::string("1048577:0.5"), many})
    CHECK_FALSE(read_moved(text));
}

TEST_CASE("a setting that has a say in the places puts moved robots back", "[moved]") {
  for (const auto& [setting, text, stay] : {std::tuple(Setting::weight, "50", true),
                                            {Setting::capacity, "20", true},
                                            {Setting::com_radius, "3", true},
                                            {Setting::overlays, "none", true},
                                            {Setting::step, "2", true},
                                            {Setting::unit, "mm", true},
                                            {Setting::teams, "2", false},
                                            {Setting::min_ratio, "0.7", false},
                                            {Setting::com, "1,2", false},
                                            {Setting::method, "circle", false},
                                            {Setting::robots, "5", false},
                                            {Setting::positions, "best", false},
                                            {Setting::no_go, "1", false}}) {
    Document document;
    document.moved.robots = {{0, 0.5}};
    INFO(text);
    REQUIRE_FALSE(read_setting(setting, text, document));
    CHECK(document.moved.any() == stay);
  }
}
