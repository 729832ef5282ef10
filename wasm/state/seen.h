// The part of the polygon that the camera shows.
#pragma once

#include <string>

#include "state/state.h"

namespace evenlift::view {

// Whether no panel covers the centre of mass.
bool centre_is_shown(const AppState& state);

// Whether all vertices are on the screen, and nothing covers one. O(vertices).
bool vertices_are_shown(const AppState& state);

// Whether the camera shows all vertices, not much smaller than possible. O(n).
bool well_shown(const AppState& state);

// "125 %" of the fitting view. O(vertices).
std::string zoom_in_words(const AppState& state);

// Whether the outline crosses the uncovered canvas. O(vertices).
bool outline_is_seen(const AppState& state);

}  // namespace evenlift::view
