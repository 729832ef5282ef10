// Finds what is under the pointer. One need not hit a grip exactly, with a finger even less.
#pragma once

#include "state/state.h"

namespace evenlift::view {

// What is at `screen`, in CSS pixels. The nearest vertex or centre of mass comes first; then
// robots, edges, chords, and last the object. In the picture of the second method robots and chords
// are that method's. O(vertices + teams).
Pick pick(const AppState& state, const Vec2& screen, bool second = false);

// The document's centre of mass; if it has none, that of the last good placement.
Vec2 centre_of_mass(const AppState& state);

// The placement in one of the two pictures; null if the document is refused or there is none.
const Placement* current_placement(const AppState& state, bool second);

}  // namespace evenlift::view
