// Edits that may be refused as a whole: those of scripts and of the table of vertices.
#pragma once

#include <cstdint>
#include <optional>

#include "evenlift/result.h"
#include "state/state.h"

namespace evenlift::view {

// Takes over an edited document as one step of undo; or says why it is refused, and changes
// nothing. If only the step of the walkthrough or overlays differ, that is no edit; and nothing is
// placed if only what is shown differs. It is also refused if the placement has no robot with the
// number `failed`, from 1.
std::optional<InputError> try_edit(AppState& state, const Document& edited,
                                   std::uint64_t failed = 0);

}  // namespace evenlift::view
