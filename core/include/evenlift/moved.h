// Robots that the user moves by hand from where the method places them. A balanced robot moves
// along the outline, and two others follow so that C stays the centroid. A team moves along its
// range. A position is stored as an edge and a fraction of the edge's length with twelve decimals,
// so that links stay short.
#pragma once

#include <cstddef>
#include <optional>

#include "evenlift/placement.h"
#include "evenlift/result.h"

namespace evenlift {

// Returns whether teams can be moved. The method must choose among candidates, the setting
// `positions` must allow places anywhere in a range, and `search_ended` must be true. O(1).
bool can_move_teams(const Placement& placement);

// Returns the positions after this balanced robot moves to a point of the outline and its two
// neighbours follow (move_robot() of balanced.h). It returns nothing if the neighbours cannot
// follow, if a robot does not fit or collides, or if there are fewer than three balanced robots.
// O(n log n).
std::optional<Moved> moved_along_outline(const Placement& placement, std::size_t robot,
                                         const LiftingPoint& to);

// Returns the positions after this robot moves until it lies in the direction from C to `to`, or as
// near to that direction as possible. Its partner stays across C. The team moves along the range of
// its two edges and, when an end reaches a vertex, along the range with the next edge. The team
// stops where its chord would fall below the minimum ratio or would have to jump. The function
// returns nothing if the team does not move, if teams cannot be moved (can_move_teams()), or if
// more than most_moved_teams teams would have moved. O(n + edges passed).
std::optional<Moved> moved_along_range(const Placement& placement, std::size_t robot,
                                       const Vec2& to);

// Returns the placement with these robots moved; `moved` must list at least one. If teams move,
// team_candidates becomes empty, since the method did not choose these teams. It is an error if
// the number of balanced robots is not the requested one, a team or an edge does not exist, teams
// cannot be moved, C is not the centroid of the balanced robots, the given end of a team is outside
// the team's range, or robots with a size do not fit or collide. O(n log n).
Result<Placement> with_moved(Placement placement, const Moved& moved);

}  // namespace evenlift
