#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "evenlift/generate.h"
#include "evenlift/output/json.h"
#include "evenlift/output/trace_words.h"
#include "evenlift/placed_robots.h"
#include "evenlift/placement.h"
#include "evenlift/swaps.h"
#include "evenlift/tolerance.h"
#include "evenlift/trace.h"
#include "kit/catch.h"
#include "kit/corpus.h"
#include "kit/solid.h"

using namespace evenlift;

namespace {

// In units of L; only the last two have depth.
RobotSize size_number(std::uint64_t number, double diagonal) {
  const double d = diagonal;
  switch (number % 5) {
    case 0:
      return {0.03 * d, 0, 0, 0, 0};
    case 1:
      return {0.02 * d, 0.02 * d, 0, 0.02 * d, 0.01 * d};
    case 2:
      return {0.01 * d, 0, 0, 0, 0.03 * d};
    case 3:
      return {0.02 * d, 0.01 * d, 0.02 * d, 0.01 * d, 0};
    default:
      return {0, 0, 0.03 * d, 0, 0};
  }
}

struct Prepared {
  Polygon polygon;
  Stands stands;
};

// Of every family, where robots of some size can stand.
std::vector<Prepared> prepared_objects() {
  std::vector<Prepared> objects;
  for (std::uint64_t number = 0; number < 80; ++number) {
    const auto vertices =
        generate(number % 2 ? Family::random : Family::convex, 5 + number % 14, number);
    if (!vertices) continue;
    auto polygon = Polygon::create(*vertices);
    REQUIRE(polygon.ok());
    std::vector<EdgePart> no_go;
    if (number % 3 == 0) no_go.push_back({static_cast<std::uint32_t>(number % 5), 0.4, 0.55});
    Stands stands(solid(*polygon), size_number(number, polygon->diagonal()), no_go);
    if (stands.any()) objects.push_back({*std::move(polygon), std::move(stands)});
  }
  return objects;
}

Document sized(const std::string& name, const RobotSize& parts, Positions positions) {
  Document document = corpus::polygon(name);
  const double d = Polygon::create(document.vertices)->diagonal();
  document.settings.robot = {parts.radius * d, parts.reach * d, parts.depth * d, parts.width * d,
                             parts.gap * d};
  document.settings.positions = positions;
  return document;
}

// Across C on an edge's line of lifting points; nothing if that is not beyond C.
std::optional<LiftingPoint> across(const Prepared& object, const Vec2& centre, const Vec2& from,
                                   std::uint32_t edge) {
  const Vec2 start = object.stands.lifting_point({object.polygon.edge_start(edge), edge}).position;
  const Vec2 line = object.polygon.edge_end(edge) - object.polygon.edge_start(edge);
  const double turn = cross(centre - from, line);
  if (turn == 0) return std::nullopt;
  const double factor = cross(start - centre, line) / turn;
  if (!(factor > 0)) return std::nullopt;
  return LiftingPoint{centre + factor * (centre - from), edge};
}

bool same_place(const Chord& a, const Chord& b, double near) {
  const auto apart = [](const LiftingPoint& p, const LiftingPoint& q) {
    return length(p.position - q.position);
  };
  return (apart(a.r1, b.r1) <= near && apart(a.r2, b.r2) <= near) ||
         (apart(a.r1, b.r2) <= near && apart(a.r2, b.r1) <= near);
}

}  // namespace

TEST_CASE("ranges of robots with a size are where both can stand and share evenly enough",
          "[stands][ranges]") {
  int inside = 0, outside = 0;
  constexpr double min_ratio = 0.6;
  for (const Prepared& object : prepared_objects()) {
    const Vec2 centre = object.polygon.centroid();
    const double slack = 1e-6 * object.polygon.diagonal();
    const auto n = static_cast<std::uint32_t>(object.polygon.size());
    for (std::uint32_t a = 0; a < n; ++a) {
      const double size = length(object.polygon.edge_end(a) - object.polygon.edge_start(a));
      const Vec2 along = (object.polygon.edge_end(a) - object.polygon.edge_start(a)) / size;
      for (std::uint32_t b = 0; b < n; ++b) {
        if (a == b) continue;
        const auto ranges = standing_ranges(object.polygon, centre, a, b, min_ratio, object.stands);
        for (int k = 0; k < 60; ++k) {
          const double t = (k + 0.5) / 60 * size;
          const LiftingPoint p =
              object.stands.lifting_point({object.polygon.edge_start(a) + t * along, a});
          const auto other = across(object, centre, p.position, b);
          const double arm = length(p.position - centre);
          const double ratio = other ? std::min(arm / length(other->position - centre),
                                                length(other->position - centre) / arm)
                                     : 0;
          // Either answer is accepted near an end of the usable part or the ratio.
          const auto usable = [&](std::uint32_t edge, double at) {
            return !object.stands.why_not(edge, at - slack) &&
                   !object.stands.why_not(edge, at + slack);
          };
          const auto unusable = [&](std::uint32_t edge, double at) {
            return object.stands.why_not(edge, at - slack) &&
                   object.stands.why_not(edge, at + slack);
          };
          const double u = other ? object.stands.along(*other) : 0;
          const double length_b = length(object.polygon.edge_end(b) - object.polygon.edge_start(b));
          const bool on_b = other && u > slack && u < length_b - slack;
          const bool off_b = !other || u < -slack || u > length_b + slack;
          const bool surely = on_b && ratio > min_ratio + 1e-6 && usable(a, t) && usable(b, u);
          const bool never =
              off_b || ratio < min_ratio - 1e-6 || unusable(a, t) || (on_b && unusable(b, u));
          const Vec2 offset = p.position - centre;
          const bool is_in = std::any_of(ranges.begin(), ranges.end(), [&](const PairRange& r) {
            const Vec2 way = r.a1 - r.a0;
            const double x = dot(offset - r.a0, along) / dot(way, along);
            return dot(way, along) > 0 && x >= 0 && x <= 1;
          });
          if (surely) CHECK(is_in);
          if (never) CHECK_FALSE(is_in);
          inside += surely && is_in;
          outside += never && !is_in;
        }
      }
    }
  }
  CHECK(inside > 3000);
  CHECK(outside > 3000);
}

TEST_CASE("each range of robots with a size offers two candidates a sixteenth from its ends",
          "[stands][ranges]") {
  int found = 0, colliding = 0;
  constexpr double min_ratio = 0.6;
  for (const Prepared& object : prepared_objects()) {
    const Vec2 centre = object.polygon.centroid();
    const double near = near_distance(object.polygon.diameter());
    const auto offered =
        standing_candidates(object.polygon, centre, min_ratio, object.stands, Positions::range);
    const auto best = standing_candidates(object.polygon, centre, min_ratio, object.stands);
    REQUIRE(offered.ok());
    REQUIRE(best.ok());
    const auto is_offered = [&](const Chord& chord) {
      return std::any_of(offered->candidates.begin(), offered->candidates.end(),
                         [&](const Candidate& c) { return same_place(c.chord, chord, 4 * near); });
    };
    // Chords at the best positions are also in the ranges.
    for (const Candidate& candidate : best->candidates) CHECK(is_offered(candidate.chord));
    for (const Candidate& candidate : offered->candidates) {
      CHECK(object.stands.can_lift(candidate.chord.r1));
      CHECK(object.stands.can_lift(candidate.chord.r2));
      CHECK_FALSE(object.stands.collide(candidate.chord.r1, candidate.chord.r2));
      CHECK(candidate.chord.ratio >= min_ratio - 1.001e-9);
    }
    const auto n = static_cast<std::uint32_t>(object.polygon.size());
    for (std::uint32_t a = 0; a < n; ++a) {
      for (std::uint32_t b = a + 1; b < n; ++b) {
        const auto ranges = standing_ranges(object.polygon, centre, a, b, min_ratio, object.stands);
        if (ranges.empty()) continue;
        // By the lengths along both edges, looking at the ends independently.
        std::size_t longest = 0;
        std::vector<double> ways;
        for (const PairRange& range : ranges) {
          const Chord first = chord_at(centre, range, 0), last = chord_at(centre, range, 1);
          const auto on = [&](const Chord& chord, std::uint32_t edge) {
            return chord.r1.edge == edge ? chord.r1.position : chord.r2.position;
          };
          ways.push_back(length(on(first, a) - on(last, a)) + length(on(first, b) - on(last, b)));
          if (ways.back() > ways[longest] + near) longest = ways.size() - 1;
        }
        CHECK(longest_range(ranges, near) == longest);
        if (ways[longest] < 1e-3 * object.polygon.diagonal()) continue;
        for (const double s : range_places) {
          const Chord chord = chord_at(centre, ranges[longest], place_at(ranges[longest], s));
          if (object.stands.collide(chord.r1, chord.r2)) {
            ++colliding;
            continue;
          }
          INFO("edges " << a << " and " << b);
          CHECK(is_offered(chord));
          ++found;
        }
      }
    }
  }
  CHECK(found > 400);
  CHECK(colliding > 0);
}

TEST_CASE("of ranges of two edges that are equally long within tolerance the first is the longest",
          "[stands][ranges]") {
  const auto up_to = [](double y) {
    PairRange range;
    range.a0 = {1, 0};
    range.a1 = {1, y};
    return range;  // 2 y long from end to end, on both edges together
  };
  CHECK(longest_range({up_to(1), up_to(1 + 1.5e-10)}, 1e-9) == 0);
  CHECK(longest_range({up_to(1), up_to(1 + 1.5e-9)}, 1e-9) == 1);
}

TEST_CASE("robots with a size have the ranges that miss the minimum ratio by less than tolerance",
          "[stands][ranges]") {
  // C is 4 from the lower side, 5 from the upper.
  const auto polygon = Polygon::create({{0, 0}, {10, 0}, {10, 9}, {0, 9}});
  REQUIRE(polygon.ok());
  const Stands stands(solid(*polygon), {1, 0, 0, 0, 0}, {});
  const auto number = [&](double min_ratio) {
    const auto found = standing_candidates(*polygon, {5, 4}, min_ratio, stands, Positions::range);
    REQUIRE(found.ok());
    return found->candidates.size();
  };
  CHECK(number(0.8) == 12);
  CHECK(number(0.8 + 5e-10) == 12);
  CHECK(number(0.8 + 2e-9) == 9);
}

TEST_CASE("teams of robots with a size anywhere in their ranges stand and never collide",
          "[stands][ranges][slow]") {
  int better = 0, worse = 0, held = 0, held_before = 0, fuller = 0;
  for (const std::string& name : corpus::polygon_names()) {
    if (corpus::polygon(name).vertices.size() > 60) continue;
    for (const RobotSize& parts :
         {RobotSize{0.03, 0, 0, 0, 0}, RobotSize{0.02, 0.01, 0.02, 0.01, 0}}) {
      for (const Goal goal : {Goal::cover, Goal::hold}) {
        Document best = sized(name, parts, Positions::best);
        best.settings.goal = goal;
        Document ranges = sized(name, parts, Positions::range);
        ranges.settings.goal = goal;
        INFO(name << ", radius " << parts.radius << ", goal " << evenlift::name(goal));
        const auto a = place(best), b = place(ranges);
        REQUIRE(a.ok() == b.ok());
        if (!a) continue;
        CHECK(b->candidates.size() >= a->candidates.size());
        const std::vector<LiftingPoint> robots = lifting_points(b->teams);
        CHECK_FALSE(b->stands->any_collide(robots));
        for (const LiftingPoint& robot : robots) CHECK(b->stands->can_lift(robot));
        for (const Team& team : b->teams) CHECK(team.ratio >= 0.8 - 1.001e-9);
        fuller += b->teams.size() > a->teams.size();
        if (goal == Goal::hold) {
          held += b->closure.form_closure;
          held_before += a->closure.form_closure;
          continue;
        }
        better += b->coverage > a->coverage + 1e-9;
        worse += b->coverage < a->coverage - 1e-9;
      }
    }
  }
  CHECK(better > worse);
  CHECK(held >= held_before);
  CHECK(fuller > 0);
}

TEST_CASE("as robots in their ranges shrink the placement becomes that of points",
          "[stands][ranges][slow]") {
  int compared = 0, same = 0;
  for (const std::string& name : corpus::polygon_names()) {
    Document document = corpus::polygon(name);
    if (document.vertices.size() > 200) continue;
    document.settings.positions = Positions::range;
    for (const Goal goal : {Goal::cover, Goal::hold}) {
      document.settings.goal = goal;
      document.settings.robot = RobotSize{};
      const auto points = place(document);
      if (!points) continue;
      document.settings.robot.radius = 1e-7 * points->polygon().diagonal();
      const auto robots = place(document);
      REQUIRE(robots.ok());
      INFO(name);
      ++compared;
      // Other candidates may win ties, as in symmetric shapes. Robots keep 1/1000 of an edge from its
      // ends.
      same += std::fabs(robots->coverage - points->coverage) < 5e-3;
    }
  }
  CHECK(compared > 120);
  CHECK(same >= compared * 85 / 100);
}

TEST_CASE("a marked edge leaves the range candidates of all others as they are",
          "[stands][ranges]") {
  int compared = 0;
  for (const char* name : {"boomerang", "grand-piano", "guitar", "thesis-sample-centroid"}) {
    Document document = corpus::polygon(name);
    document.settings.positions = Positions::range;
    const auto free = place(document);
    REQUIRE(free.ok());
    const double near = near_distance(free->polygon().diameter());
    document.settings.no_go = {{2, 0, 1}};
    const auto marked = place(document);
    REQUIRE(marked.ok());
    for (const Candidate& candidate : free->candidates) {
      const Chord& chord = candidate.chord;
      if (!marked->stands->can_lift(chord.r1) || !marked->stands->can_lift(chord.r2)) continue;
      const auto has = [&](const Candidate& other) {
        return same_place(other.chord, chord, 4 * near);
      };
      INFO(name << ", ratio " << chord.ratio);
      CHECK(std::any_of(marked->candidates.begin(), marked->candidates.end(), has));
      ++compared;
    }
  }
  CHECK(compared > 50);
}

TEST_CASE("the steps of ranges tell robots with a size where they can stand",
          "[stands][ranges][trace]") {
  std::uint32_t ranges = 0;
  for (const char* name : {"boomerang", "grand-piano", "guitar", "square"}) {
    for (const RobotSize& parts : {RobotSize{0.03, 0, 0, 0, 0}, RobotSize{0.02, 0, 0.02, 0, 0},
                                   RobotSize{0.05, 0, 0, 0.1, 0.3}}) {
      Document document = sized(name, parts, Positions::range);
      document.settings.goal = Goal::hold;
      const auto placed = place(document);
      REQUIRE(placed.ok());
      const auto trace = make_trace(*placed);
      REQUIRE(trace.ok());
      for (std::uint32_t i = 0; i < trace->count(StepKind::range); ++i) {
        const StepDetail detail = look_at(*trace, *trace->find(StepKind::range, i));
        for (const Chord& end : detail.range->ends) {
          CHECK(placed->stands->can_lift(end.r1));
          CHECK(placed->stands->can_lift(end.r2));
        }
        for (const std::uint32_t candidate : detail.range->candidates)
          CHECK((candidate == no_index || candidate < placed->candidates.size()));
        CHECK(caption(*trace, detail).find("robots of this size can stand") != std::string::npos);
        CHECK_FALSE(figures(*trace, detail).empty());
        ++ranges;
      }
      for (std::uint32_t k = 0; k < trace->size(); ++k)
        CHECK_FALSE(caption(*trace, look_at(*trace, k)).empty());
    }
  }
  CHECK(ranges > 20);
}

TEST_CASE("what a pair is said to offer to robots with a size is its best chord",
          "[stands][trace]") {
  // Both no-go parts end on one chord of ratio 0.6, before the even one by slope.
  const auto polygon = Polygon::create({{-3, -1}, {3, -1}, {3, 1}, {-3, 2}});
  REQUIRE(polygon.ok());
  const Vec2 centre(0, 0);
  const Stands stands(solid(*polygon), {0.1, 0, 0, 0, 0}, {{0, 0.6, 1}, {2, 2.0 / 3, 1}});
  const auto found = standing_candidates(*polygon, centre, 0.5, stands);
  REQUIRE(found.ok());
  const auto uneven =
      std::count_if(found->candidates.begin(), found->candidates.end(),
                    [](const Candidate& c) { return std::fabs(c.chord.ratio - 0.6) < 1e-9; });
  CHECK(uneven == 1);
  const auto pairs = edge_pairs(*polygon, centre);
  REQUIRE(pairs.ok());
  int checked = 0;
  for (std::uint32_t i = 0; i < pairs->size(); ++i) {
    if ((*pairs)[i].a + (*pairs)[i].b != 2 || (*pairs)[i].a == 1) continue;
    REQUIRE(found->of_source[i] != no_index);
    CHECK(found->candidates[found->of_source[i]].chord.ratio == Approx(1).epsilon(1e-6));
    ++checked;
  }
  CHECK(checked == 1);
}
