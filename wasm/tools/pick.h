// Finds the part under the pointer. The pointer need only be near a part, and a finger may be
// farther away.
#pragma once

#include "state/state.h"

namespace evenlift::view {

// Returns the part at `screen`, in pixels. The nearest vertex, weight, centre of mass, uncertainty
// grip or robot has priority. Among these, a movable robot comes first if it was placed by hand or
// its card is open. Next come edges, chords and shown candidates, and the object comes last. In the
// second method's picture, robots, chords and candidates are that method's.
// O(vertices + teams + candidates).
Pick pick(const AppState& state, const Vec2& screen, bool second = false);

// Returns the object, whatever other part is at `screen`; the kind is `none` outside the object, in
// a hole, and while the document is refused. O(vertices).
Pick object_at(const AppState& state, const Vec2& screen, bool second = false);

// Returns whether the part is a robot that the user can move. This is any robot of the first
// picture, unless the document is refused, a walkthrough is open or a robot fails.
bool can_take_robot(const AppState& state, const Pick& pick);

// Returns the part that a press grabs, perhaps to drag it. A vertex, a weight, the centre of mass
// or the uncertainty grip within reach precedes a robot that cannot be moved. O(vertices + teams +
// candidates).
Pick pick_to_hold(const AppState& state, const Vec2& screen, bool second = false);

// Returns the robot, team's chord or shown candidate at `screen`, whatever other part is there. The
// kind is `none` if there is no such part. O(teams + candidates).
Pick pick_explained(const AppState& state, const Vec2& screen, bool second = false);

// Returns the place, in pixels, of the grip that sets the C uncertainty. Returns nothing while no
// robots are placed, or while the ring of the uncertainty is hidden or cannot be edited. The grip
// is at a distance from the ring, so that the user can grab it even if the ring is small.
// uncertainty_for_grip() returns the uncertainty that a grip at `screen` sets, in the unit of the
// polygon's coordinates.
std::optional<Vec2> uncertainty_grip(const AppState& state);
double uncertainty_for_grip(const AppState& state, const Vec2& screen);

// Returns whether the pointer holds this part or, if it holds no part, whether the pointer is over
// this one. False while a shape or a hole is being drawn.
bool is_hovered(const AppState& state, Pick::Kind kind, std::size_t index);

// Returns the robot, chord or candidate under the pointer. If there is none, returns the part with
// an open card or, if no card is open, any other part under the pointer.
Pick marked_part(const AppState& state);

// Returns the chord of a robot's team, of a team or of a candidate; nothing for other parts and for
// parts that the placement does not have. Precondition for robots: they are in teams of two.
std::optional<Chord> chord_of_part(const Placement& placement, const Pick& part);

// own_centre() returns the centre of mass of the object without cargo: that of the document, or
// else of the last placement, or else the first vertex. centre_of_mass() returns the centre of mass
// with the cargo. O(items).
Vec2 own_centre(const AppState& state);
Vec2 centre_of_mass(const AppState& state);

// Returns the centroid of the object without its holes; nothing while the document is refused.
// O(1).
std::optional<Vec2> own_centroid(const AppState& state);

// Returns the weight at `screen`; the kind is `none` if no weight is there. O(items).
Pick weight_at(const AppState& state, const Vec2& screen);

// Returns the shown placement of the first or the second method; null if it does not exist or the
// document is refused.
const Placement* current_placement(const AppState& state, bool second);

}  // namespace evenlift::view
