// Finds the part under the pointer, which need not hit a grip exactly, and a finger even less so.
#pragma once

#include "state/state.h"

namespace evenlift::view {

// The part at `screen`, in pixels. The nearest vertex, centre of mass or robot has priority; a
// movable robot with an open card precedes the vertex under it. Then follow edges, chords and shown
// candidates, and last the object. In the second method's picture, robots and chords are that
// method's. O(vertices + teams).
Pick pick(const AppState& state, const Vec2& screen, bool second = false);

// The object, whatever else is at `screen`; the kind is none beside it and in a hole. O(vertices).
Pick object_at(const AppState& state, const Vec2& screen, bool second = false);

// Whether the user can move the robot: any of the first picture, unless a walkthrough is open or a
// robot fails.
bool can_take_robot(const AppState& state, const Pick& pick);

// For a press that may begin a drag: a vertex or the centre of mass within reach precedes a robot,
// unless the robot can be moved. O(vertices + teams).
Pick pick_to_hold(const AppState& state, const Vec2& screen, bool second = false);

// The robot, team's chord or shown candidate, regardless of other parts there; otherwise the kind
// is none. O(teams + candidates).
Pick pick_explained(const AppState& state, const Vec2& screen, bool second = false);

// The grip that sets the C uncertainty, in pixels. It is away from the ring, so that the user can
// grab it even if the ring is small. Nothing while no ring is visible. uncertainty_for_grip() is
// the uncertainty for a grip at `screen`.
std::optional<Vec2> uncertainty_grip(const AppState& state);
double uncertainty_for_grip(const AppState& state, const Vec2& screen);

// Whether the pointer holds this part, or else is over it; false while a shape or a hole is drawn.
bool is_hovered(const AppState& state, Pick::Kind kind, std::size_t index);

// The robot, chord or candidate under the pointer, or else with an open card.
Pick marked_part(const AppState& state);

// Of a robot's team, of a team or of a candidate; nothing for other parts, and for parts that the
// placement does not have.
std::optional<Chord> chord_of_part(const Placement& placement, const Pick& part);

// The document's, or else that of the last good placement; and with its cargo. O(items).
Vec2 own_centre(const AppState& state);
Vec2 centre_of_mass(const AppState& state);

// Without the holes; nothing while the document is refused. O(1).
std::optional<Vec2> own_centroid(const AppState& state);

// Otherwise the kind is none. O(items).
Pick weight_at(const AppState& state, const Vec2& screen);

// Null if the document is refused, or without such a placement.
const Placement* current_placement(const AppState& state, bool second);

}  // namespace evenlift::view
