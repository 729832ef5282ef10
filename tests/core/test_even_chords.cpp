#include <cmath>
#include <string>

#include "candidates/pair_candidate.h"
#include "evenlift/generate.h"
#include "evenlift/plane.h"
#include "evenlift/random.h"
#include "evenlift/tolerance.h"
#include "kit/catch.h"
#include "kit/corpus.h"
#include "kit/polygons.h"
#include "shapes/problem_document.h"
#include "shapes/small_polygons.h"

using namespace evenlift;

namespace {

// Of equal chords either may stay. An end at a vertex or where edges nearly coincide may name
// either edge.
bool same(const Polygon& polygon, const LiftingPoint& a, const LiftingPoint& b) {
  const auto lies_on = [&](std::uint32_t edge) {
    const Vec2 nearest =
        nearest_on_segment(polygon.edge_start(edge), polygon.edge_end(edge), a.position);
    return length(nearest - a.position) <= near_distance(polygon.diameter());
  };
  return a.position == b.position && (a.edge == b.edge || (lies_on(a.edge) && lies_on(b.edge)));
}

bool same(const Polygon& polygon, const Candidate& a, const Candidate& b) {
  return same(polygon, a.chord.r1, b.chord.r1) && same(polygon, a.chord.r2, b.chord.r2) &&
         std::fabs(a.length - b.length) <= 1e-15 * b.length &&
         std::fabs(a.chord.ratio - b.chord.ratio) <= 1e-15 && a.kind == b.kind &&
         a.between_vertices == b.between_vertices && directions_agree(a.direction, b.direction);
}

// The first difference between the two computations; empty if they agree.
std::string difference(const Polygon& polygon, const EvenChords& chords, const Vec2& centre) {
  const auto expected = find_candidates(polygon, centre, 1);
  if (!expected) return {};
  const auto found = chords.about(centre);
  if (found.size() != expected->size())
    return std::to_string(found.size()) + " in place of " + std::to_string(expected->size());
  for (std::size_t i = 0; i < found.size(); ++i)
    if (!same(polygon, found[i], (*expected)[i])) return "candidate " + std::to_string(i);
  return {};
}

// Often hard: any place, a vertex, the midpoint of two vertices or of two points of the outline.
Vec2 any_centre(const Polygon& polygon, Rng& rng) {
  const auto vertex = [&] { return polygon.vertex(rng.below(polygon.size())); };
  const auto on_outline = [&]() -> Vec2 {
    const std::size_t edge = rng.below(polygon.size());
    const double part = rng.uniform();
    return polygon.edge_start(edge) + part * (polygon.edge_end(edge) - polygon.edge_start(edge));
  };
  const std::uint64_t kind = rng.below(8);
  if (kind == 0) return polygon.centroid();
  if (kind == 1) return vertex();
  const Vec2 a = kind < 4 ? vertex() : on_outline();
  const Vec2 b = kind % 2 == 0 ? vertex() : on_outline();
  return 0.5 * (a + b);
}

void check(const Polygon& polygon, Rng& rng, int centres) {
  const EvenChords chords(polygon);
  for (int i = 0; i < centres; ++i) {
    const Vec2 centre = any_centre(polygon, rng);
    INFO("centre " << centre.x << ", " << centre.y);
    CHECK(difference(polygon, chords, centre) == "");
    const std::size_t number = chords.count_about(centre, 1'000'000);
    CHECK(number >= chords.about(centre).size());
    CHECK(chords.count_about(centre, number / 2) == number / 2);
  }
}

}  // namespace

TEST_CASE("the outline meets its mirror image at the even candidates", "[even_chords][slow]") {
  Rng rng(11);
  for (const std::string& name : corpus::polygon_names()) {
    INFO(name);
    check(testing::polygon(corpus::polygon(name).vertices), rng, 40);
  }
}

TEST_CASE("hard little shapes have the same even candidates either way", "[even_chords][slow]") {
  Rng rng(12);
  for (std::uint64_t number = 0; number < 900; ++number) {
    INFO("case " << number);
    const auto polygon =
        Polygon::create(testing::document_of(small_polygons::make_case(number).problem).vertices);
    if (polygon) check(*polygon, rng, 12);
  }
}

TEST_CASE("long outlines have the same even candidates either way", "[even_chords][slow]") {
  Rng rng(13);
  for (const Family family : {Family::star, Family::comb, Family::spiral, Family::random})
    check(testing::polygon(*generate(family, 2000, 5)), rng, 6);
}
