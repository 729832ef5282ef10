// What the view asks of the browser. page/browser.cpp passes it on to web/page/bindings.js;
// browser_native.cpp replaces it where there is no browser.
#pragma once

#include <cstdint>
#include <string_view>

namespace evenlift::view::browser {

// The document changed. The page updates the address bar, the storage and the live region at most a
// few times a second.
void document_changed();

// The preferences changed, which the browser keeps besides the document (page_preferences_text()).
void preferences_changed();

// Copies the page's address with this link to the clipboard. The page says in a notice whether that
// worked.
void copy_address(std::string_view link);

// The page's own windows. They are HTML, so that text can be typed, files chosen, and lists read
// out.
enum class Dialog : std::uint8_t { samples, open, save, table, lessons, experiment, curves };
void open_dialog(Dialog dialog);

// Reads out a text to those who cannot see the canvas.
void announce(std::string_view text);

// Opens the page of an <iframe> in a new tab.
void open_page();

// Asks for a call of page_resize() with the present size.
void measure_screen();

// Asks for another frame, now or after so many seconds. Only the last request for a later frame
// counts, and it can be dropped.
void request_frame();
void request_frame_after(double seconds);
void drop_frame_after();

// Asks the browser to call page_frame() when it is time for a picture. Only request_frame() uses
// it.
void schedule_frame();

}  // namespace evenlift::view::browser
