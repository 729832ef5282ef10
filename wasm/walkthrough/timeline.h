// The timeline counts the shown steps: the main ones, all, or the stops of a script.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "state/state.h"

namespace evenlift::view {

struct Timeline {
  std::uint32_t at = 0, count = 1;
};
Timeline timeline(const AppState& state);
std::uint32_t step_of(const AppState& state, std::uint32_t position);
// Nothing if the step is not shown.
std::optional<std::uint32_t> position_of(const AppState& state, std::uint32_t step);

// All of the same width, whatever their number of steps. A script is one chapter. Positions begin
// at `first`.
struct ChapterPart {
  std::uint32_t first = 0, count = 0;
};
std::vector<ChapterPart> chapter_parts(const AppState& state);
// A fraction of the timeline (0 .. 1), and the position nearest to it.
double share_of(const std::vector<ChapterPart>& parts, std::uint32_t position);
std::uint32_t position_at(const std::vector<ChapterPart>& parts, double share);

}  // namespace evenlift::view
