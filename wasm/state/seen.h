// Tells which part of the polygon the camera shows.
#pragma once

#include <string>

#include "state/state.h"

namespace evenlift::view {

// Returns whether a centre of mass that the user set is on the screen and no panel covers it; true
// if the user did not set it.
bool centre_is_shown(const AppState& state);

// Returns whether all vertices of the outline are on the screen, and no panel covers one.
// O(vertices).
bool vertices_are_shown(const AppState& state);

// Returns whether all vertices of the outline are on the screen, perhaps under a panel, and the
// scale is not much smaller than the fitting camera's. O(vertices).
bool well_shown(const AppState& state);

// Returns the scale as a percentage of the fitting camera's scale (layout.h), for instance "125 %".
// O(vertices).
std::string zoom_in_words(const AppState& state);

// Returns whether the outline crosses the uncovered part of the canvas. O(vertices).
bool outline_is_seen(const AppState& state);

}  // namespace evenlift::view
