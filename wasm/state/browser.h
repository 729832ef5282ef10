// What the view asks of the browser. page/browser.cpp passes it on to web/page/bindings.js;
// browser_native.cpp replaces it where there is no browser.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace evenlift::view::browser {

// The document changed. The page updates the address bar, the storage and the live region at most a
// few times a second.
void document_changed();

// What is selected, in hand or compared changed, and with it only the text for those who cannot see the canvas.
void summary_changed();

// The preferences changed, which the browser keeps besides the document (page_preferences_text()).
void preferences_changed();

// Copies the page's address with this link to the clipboard. The page says in a notice whether that
// worked, and what the link holds.
void copy_address(std::string_view link);

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
void open_dialog(Dialog dialog);

// Shows the mouse pointer in another form over the canvas.
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
void show_cursor(Cursor cursor);

// Gives the focus to the field of a control, once it is laid out.
void type_value(std::string_view control);

// Reads out a text to those who cannot see the canvas.
void announce(std::string_view text);

// Shows the page in full screen, or in its window again. When the reader leaves full screen, the page says so with
// page_end_presenting().
void show_full_screen(bool on);

// Opens the page of an <iframe> in a new tab.
void open_page();

// Says that these characters cannot be shown.
void say_absent(std::string_view characters);

// Asks for a call of page_letters() with the larger fonts.
void fetch_letters();

// Asks for a call of page_resize() with the present size.
void measure_screen();

// Goes on with the search of this number for balanced robots, beside the page, and ends what was
// under way; or only ends that. The problem is a polygon in the thesis's format, settings as lines
// `name=value`, and the robots at the start (robots_text.h). page_take_robots() gets what is found. With a
// capacity among the settings it is only counted how many robots it takes if any one may fail.
void begin_search(std::uint64_t number, std::string_view polygon, std::string_view settings,
                  std::string_view robots);
void end_search();

// Asks for another frame, now or after so many seconds. Only the last request for a later frame
// counts, and it can be dropped.
void request_frame();
void request_frame_after(double seconds);
void drop_frame_after();

// Calls page_end_notice() after so many seconds; none takes that back. Only the last request counts.
void end_notice_after(std::optional<double> seconds);

// Asks the browser to call page_frame() when it is time for a picture. Only request_frame() uses
// it.
void schedule_frame();

}  // namespace evenlift::view::browser
