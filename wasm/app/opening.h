// What the page opens first, and lessons.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "evenlift/result.h"
#include "state/state.h"

namespace evenlift::view {

// --- The first sample, embedded so that it is available at once; the other samples are in a file. The
// build makes the embedded text from assets/polygons.

std::string_view opening_sample();

// --- The first content of the page: a link, the last visit's work, or a sample.

// Texts from the address and the browser's storage. Each may be empty or damaged.
struct LastVisit {
  std::string_view link;   // the address's fragment
  std::string_view work;   // the last placed document, as a link or a text
  std::string_view draft;  // a link to a document that was refused while it was being edited
};

// Opens the link if it can be read; otherwise opens the last work and then, as one step of undo,
// the draft; opens the sample if neither link nor work can be read. After a link has opened, undo
// opens the last work, which is placed only then. Returns why the link could not be read, or an
// empty text. Costs one placement, or two with a draft.
std::string open_page(AppState& state, const LastVisit& visit, std::string_view sample);

// --- Opens a lesson: its document, the walkthrough with the lesson's script if it has steps, and its
// task if it has one.

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
