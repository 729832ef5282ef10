// What is under the pointer. Grips reach farther than what is drawn, under a finger more so.
#pragma once

#include "state/state.h"

namespace evenlift::view {

// At `screen`, in CSS pixels. Vertices and the centre of mass come first, the nearest of them; then
// robots, edges and chords, then the object. In the picture of the method that is compared
// (`other`) robots and chords are that method's. O(vertices + teams).
Pick pick(const AppState& state, const Vec2& screen, bool other = false);

// The centre of mass in force: the document's, else the last good placement's.
Vec2 centre_of_mass(const AppState& state);

// The placement in one of the two pictures; null where there is none that is current.
const Placement* current_placement(const AppState& state, bool other);

// Whether p is inside the polygon, by counting crossings in doubles: for pointing, not for
// deciding.
bool inside(const Points& polygon, const Vec2& p);

// The point of the segment a b nearest to p. O(1).
Vec2 nearest_on_segment(const Vec2& a, const Vec2& b, const Vec2& p);

}  // namespace evenlift::view
