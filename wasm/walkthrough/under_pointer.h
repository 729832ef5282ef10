// Finds the parts of the walkthrough's drawing that are under the pointer.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "state/state.h"

namespace evenlift::view {

// Returns the index of the walkthrough's figure under the pointer, or nothing. Points precede
// lines, and lines precede areas. O(points of the figures).
std::optional<std::size_t> figure_at(const AppState& state, const Vec2& screen);

// Returns the question's choice that is nearest to the pointer, or nothing if all are too far away
// or no question is asked. O(choices).
std::optional<std::uint32_t> choice_at(const AppState& state, const Vec2& screen);

}  // namespace evenlift::view
