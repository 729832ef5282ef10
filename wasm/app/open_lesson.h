// Opens a ready-made lesson: its document, and the walkthrough with the lesson's script.
#pragma once

#include <optional>
#include <string>

#include "evenlift/result.h"
#include "state/state.h"

namespace evenlift::view {

// Opens a ready-made lesson. `polygon` is the text of the sample that the lesson names, if it names
// one. With `join` the document that is open stays, with its settings and its step; it must be the
// lesson's polygon. If the lesson cannot be opened, says why and changes nothing.
std::optional<InputError> open_lesson(AppState& state, const std::string& text,
                                      const std::string& polygon, bool join = false);

}  // namespace evenlift::view
