// Edits by scripts and in the table of vertices. Each edit is accepted or refused as a whole.
#pragma once

#include <cstdint>
#include <optional>

#include "evenlift/result.h"
#include "state/state.h"

namespace evenlift::view {

// Takes over an edited document as one step of undo, or returns why it is refused and changes
// nothing. There is no step of undo if only the walkthrough's step or overlays differ, and nothing
// is placed if only shown values differ. The document is also refused if its placement has no robot
// with the number `failed`, from 1; 0 stands for no robot.
std::optional<InputError> try_edit(AppState& state, const Document& edited,
                                   std::uint64_t failed = 0);

}  // namespace evenlift::view
