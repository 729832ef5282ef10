// Robots that somebody moves by hand from where the method puts them. Those that are balanced go
// along the outline, and two others follow so that C stays the centroid of all. A team that may
// stand anywhere in its range goes along it. Where they stand is kept as points of edges with
// twelve decimals of the edge's length, so that links stay short.
#pragma once

#include <cstddef>
#include <optional>

#include "evenlift/placement.h"
#include "evenlift/result.h"

namespace evenlift {

// Whether the teams of a placement can be moved along their ranges: they may stand anywhere in
// them. O(1).
bool can_move_teams(const Placement& placement);

// Where the robots come to if the one with this number goes to a point of the outline, and its two
// neighbours follow (move_robot() of balanced.h). Nothing if they cannot, or if there are not three
// balanced robots. O(n log n).
std::optional<Moved> moved_along_outline(const Placement& placement, std::size_t robot,
                                         const LiftingPoint& to);

// Where the teams come to if the robot with this number goes towards a point as seen from C. Its
// partner is on the other side of C. They go along the range of their two edges, from a vertex on
// along that of the next edge, and stop where their chord would not be even enough or would jump.
// Nothing if they stay where they are, or if teams cannot be moved. O(n + edges that they pass).
std::optional<Moved> moved_along_range(const Placement& placement, std::size_t robot,
                                       const Vec2& to);

// The placement with these robots moved, of which there is at least one. Its team_candidates are
// empty, since its teams are no longer those that the method chose. It is an error if there are not
// as many robots or teams in the placement, if an edge does not exist, if C is not the centroid of
// balanced robots, if the chord of a team does not end where it should, or if robots with a size
// have no room or get into each other's way. O(n log n).
Result<Placement> with_moved(Placement placement, const Moved& moved);

}  // namespace evenlift
