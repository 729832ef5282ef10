#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "state/state.h"

namespace evenlift::view {

// Points come before lines, and lines before areas. O(figures).
std::optional<std::size_t> figure_at(const AppState& state, const Vec2& screen);

// Of the question.
std::optional<std::uint32_t> choice_at(const AppState& state, const Vec2& screen);

}  // namespace evenlift::view
