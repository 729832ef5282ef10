// Robots that the user moves by hand from where the method places them. A balanced robot moves
// along the outline, and two others follow so that C stays the centroid. A team moves along its
// range. Positions are points of edges, as fractions of the edge's length with twelve decimals, so
// that links stay short.
#pragma once

#include <cstddef>
#include <optional>

#include "evenlift/placement.h"
#include "evenlift/result.h"

namespace evenlift {

// Returns whether teams can be moved: whether the method chooses among candidates, the setting for
// positions allows places anywhere in a range, and the search has ended. O(1).
bool can_move_teams(const Placement& placement);

// Returns the new positions if this robot moves to a point of the outline and its two neighbours
// follow (move_robot() of balanced.h). It returns nothing if the neighbours cannot follow, or if
// there are fewer than three balanced robots. O(n log n).
std::optional<Moved> moved_along_outline(const Placement& placement, std::size_t robot,
                                         const LiftingPoint& to);

// Returns the new positions if this robot moves until C sees it in the direction of the point `to`,
// or as near to that direction as it can get, while its partner stays across C. The team moves
// along the range of its two edges and, at a vertex, along that of the next edge. It stops where
// its chord would fall below the minimum ratio or jump. It returns nothing if the team does not
// move, if teams cannot be moved (can_move_teams()), or if more than most_moved_teams would have
// moved. O(n + edges passed).
std::optional<Moved> moved_along_range(const Placement& placement, std::size_t robot,
                                       const Vec2& to);

// Returns the placement with these robots moved; `moved` must list at least one. If teams move,
// team_candidates becomes empty, since the method did not choose these teams. It is an error if the
// number of balanced robots differs, a moved team or an edge does not exist, teams cannot be moved,
// C is not the centroid of the balanced robots, a team's chord does not end where it should, or
// robots with a size do not fit or collide. O(n log n).
Result<Placement> with_moved(Placement placement, const Moved& moved);

}  // namespace evenlift
