// The part of the polygon that the camera shows.
#pragma once

#include <string>

#include "state/state.h"

namespace evenlift::view {

// Whether no panel covers the centre of mass.
bool centre_is_shown(const AppState& state);

// Whether nothing covers a vertex, and all of them are on the screen. O(vertices).
bool vertices_are_shown(const AppState& state);

// Whether the camera shows all vertices, and not much smaller than possible. O(n).
bool well_shown(const AppState& state);

// For example "125 %" of the fitting view. O(vertices).
std::string zoom_in_words(const AppState& state);

// Whether any part of the polygon's outline crosses the uncovered part of the canvas. O(vertices).
bool outline_is_seen(const AppState& state);

}  // namespace evenlift::view
