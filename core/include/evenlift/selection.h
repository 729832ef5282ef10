// The choice of chords for the teams (algorithm.md, Selection; thesis 3.3, 4.2, 5.2).
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "evenlift/candidates.h"
#include "evenlift/document.h"
#include "evenlift/polygon_with_holes.h"
#include "evenlift/stands.h"

namespace evenlift {

// `even`: the first team takes the longest even candidate or, if none is even, the one with the
// largest ratio. `longest`: the first team takes the longest of all candidates; this is the rule
// for positions anywhere in the range.
enum class FirstTeam : std::uint8_t { even, longest };

// The rule for the first team with these positions. O(1).
constexpr FirstTeam first_team(Positions positions) {
  return positions == Positions::range ? FirstTeam::longest : FirstTeam::even;
}

// The keys that decide, in this order, which candidate a team takes (algorithm.md, Selection).
enum class Rule : std::uint8_t {
  longest_even,  // first team: length, ratio, order
  most_even,     // first team if no candidate is even: ratio, length, order
  score,         // further teams: score, ratio, length, order
  longest,       // first team with positions anywhere in the range: length, ratio, order
};

// Chooses teams greedily. Returns indices into `candidates` in the order of choice: `teams` of
// them, or fewer if no candidates are left. Geometry decides every tie, so the same shape gets the
// same teams. With `stands`, candidates that collide with an earlier team are skipped. The
// evaluation is lazy (M. Minoux, Accelerated greedy algorithms for maximizing submodular set
// functions, 1978). A team that widens H costs O(n + K), plus O(n) for each evaluated end. An end
// is evaluated if its upper bound could win and the edge of H in front of it is new. Once no
// candidate widens H, all further teams together cost O(K log K).
std::vector<std::uint32_t> select_teams(const PolygonWithHoles& object, const Vec2& centre,
                                        const std::vector<Candidate>& candidates, Metric metric,
                                        std::size_t teams, FirstTeam first = FirstTeam::even,
                                        const Stands* stands = nullptr);

// Returns for each candidate the score by which select_teams() chooses the next team after the
// `selected` teams. There must be at least one selected team. Scores are in squared units of length
// for the metrics `area` and `circle`, and in units of length for `distance`. Use this only for
// explanations. O(K n).
std::vector<double> scores(const PolygonWithHoles& object, const Vec2& centre,
                           const std::vector<Candidate>& candidates,
                           const std::vector<std::uint32_t>& selected, Metric metric);

// The total angle, in radians, of the directions in [0, pi) whose line through C meets the boundary
// on both sides of C. Radial edges do not count as boundary. O(n log n).
double open_directions_rad(const Polygon& polygon, const Vec2& centre);

// Chooses `teams` chords at equal angles (thesis 5.2). There are no chords if open_directions_rad()
// is 0 within tolerance, as when C is within tolerance of an edge of a convex polygon.
// O(n log n + teams n).
std::vector<Chord> distributed_teams(const Polygon& polygon, const Vec2& centre, std::size_t teams);

// Chooses teams at random (thesis 5.2). The same seed gives the same teams on every platform. There
// are fewer teams if 100,000 draws in a row find no chord. Expected O(n) for each draw.
std::vector<Chord> random_teams(const Polygon& polygon, const Vec2& centre, std::size_t teams,
                                std::uint64_t seed);

}  // namespace evenlift
