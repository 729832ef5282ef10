// Adds and removes vertices of the polygon.
#pragma once

#include <cstddef>

#include "state/state.h"

namespace evenlift::view {

// Inserts a vertex on an edge, and selects it.
void insert_vertex(AppState& state, std::size_t edge, const Vec2& at);
void remove_vertex(AppState& state, std::size_t vertex);

}  // namespace evenlift::view
