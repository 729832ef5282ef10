// Moves, adds and removes weights, and vertices of the outline and of holes. The parameters
// `number` and `edge` are numbers of handles (handles.h).
#pragma once

#include <cstddef>
#include <string>

#include "state/state.h"

namespace evenlift::view {

void move_handle(AppState& state, std::size_t number, const Vec2& to);

// Inserts a vertex on an edge, and selects it.
void insert_vertex(AppState& state, std::size_t edge, const Vec2& at);

// Removes a vertex or a weight. A hole of three vertices is removed as a whole.
void remove_handle(AppState& state, std::size_t number);

// Adds a weight of about a tenth of the object's own weight, and selects it.
void add_weight(AppState& state, const Vec2& at);

// Records the polygon and everything that moves with it, at the start of a drag. O(n).
void grip_polygon(AppState& state);

// The reason why a weight is refused, as a sentence without a full stop; empty if it is accepted.
// O(bytes).
std::string problem_of(const Cargo& item);

// Replaces one weight, or shows a notice that says why it is refused.
void set_weight(AppState& state, std::size_t item, const Cargo& cargo);

}  // namespace evenlift::view
