// Opens a lesson: its document, the walkthrough with the lesson's script if it has steps, and its
// task if it has one.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "evenlift/result.h"
#include "state/state.h"

namespace evenlift::view {

// `anew` leaves any open lesson, and opens this one as a step of undo. `join` begins the lesson
// with the open document, which keeps its settings and, if the walkthrough is open, its step. The
// document must have the lesson's polygon, unless the lesson has no steps and its task lets the
// user change vertices. `preview` shows a lesson while it is being written, and replaces the last
// preview.
enum class LessonStart : std::uint8_t { anew, join, preview };

// `polygon` is the text of the sample that the lesson names; `number` is the learner's number
// (evenlift/task.h). If there is an error, returns it and changes nothing.
std::optional<InputError> open_lesson(AppState& state, const std::string& text,
                                      const std::string& polygon,
                                      LessonStart start = LessonStart::anew,
                                      std::uint64_t number = 1);

}  // namespace evenlift::view
