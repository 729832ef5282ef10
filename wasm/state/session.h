// Requests to the browser, and the state of this visit.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "state/camera.h"

namespace evenlift::view {

// --- The view's requests to the browser. Commands and derive() append requests, and page/sdl_input.cpp
// carries them out afterwards, in order.

// The page's own windows. They are HTML, so that users can type and choose files, and screen
// readers can read lists.
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
  language,
  cases,
  weigh,
  end_of_dialogs  // not a dialog; stays last and counts the dialogs, all of which must have names
};

// The shapes of the mouse pointer over the canvas.
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
  end_of_cursors  // not a cursor; counts the cursors
};

// The document changed. The page updates the address bar and the storage, at most a few times a
// second, and the summary for users who cannot see the canvas.
struct DocumentChanged {};

// The summary for users who cannot see the canvas may have changed, for instance with the selection
// or during a drag. The page updates nothing else.
struct SummaryChanged {};

// The preferences changed. The browser keeps them apart from the document (page_kept()).
struct PreferencesChanged {};

// Announces a text to users who cannot see the canvas.
struct Announce {
  std::string text;
};

// Copies the page's address with this link to the clipboard. A notice reports success or failure,
// and the link's contents.
struct CopyAddress {
  std::string link;
};

struct ShowDialog {
  Dialog dialog;
};

// Moves the keyboard focus to a control's field once the field is laid out.
struct FocusField {
  std::string control;
};

// Shows the page in full screen or back in its window. When the user leaves full screen, the page
// calls page_end_presenting().
struct ShowFullScreen {
  bool on;
};

// Opens the page, which is now in an <iframe>, in a new tab.
struct ShowPage {};

// Continues this search for balanced robots in the background, and ends any earlier one. The input
// is a polygon in the thesis's format, settings as lines `name=value`, and the starting robots
// (robots_text.h). Results arrive through page_take_robots(). If the settings include a capacity,
// `robots` is empty, and the search instead finds the number of robots needed if any one may fail.
struct BeginSearch {
  std::uint64_t number;
  std::string polygon, settings, robots;
};
struct EndSearch {};

// Lets a worker choose a document's teams (derive/derive.h). The rings are the outline and the
// holes, as numbers. The choice arrives through page_take_choice().
struct ChooseElsewhere {
  std::uint64_t number;
  std::vector<double> rings;
  std::string settings;
};

// Requests a frame now, or after this many seconds. Only the last request for a later frame counts;
// DropFrameAfter cancels it.
struct NextFrame {};
struct FrameAfter {
  double seconds;
};
struct DropFrameAfter {};

// Ends the notice after this many seconds or, without a number, cancels the planned end. Only the
// last request counts.
struct EndNoticeAfter {
  std::optional<double> seconds;
};

using Effect =
    std::variant<DocumentChanged, SummaryChanged, PreferencesChanged, Announce, CopyAddress,
                 ShowDialog, FocusField, ShowFullScreen, ShowPage, BeginSearch, EndSearch,
                 ChooseElsewhere, NextFrame, FrameAfter, DropFrameAfter, EndNoticeAfter>;
using Effects = std::vector<Effect>;

// --- The state of this visit: its screen, measured sizes, and messages.

// The screen, as the page reports it.
struct Screen {
  // The canvas's size; the ratio is device pixels per CSS pixel.
  double css_width = 1280, css_height = 800, css_ratio = 1;
  // Everywhere else in the view, a pixel is `zoom` CSS pixels wide, since presentation mode
  // enlarges everything.
  double zoom = 1;
  double width = 1280, height = 800;
  double ratio = 1;  // device pixels per pixel
  bool dark = false;
  bool reduced_motion = false;
  bool embed = false;   // in an <iframe>, without panels for editing
  bool finger = false;  // the main pointer is a finger, so controls are larger
  bool touch = false;   // the last pointer was a finger, which cannot hover
  bool asking = false;  // the pointer rests, or a finger does so: marks and tips explain
  double foot = 0;      // pixels from the top of the page's card to the drawing's foot, or 0
  double card = 0;      // the height of this card itself, in pixels, or 0
  // The pixels that a window of the page covers at the left, at the right, or at the foot over the
  // whole width.
  double window_left = 0, window_right = 0, window_foot = 0;
  Rect area() const { return {0, 0, width, height}; }
};

struct Notice {
  enum class Kind : std::uint8_t { info, problem, hint };
  Kind kind = Kind::info;
  std::string text;  // empty if there is no notice
  std::string undo;  // label of a button that undoes the last edit; empty without a button
};

struct Session {
  Screen screen;
  int opened = 0;                    // the number of documents opened since the start
  bool list_open = false;            // the last frame showed a list of choices
  bool close_list = false;           // the next frame closes this list
  std::string wanted_field;          // a key asked for this field, which a closed drawer may have
  double closed_sheet_height = 172;  // pixels, measured in the last frame
  double notice_height = 0;          // pixels, measured in the last frame
  Notice notice;
  Effects effects;  // the effects not carried out yet
};

}  // namespace evenlift::view
