// The timeline counts the shown steps: the main steps, all steps, or the stops of a script.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "state/state.h"

namespace evenlift::view {

struct Timeline {
  std::uint32_t at = 0, count = 1;  // the present position, from 0, and the number of positions
};
Timeline timeline(const AppState& state);
// Returns the step at a position.
std::uint32_t step_of(const AppState& state, std::uint32_t position);
// Returns the position of a step; nothing if the timeline does not show the step.
std::optional<std::uint32_t> position_of(const AppState& state, std::uint32_t step);

// A chapter's part of the timeline: `count` positions that begin at `first`. All parts have the
// same width, whatever their number of steps. A script is one chapter.
struct ChapterPart {
  std::uint32_t first = 0, count = 0;
};
std::vector<ChapterPart> chapter_parts(const AppState& state);
// share_of() returns the place of a position as a fraction of the timeline's width (0 .. 1), and
// position_at() the position nearest to a fraction.
double share_of(const std::vector<ChapterPart>& parts, std::uint32_t position);
std::uint32_t position_at(const std::vector<ChapterPart>& parts, double share);

}  // namespace evenlift::view
