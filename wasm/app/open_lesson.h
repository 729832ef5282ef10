// Opens a ready-made lesson: its document, and then the walk through its steps.
#pragma once

#include <optional>
#include <string>

#include "evenlift/result.h"
#include "state/state.h"

namespace evenlift::view {

// Opens a ready-made lesson; `polygon` is the text of the sample that it names, if it names one.
// With `join` the document that is open stays, with its settings and at its step, if it has one:
// the lesson gives its words to it, and it must be of the lesson's polygon. Says what is wrong, and
// changes nothing, if it cannot be opened.
std::optional<InputError> open_script(AppState& state, const std::string& text,
                                      const std::string& polygon, bool join = false);

}  // namespace evenlift::view
