// Finds the part under the pointer. The pointer need not hit a grip exactly, and a finger even less
// so.
#pragma once

#include "state/state.h"

namespace evenlift::view {

// The part at `screen`, in pixels. The nearest vertex, centre of mass or robot has priority; while
// the card of a movable robot is open, that robot precedes the vertex where it stands. Then follow
// edges, chords and shown candidates, and last the object. In the picture of the second method,
// robots and chords are that method's. O(vertices + teams).
Pick pick(const AppState& state, const Vec2& screen, bool second = false);

// The object, if it is at `screen` and has no hole there, whatever else is there; otherwise its kind
// is none. O(vertices).
Pick object_at(const AppState& state, const Vec2& screen, bool second = false);

// Whether the picked part is a robot that the user can move by hand: any robot of the first picture,
// unless a walkthrough is open or a robot fails.
bool can_take_robot(const AppState& state, const Pick& pick);

// Like pick(), for a press that may begin a drag: a vertex or the centre of mass within reach
// precedes a robot, unless the robot can be moved. O(vertices + teams).
Pick pick_to_hold(const AppState& state, const Vec2& screen, bool second = false);

// The robot, team's chord or shown candidate at `screen`, regardless of other parts there;
// otherwise its kind is none. O(teams + candidates).
Pick pick_explained(const AppState& state, const Vec2& screen, bool second = false);

// The grip that sets the C uncertainty, in pixels. It is at some distance from the ring, so that
// the user can grab it even if the ring is small. Nothing while no ring is visible.
// uncertainty_for_grip() is the uncertainty for a grip that was moved to `screen`.
std::optional<Vec2> uncertainty_grip(const AppState& state);
double uncertainty_for_grip(const AppState& state, const Vec2& screen);

// Whether the pointer holds this part of the object, or else is over it; false while a shape or a
// hole is drawn.
bool is_hovered(const AppState& state, Pick::Kind kind, std::size_t index);

// The robot, chord or candidate under the pointer, or else the one with an open card; the drawing
// marks it.
Pick marked_part(const AppState& state);

// The chord of a robot's team, of a team or of a candidate; nothing for other parts, and nothing if
// the placement does not have the part.
std::optional<Chord> chord_of_part(const Placement& placement, const Pick& part);

// The object's own centre of mass: the document's, or else that of the last good placement; and with
// its cargo. O(items).
Vec2 own_centre(const AppState& state);
Vec2 centre_of_mass(const AppState& state);

// The centroid of the object without its holes; nothing while the document is refused. O(1).
std::optional<Vec2> own_centroid(const AppState& state);

// The weight at `screen`; otherwise the kind is none. O(items).
Pick weight_at(const AppState& state, const Vec2& screen);

// The placement in one of the two pictures; null if the document is refused or the placement does
// not exist.
const Placement* current_placement(const AppState& state, bool second);

}  // namespace evenlift::view
