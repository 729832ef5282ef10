// The part of the walkthrough under the pointer.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "state/state.h"

namespace evenlift::view {

// The figure under the pointer. Points come before lines, and lines before areas. O(figures).
std::optional<std::size_t> figure_at(const AppState& state, const Vec2& screen);

// The choice of the question under the pointer.
std::optional<std::uint32_t> choice_at(const AppState& state, const Vec2& screen);

}  // namespace evenlift::view
