// Opens a lesson: its document, and the walkthrough with the lesson's script, or its task.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "evenlift/result.h"
#include "state/state.h"

namespace evenlift::view {

// `anew` leaves any other lesson, and opening is a step of undo. `join` begins the lesson for the
// open document, which must have the lesson's polygon and keeps its settings and step. `preview`
// shows a lesson while it is written, in place of the last preview.
enum class LessonStart : std::uint8_t { anew, join, preview };

// `polygon` is the text of the sample that the lesson names; `number` is the learner's
// (evenlift/task.h). If there is an error, changes nothing.
std::optional<InputError> open_lesson(AppState& state, const std::string& text,
                                      const std::string& polygon,
                                      LessonStart start = LessonStart::anew,
                                      std::uint64_t number = 1);

}  // namespace evenlift::view
