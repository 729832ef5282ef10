// What the view asks of the browser, as values: commands and what follows from them say it, and
// page carries it out afterwards, in this order (page/effects.cpp).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace evenlift::view {

// The page's own windows. They are HTML, so that text can be typed, files chosen, and lists read
// out.
enum class Dialog : std::uint8_t {
  samples,
  open,
  save,
  table,
  lessons,
  experiment,
  curves,
  keys,
  about,
  glossary,
  welcome,
  optimum,
  end_of_dialogs  // no dialog: it stays the last and counts them, so that each needs its name
};

// The forms of the mouse pointer over the canvas.
enum class Cursor : std::uint8_t {
  arrow,
  press,
  crosshair,
  add,
  grab,
  grabbing,
  move,
  resize_rising,
  resize_falling,
  end_of_cursors  // no cursor, likewise
};

// The document changed. The page updates the address bar, the storage and the live region at most a
// few times a second.
struct DocumentChanged {};

// What is selected, in hand or compared changed, and with it only the text for those who cannot see
// the canvas.
struct SummaryChanged {};

// The preferences changed, which the browser keeps besides the document (page_kept()).
struct PreferencesChanged {};

// Reads out a text to those who cannot see the canvas.
struct Announce {
  std::string text;
};

// Copies the page's address with this link to the clipboard. The page says in a notice whether that
// worked, and what the link holds.
struct CopyAddress {
  std::string link;
};

struct ShowDialog {
  Dialog dialog;
};

// Gives the focus to the field of a control, once it is laid out.
struct FocusField {
  std::string control;
};

// Shows the page in full screen, or in its window again. When the reader leaves full screen, the
// page says so with page_end_presenting().
struct ShowFullScreen {
  bool on;
};

// Opens the page of an <iframe> in a new tab.
struct ShowPage {};

// Goes on with the search of this number for balanced robots, beside the page, and ends what was
// under way. The problem is a polygon in the thesis's format, settings as lines `name=value`, and
// the robots at the start (robots_text.h). page_take_robots() gets what is found. With a capacity
// among the settings it is only counted how many robots it takes if any one may fail.
struct BeginSearch {
  std::uint64_t number;
  std::string polygon, settings, robots;
};
struct EndSearch {};

// Asks for another frame, now or after so many seconds. Only the last request for a later frame
// counts, and it can be dropped.
struct NextFrame {};
struct FrameAfter {
  double seconds;
};
struct DropFrameAfter {};

// Ends the notice after so many seconds; none takes that back. Only the last one counts.
struct EndNoticeAfter {
  std::optional<double> seconds;
};

using Effect =
    std::variant<DocumentChanged, SummaryChanged, PreferencesChanged, Announce, CopyAddress,
                 ShowDialog, FocusField, ShowFullScreen, ShowPage, BeginSearch, EndSearch,
                 NextFrame, FrameAfter, DropFrameAfter, EndNoticeAfter>;
using Effects = std::vector<Effect>;

}  // namespace evenlift::view
