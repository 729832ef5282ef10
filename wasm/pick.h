// What is under the pointer. Grips reach farther than what is drawn, under a finger more so.
#pragma once

#include "state.h"

namespace evenlift::view {

// At `screen`, in CSS pixels. Vertices and the centre of mass come first, the nearest of them; then
// robots, edges and chords. O(vertices + teams).
Pick pick(const AppState& state, const Vec2& screen);

// The centre of mass in force: the document's, else the last good placement's.
Vec2 centre_of_mass(const AppState& state);

// The point of the segment a b nearest to p. O(1).
Vec2 nearest_on_segment(const Vec2& a, const Vec2& b, const Vec2& p);

}  // namespace evenlift::view
