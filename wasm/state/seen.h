// What is seen of the polygon through the camera.
#pragma once

#include <string>

#include "state/state.h"

namespace evenlift::view {

// Whether no panel covers the centre of mass.
bool centre_is_shown(const AppState& state);

// Whether the camera shows all vertices, and not much smaller than they could be. O(n).
bool well_shown(const AppState& state);

// "125 %" of the view that fits. O(vertices).
std::string zoom_in_words(const AppState& state);

// Whether any part of the polygon's outline crosses what nothing covers of the canvas. O(vertices).
bool outline_is_seen(const AppState& state);

}  // namespace evenlift::view
