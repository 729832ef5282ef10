#include <algorithm>
#include <cmath>
#include <string>

#include "candidates/pair_candidate.h"
#include "candidates/standing.h"
#include "evenlift/generate.h"
#include "evenlift/output/json.h"
#include "evenlift/placed_robots.h"
#include "evenlift/placement.h"
#include "evenlift/random.h"
#include "evenlift/selection.h"
#include "evenlift/settings.h"
#include "evenlift/swaps.h"
#include "evenlift/tolerance.h"
#include "evenlift/trace.h"
#include "kit/catch.h"
#include "kit/corpus.h"
#include "kit/solid.h"
#include "stands/stand_oracle.h"

using namespace evenlift;

namespace {

// In units of L, from a small body to all parts at once.
RobotSize size_number(int number, double diagonal) {
  const double d = diagonal;
  switch (number) {
    case 0:
      return {0.03 * d, 0, 0, 0, 0};
    case 1:
      return {0.02 * d, 0.02 * d, 0, 0.02 * d, 0.01 * d};
    case 2:
      return {0.02 * d, 0.01 * d, 0.02 * d, 0.01 * d, 0};
    default:
      return {0, 0, 0, 0, 0.05 * d};
  }
}

Document sample(const std::string& name, int size, Method method = Method::area) {
  Document document = corpus::polygon(name);
  document.settings.method = method;
  const auto polygon = Polygon::create(document.vertices);
  document.settings.robot = size_number(size, polygon->diagonal());
  return document;
}

// By the oracle at the contacts.
void check_standing(const Placement& p) {
  REQUIRE(p.stands);
  const Stands& stands = *p.stands;
  const double size = p.polygon().diagonal(), rounding = 1e-7 * size;
  const std::vector<LiftingPoint> points = lifting_points(p.teams), touched = contact_points(p);
  const testing::StandOracle oracle(p.polygon(), p.settings.robot, p.settings.no_go);
  const auto robots = placed_robots(p);
  for (std::size_t i = 0; i < points.size(); ++i) {
    INFO("robot " << i);
    CHECK(stands.can_lift(points[i]));
    const Vec2 &a = p.polygon().edge_start(touched[i].edge),
               &b = p.polygon().edge_end(touched[i].edge);
    const double part = dot(touched[i].position - a, b - a) / dot(b - a, b - a);
    CHECK(length(a + part * (b - a) - touched[i].position) <= rounding);
    CHECK(oracle.at(touched[i].edge, part) != testing::StandOracle::Verdict::cannot);
    CHECK(length(robots[i].contact - touched[i].position) == 0);
    CHECK(length(robots[i].at - touched[i].position) ==
          Approx(p.settings.robot.depth).margin(rounding));
    CHECK(length(robots[i].stand - touched[i].position) ==
          Approx(stands.has_body() ? p.settings.robot.radius + p.settings.robot.reach : 0)
              .margin(rounding));
    testing::StandOracle::Clashes clashes;
    for (std::size_t j = 0; j < i; ++j)
      CHECK(oracle.beside(touched[i], touched[j], clashes) !=
            testing::StandOracle::Verdict::cannot);
  }
}

}  // namespace

TEST_CASE("robots of every size stand where they can and never collide", "[stands][slow]") {
  std::size_t teams = 0, fewer = 0;
  for (const std::string& name : corpus::polygon_names()) {
    for (int size = 0; size < 4; ++size) {
      for (const Method method : {Method::area, Method::circle, Method::distance}) {
        if (method != Method::area && size != 1) continue;
        const Document document = sample(name, size, method);
        if (document.vertices.size() > 300) continue;
        INFO(name << " with size " << size);
        const auto placed = place(document);
        if (!placed) {
          CHECK(placed.error().message.find("no edge has room") == 0);
          continue;
        }
        check_standing(*placed);
        for (const Candidate& candidate : placed->candidates) {
          CHECK(placed->stands->can_lift(candidate.chord.r1));
          CHECK(placed->stands->can_lift(candidate.chord.r2));
          CHECK(candidate.chord.ratio >= placed->settings.min_ratio - 1.001e-9);
        }
        teams += placed->teams.size();
        fewer += placed->teams.size() < 3 ? 1u : 0u;
      }
    }
  }
  CHECK(teams > 1000);
  CHECK(fewer > 0);
}

TEST_CASE("arms of robots that are placed keep off other bodies and arms", "[stands][slow]") {
  // Without checks of arms, robot 2's arm passed through robot 6's body here.
  const auto vertices = generate(Family::star, 19, 372);
  REQUIRE(vertices.ok());
  Document document;
  document.vertices = *vertices;
  document.settings.teams = 4;
  document.settings.robot = {15, 100, 10, 10, 5};
  for (const Positions positions : {Positions::best, Positions::range})
    for (const Goal goal : {Goal::cover, Goal::hold})
      for (const Method method : {Method::area, Method::balanced}) {
        INFO(name(positions) << ", " << name(goal) << ", " << name(method));
        document.settings.positions = positions;
        document.settings.goal = goal;
        document.settings.method = method;
        const auto p = place(document);
        if (!p && method == Method::balanced) continue;
        REQUIRE(p.ok());
        check_standing(*p);
      }
}

namespace {

// Without colliding with the other teams.
bool has_room(const Placement& p, const std::vector<std::uint32_t>& taken, std::size_t team,
              std::uint32_t candidate) {
  std::vector<LiftingPoint> robots{p.candidates[candidate].chord.r1,
                                   p.candidates[candidate].chord.r2};
  for (std::size_t other = 0; other < taken.size(); ++other) {
    if (other == team) continue;
    robots.push_back(p.candidates[taken[other]].chord.r1);
    robots.push_back(p.candidates[taken[other]].chord.r2);
  }
  return !p.stands->any_collide(robots);
}

// Only contacts far enough from corners count.
std::uint32_t level_of(const Placement& p) {
  const HoldRequirements firm = hold_requirements(p);
  const double near = near_distance(p.polygon().diameter());
  std::vector<Contact> counted;
  for (const Contact& contact : contacts(p.polygon(), contact_points(p)))
    if (contact.to_corner >= firm.clear - near) counted.push_back(contact);
  const double margin = analyse_hold(p.polygon(), p.centre_of_mass, counted).margin.value_or(-1);
  std::uint32_t level = 0;
  for (const double bound : {0.001, 0.4 * firm.min_margin, firm.min_margin})
    level += margin >= bound;
  const bool is_firm =
      analyse_clearance(p.polygon(), p.centre_of_mass, contacts(p.polygon(), contact_points(p)))
          .tolerance >= firm.tolerance - near;
  return is_firm ? level : 0;
}

}  // namespace

TEST_CASE("teams of robots with a size are swapped until they hold, and never collide",
          "[stands][swaps][slow]") {
  std::size_t held = 0, compared = 0;
  for (const std::string& name : corpus::polygon_names()) {
    Document document = sample(name, static_cast<int>(held % 4));
    if (document.vertices.size() > 60) continue;
    document.settings.goal = Goal::hold;
    document.settings.teams = 2 + compared % 2;
    INFO(name << ", " << *document.settings.teams << " teams");
    const auto placed = place(document);
    if (!placed || placed->teams.empty()) continue;
    const Placement& p = *placed;
    check_standing(p);
    const auto keys = [&](const std::vector<std::uint32_t>& taken) {
      return hold_keys(p.object, p.centre_of_mass, p.candidates, taken, hold_requirements(p),
                       p.stands.get());
    };
    const auto start = select_teams(p.object, p.centre_of_mass, p.candidates, Metric::area,
                                    p.requested_teams, FirstTeam::even, p.stands.get());
    const HoldKeys reached = keys(p.team_candidates);
    CHECK(reached.level == level_of(p));
    CHECK(reached.coverage == Approx(p.coverage).margin(1e-9));
    CHECK_FALSE(better_by(keys(start), reached));
    held += p.closure.form_closure ? 1u : 0u;
    ++compared;
    if (p.candidates.size() > 40) continue;
    for (std::size_t team = 0; team < p.team_candidates.size(); ++team) {
      for (std::uint32_t candidate = 0; candidate < p.candidates.size(); ++candidate) {
        std::vector<std::uint32_t> other = p.team_candidates;
        if (std::find(other.begin(), other.end(), candidate) != other.end()) continue;
        if (!has_room(p, other, team, candidate)) continue;
        other[team] = candidate;
        CHECK_FALSE(better_by(keys(other), reached));
      }
    }
  }
  CHECK(held > 50);
  CHECK(compared > 90);
}

TEST_CASE("as robots shrink the placement becomes that of points", "[stands]") {
  int compared = 0, same = 0;
  for (const std::string& name : corpus::polygon_names()) {
    Document document = corpus::polygon(name);
    if (document.vertices.size() > 200) continue;
    const auto points = place(document);
    REQUIRE(points.ok());
    document.settings.robot.radius = 1e-7 * points->polygon().diagonal();
    const auto robots = place(document);
    REQUIRE(robots.ok());
    INFO(name);
    ++compared;
    // Other candidates may win ties, as in symmetric shapes. Robots keep 1/1000 of an edge from its
    // ends.
    same += std::fabs(robots->coverage - points->coverage) < 5e-3 ? 1 : 0;
  }
  CHECK(compared > 60);
  CHECK(same >= compared * 9 / 10);
}

TEST_CASE("a robot whose size is taken away again is a point, bit for bit", "[stands]") {
  const Document document = corpus::polygon("boomerang");
  Document none = document;
  for (const char* size : {"r=30,reach=5,gap=2", "r=0,reach=0,depth=0,width=0,gap=0"})
    REQUIRE_FALSE(read_setting(Setting::robot, size, none));
  const auto a = place(document), b = place(none);
  REQUIRE(a.ok());
  REQUIRE(b.ok());
  CHECK_FALSE(b->stands);
  CHECK(placement_json(*a, true) == placement_json(*b, true));
}

TEST_CASE("a diagonal between opposite corners stays, as near to them as hands can be",
          "[stands]") {
  Document document;
  document.vertices = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  document.settings.teams = std::nullopt;
  document.settings.robot = {0.01, 0, 0, 0.1, 0};
  const auto placed = place(document);
  REQUIRE(placed.ok());
  // Two through the middles of sides; for each diagonal, one near it on either pair of sides.
  CHECK(placed->candidates.size() == 6);
  document.settings.teams = 2;
  CHECK(place(document)->coverage > 0.85);
}

TEST_CASE("the best chord of cut edges is as good as any that is sampled", "[stands]") {
  Rng rng(3);
  int checked = 0;
  for (std::uint64_t number = 0; number < 60; ++number) {
    const auto vertices =
        generate(number % 2 ? Family::random : Family::convex, 6 + number % 12, number);
    if (!vertices) continue;
    const auto polygon = Polygon::create(*vertices);
    REQUIRE(polygon.ok());
    const double diagonal = polygon->diagonal();
    const Stands stands(
        solid(*polygon),
        {0.03 * diagonal, 0, 0.01 * diagonal * static_cast<double>(number % 3), 0.02 * diagonal, 0},
        {});
    if (!stands.any()) continue;
    const Vec2 centre = polygon->centroid();
    const auto found = standing_candidates(*polygon, centre, 0.5, stands);
    REQUIRE(found.ok());
    for (std::uint32_t a = 0; a < polygon->size(); ++a) {
      for (std::uint32_t b = 0; b < polygon->size(); ++b) {
        // From places on one edge through C, with both ends usable.
        double best = 0;
        for (int k = 0; k < 200; ++k) {
          const double size = length(polygon->edge_end(a) - polygon->edge_start(a));
          const Vec2 along = (polygon->edge_end(a) - polygon->edge_start(a)) / size;
          const double t = (k + 0.5) / 200 * size;
          if (stands.why_not(a, t)) continue;
          const LiftingPoint p = stands.lifting_point({polygon->edge_start(a) + t * along, a});
          const Vec2 start = stands.lifting_point({polygon->edge_start(b), b}).position;
          const Vec2 line = polygon->edge_end(b) - polygon->edge_start(b);
          const Vec2 away = centre - p.position;
          const double turn = cross(away, line);
          if (turn == 0) continue;
          const double factor = cross(start - centre, line) / turn;
          if (!(factor > 0)) continue;
          const LiftingPoint other{centre + factor * away, b};
          if (length(other.position - start -
                     line * dot(other.position - start, line) / dot(line, line)) > 1e-9 * diagonal)
            continue;
          const double u = dot(other.position - start, line) / length(line);
          if (u < 0 || u > length(line) || stands.why_not(b, u) || stands.collide(p, other))
            continue;
          best = std::max(best, std::min(factor, 1 / factor));
        }
        if (best < 0.5) continue;
        double offered = 0;
        for (const Candidate& candidate : found->candidates) {
          const auto &r1 = candidate.chord.r1, &r2 = candidate.chord.r2;
          if ((r1.edge == a && r2.edge == b) || (r1.edge == b && r2.edge == a))
            offered = std::max(offered, candidate.chord.ratio);
        }
        ++checked;
        INFO("polygon " << number << ", edges " << a << " and " << b);
        CHECK(offered >= best - 1e-6);
      }
    }
  }
  CHECK(checked > 300);
}

TEST_CASE("lines face each other as a look at every two of them says", "[stands]") {
  Rng rng(11);
  for (int round = 0; round < 40; ++round) {
    std::vector<StandLine> lines;
    for (std::uint32_t i = 0; i < 30; ++i) {
      const double x = rng.uniform(), y = rng.uniform(), u = rng.uniform(), v = rng.uniform();
      StandLine line;
      line.edge = i;
      line.start = Vec2(2 * x - 1, 2 * y - 1);
      const Vec2 to = Vec2(2 * u - 1, 2 * v - 1) - line.start;
      line.high = length(to);
      line.along = to / line.high;
      line.height = cross(line.start, line.along);
      lines.push_back(line);
    }
    std::vector<std::vector<int>> seen(30, std::vector<int>(30, 0));
    for_each_facing(lines, 1e-9, [&](std::uint32_t i, std::uint32_t j) {
      ++seen[std::min(i, j)][std::max(i, j)];
      return true;
    });
    // A line and another's mirror image are seen in a common direction.
    for (std::uint32_t i = 0; i < 30; ++i)
      for (std::uint32_t j = i + 1; j < 30; ++j) {
        bool facing = false;
        const auto within = [](const StandLine& line, const Vec2& u) {
          return cross(line.at(line.low), u) * line.height > 0 &&
                 cross(u, line.at(line.high)) * line.height > 0;
        };
        for (const double t : {1e-9, 1 - 1e-9}) {
          facing = facing || within(lines[j], -lines[i].at(t * lines[i].high));
          facing = facing || within(lines[i], -lines[j].at(t * lines[j].high));
        }
        CHECK(seen[i][j] == (facing ? 1 : 0));
      }
  }
}

TEST_CASE("even chords of robots with a size are their even candidates", "[stands]") {
  Rng rng(17);
  for (const char* name : {"boomerang", "grand-piano", "triangle"}) {
    for (int size = 0; size < 4; ++size) {
      const Document document = sample(name, size);
      const auto polygon = Polygon::create(document.vertices);
      const Stands stands(solid(*polygon), document.settings.robot, {});
      if (!stands.any()) continue;
      const EvenChords chords(*polygon, &stands);
      const Box box = bounding_box(document.vertices);
      for (int k = 0; k < 50; ++k) {
        const double u = rng.uniform(), v = rng.uniform();
        const Vec2 centre = box.low + Vec2(u * box.size().x, v * box.size().y);
        const auto expected = standing_candidates(*polygon, centre, 1, stands);
        REQUIRE(expected.ok());
        const auto found = chords.about(centre);
        INFO(name << " size " << size << " centre " << k);
        REQUIRE(found.size() == expected->candidates.size());
        for (std::size_t i = 0; i < found.size(); ++i)
          CHECK(length(found[i].chord.r1.position - expected->candidates[i].chord.r1.position) <=
                2 * near_distance(polygon->diameter()));
      }
    }
  }
}

TEST_CASE("balanced robots with a size stand where they can, and C stays their centroid",
          "[stands][thorough]") {
  int placed_sets = 0;
  for (const char* name : {"boomerang", "grand-piano", "triangle", "square"}) {
    for (int size = 0; size < 4; ++size) {
      for (const std::uint32_t robots : {3u, 5u, 6u}) {
        Document document = sample(name, size, Method::balanced);
        document.settings.robots = robots;
        const auto placed = place(document);
        REQUIRE(placed.ok());
        INFO(name << " size " << size << " robots " << robots);
        if (placed->teams.empty()) continue;
        ++placed_sets;
        check_standing(*placed);
        Vec2 sum;
        for (const LiftingPoint& point : lifting_points(placed->teams)) sum += point.position;
        CHECK(length(sum / robots - placed->centre_of_mass) <= 1e-9 * placed->polygon().diagonal());
      }
    }
  }
  CHECK(placed_sets > 30);
}

TEST_CASE("more teams of robots with a size than can be swapped are refused",
          "[stands][swaps][errors]") {
  Document document = corpus::polygon("labyrinth");
  document.settings.goal = Goal::hold;
  document.settings.min_ratio = 0;
  document.settings.teams = std::nullopt;
  REQUIRE(place(document).ok());  // all candidates are taken
  document.settings.robot.gap = 1;
  const auto placed = place(document);
  REQUIRE_FALSE(placed.ok());
  CHECK(placed.error().place.option == "goal");
  CHECK(placed.error().message.find("at most 32 teams can be swapped") == 0);
}

TEST_CASE("distributed and random refuse robots with a size", "[stands][errors]") {
  Document document = corpus::polygon("boomerang");
  document.settings.robot.radius = 0.1;
  for (const Method method : {Method::distributed, Method::random}) {
    document.settings.method = method;
    const auto placed = place(document);
    REQUIRE_FALSE(placed.ok());
    CHECK(placed.error().place.option == "robot");
  }
}

TEST_CASE("a trace of robots with a size tells the same teams", "[stands][trace]") {
  for (const char* name : {"boomerang", "grand-piano"}) {
    for (int size = 0; size < 4; ++size) {
      const auto placed = place(sample(name, size));
      REQUIRE(placed.ok());
      const auto trace = make_trace(*placed);
      REQUIRE(trace.ok());
      CHECK(trace->source_of_candidate.size() == placed->candidates.size());
      CHECK(trace->count(StepKind::duplicates) == 0);
      for (std::uint32_t k = 0; k < trace->size(); ++k)
        for (const Number& number : numbers(*trace, look_at(*trace, k)))
          CHECK(std::fabs(number.value) < 1e9);
      for (std::uint32_t team = 0; team < placed->teams.size(); ++team) {
        INFO(name << " size " << size << " team " << team);
        const TeamScores scores = look_at_scores(*trace, team);
        CHECK(scores.ranking.front() == placed->team_candidates[team]);
      }
    }
  }
}
