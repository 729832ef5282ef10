// Opens a ready-made lesson: its document, and the walkthrough with the lesson's script.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "evenlift/result.h"
#include "state/state.h"

namespace evenlift::view {

// How a lesson is opened: as a step of undo, after which a lesson that was open is left; for the
// document that is open, which stays, with its settings and its step, and must be the lesson's
// polygon; or to be looked at while it is written, in place of the last such preview.
enum class LessonStart : std::uint8_t { anew, join, preview };

// `polygon` is the text of the sample that the lesson names, if it names one. If the lesson cannot
// be opened, says why and changes nothing.
std::optional<InputError> open_lesson(AppState& state, const std::string& text,
                                      const std::string& polygon,
                                      LessonStart start = LessonStart::anew);

}  // namespace evenlift::view
