// Which chords the teams take (algorithm.md, Selection; thesis 3.3, 4.2, 5.2).
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "evenlift/candidates.h"
#include "evenlift/document.h"

namespace evenlift {

// Indices into `candidates` in the order selected: at most `teams` of them, fewer only if there are
// fewer candidates. `metric` is area, circle or distance. Every tie is decided by geometry: the
// same shape gives the same teams. O(n) per examined end point, of which each further team examines
// only those whose edge of H changed and whose upper bound can still win, plus O(K) per team that
// grows H; teams after H is saturated cost O(K log K) together.
std::vector<std::uint32_t> select_teams(const Polygon& polygon, const Vec2& centre,
                                        const std::vector<Candidate>& candidates, Method metric,
                                        std::size_t teams);

// The score of every candidate against the lifting base of the teams selected so far (at least
// one): what select_teams maximises; area and circle in squared units of length, distance in units
// of length. For explanations, not for speed: O(K n).
std::vector<double> scores(const Polygon& polygon, const Vec2& centre,
                           const std::vector<Candidate>& candidates,
                           const std::vector<std::uint32_t>& selected, Method metric);

// How much of the half turn the lines through C have that meet the boundary on both sides of it,
// but for lines along radial edges: in [0, pi]. O(n log n).
double open_directions_rad(const Polygon& polygon, const Vec2& centre);

// Teams at equal angles (thesis 5.2): `teams` chords, or none where no line through C but along
// radial edges meets the boundary on both sides (C within tolerance of an edge of a convex
// polygon). O(n log n + teams n).
std::vector<Chord> distributed_teams(const Polygon& polygon, const Vec2& centre, std::size_t teams);

// Teams at random (thesis 5.2), the same for the same seed on every platform. Expected O(n) per
// draw; a polygon on which fewer than one draw in 10^5 finds a partner yields fewer teams.
std::vector<Chord> random_teams(const Polygon& polygon, const Vec2& centre, std::size_t teams,
                                std::uint64_t seed);

}  // namespace evenlift
