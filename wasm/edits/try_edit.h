// Edits that may be refused as a whole: by scripts, and in the table of vertices.
#pragma once

#include <cstdint>
#include <optional>

#include "evenlift/result.h"
#include "state/state.h"

namespace evenlift::view {

// Takes over an edited document as one step of undo, or returns why it is refused and changes
// nothing. It is no edit if only the walkthrough's step or overlays differ, and nothing is placed
// if only shown values differ. Also refused if the placement has no robot with the number `failed`,
// from 1.
std::optional<InputError> try_edit(AppState& state, const Document& edited,
                                   std::uint64_t failed = 0);

}  // namespace evenlift::view
