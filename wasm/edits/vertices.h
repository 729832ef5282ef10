// Moves, adds and removes vertices of the outline and of holes, and weights. Numbers are those of
// handles (handles.h).
#pragma once

#include <cstddef>
#include <string>

#include "state/state.h"

namespace evenlift::view {

void move_handle(AppState& state, std::size_t number, const Vec2& to);

// Also selects it.
void insert_vertex(AppState& state, std::size_t edge, const Vec2& at);

// A hole of three vertices goes with any of them.
void remove_handle(AppState& state, std::size_t number);

// A tenth of the object's own weight; also selects it.
void add_weight(AppState& state, const Vec2& at);

// Remembers everything that moves with the polygon. O(n).
void grip_polygon(AppState& state);

// Why a weight is refused, as a sentence without a full stop, or empty. O(bytes).
std::string problem_of(const Cargo& item);

// Replaces one weight, or says why not.
void set_weight(AppState& state, std::size_t item, const Cargo& cargo);

}  // namespace evenlift::view
