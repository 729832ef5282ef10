// Finds what is under the pointer. One need not hit a grip exactly, with a finger even less.
#pragma once

#include "state/state.h"

namespace evenlift::view {

// What is at `screen`, in pixels. The nearest vertex, centre of mass or robot comes first, and a
// robot that can be moved before the vertex on which it stands while its card is open; then edges,
// chords, candidates that are shown, and last the object. In the picture of the second method
// robots and chords are that method's. O(vertices + teams).
Pick pick(const AppState& state, const Vec2& screen, bool second = false);

// Whether what was picked is a robot that can be moved by hand: a balanced one that two others can
// follow, or one of a team that may stand anywhere in its range.
bool can_take_robot(const AppState& state, const Pick& pick);

// The same for a press that may drag: a vertex or the centre of mass within reach comes before a
// robot, unless that can be moved. O(vertices + teams).
Pick pick_to_hold(const AppState& state, const Vec2& screen, bool second = false);

// The robot, team's chord or candidate at `screen`, whatever else is there; the kind is none if
// there is none. Candidates count while they are shown. O(teams + candidates).
Pick pick_explained(const AppState& state, const Vec2& screen, bool second = false);

// The grip that sets within which distance the centre of mass is known, in pixels: it stands off
// the ring, so that it can be taken where the ring is small. None while there is no ring to be
// seen. And the distance for a grip that is moved there.
std::optional<Vec2> doubt_grip(const AppState& state);
double doubt_for_grip(const AppState& state, const Vec2& screen);

// Whether the pointer holds this, or else is over it.
bool is_hovered(const AppState& state, Pick::Kind kind, std::size_t index);

// The robot, chord or candidate under the pointer, or else the one whose card is open: the drawing
// marks it.
Pick marked_part(const AppState& state);

// The chord of a robot's team, of a team or of a candidate; nothing of other parts, nor where the
// placement has none such.
std::optional<Chord> chord_of_part(const Placement& placement, const Pick& part);

// The document's centre of mass; if it has none, that of the last good placement.
Vec2 centre_of_mass(const AppState& state);

// The placement in one of the two pictures; null if the document is refused or there is none.
const Placement* current_placement(const AppState& state, bool second);

}  // namespace evenlift::view
