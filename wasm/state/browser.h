// What the view asks of the browser. browser.cpp hands it to web/page.js; browser_native.cpp stands
// in where there is no browser.
#pragma once

#include <cstdint>
#include <string_view>

namespace evenlift::view::browser {

// The document changed: the page brings address bar, storage and live region up to date, not at
// once but at most a few times a second.
void document_changed();

// What is kept for this browser, not for the document, changed (page_preferences_text()).
void preferences_changed();

// Puts the page's address with this link on the clipboard. The page answers with a notice.
void copy_address(std::string_view link);

// A window of the page itself, of HTML: text is typed there, files are chosen, lists are read out.
enum class Dialog : std::uint8_t { samples, open, save, table, lessons, experiment, curves };
void open_dialog(Dialog dialog);

// Says a notice to those who cannot see it; nothing takes it back.
void announce(std::string_view text);

// Opens the page itself, out of an <iframe>, in a new tab.
void open_page();

// Asks for page_resize() with the present measures.
void measure_screen();

// Asks for another frame, now or after so many seconds; of later ones only the last that was asked
// for comes, if it is not dropped.
void request_frame();
void request_frame_after(double seconds);
void drop_frame_after();

// Asks the browser for page_frame() when it is time for a picture. For request_frame() alone.
void schedule_frame();

}  // namespace evenlift::view::browser
