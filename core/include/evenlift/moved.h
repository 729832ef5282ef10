// Robots that the user moves by hand from where the method places them. A balanced robot moves
// along the outline, and two others follow so that C stays the centroid of all. A team that may
// stand anywhere in its range moves along that range. Positions are stored as points of edges, as
// fractions of the edge's length with twelve decimals, so that links stay short.
#pragma once

#include <cstddef>
#include <optional>

#include "evenlift/placement.h"
#include "evenlift/result.h"

namespace evenlift {

// Whether the teams of a placement can be moved along their ranges: the method chooses among
// candidates, its teams may stand anywhere in their ranges, and the search has ended. O(1).
bool can_move_teams(const Placement& placement);

// The new positions if this robot moves to a point of the outline and its two neighbours follow
// (move_robot() of balanced.h). Nothing if they cannot, or if there are fewer than three balanced
// robots. O(n log n).
std::optional<Moved> moved_along_outline(const Placement& placement, std::size_t robot,
                                         const LiftingPoint& to);

// The new positions if this robot moves until C sees it in the direction of a point, or as near to
// that direction as it can get, while its partner stays across C. The team moves along the range of
// its two edges and, at a vertex, along that of the next edge. It stops where its chord would fall
// below the minimum ratio or would jump. Nothing if the team does not move, if teams cannot be
// moved, or if more than most_moved_teams would be moved. O(n + edges passed).
std::optional<Moved> moved_along_range(const Placement& placement, std::size_t robot,
                                       const Vec2& to);

// The placement with these robots moved; `moved` must list at least one. If teams move,
// team_candidates becomes empty, since the method did not choose these teams. An error if the
// placement has a different number of balanced robots, or fewer teams, if its teams cannot be
// moved, if an edge does not exist, if C is not the centroid of the balanced robots, if the chord
// of a team does not end where it should, or if robots with a size do not fit or collide. O(n log
// n).
Result<Placement> with_moved(Placement placement, const Moved& moved);

}  // namespace evenlift
