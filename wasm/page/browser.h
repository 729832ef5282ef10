// Carries out what the view asks of the browser, by web/page/bindings.js. Only page speaks to the
// browser.
#pragma once

#include <string_view>

#include "state/effects.h"

namespace evenlift::view::browser {

// In their order.
void carry_out(const Effects& effects);

// Shows the mouse pointer in another form over the canvas.
void show_cursor(Cursor cursor);

// Says that these characters cannot be shown.
void say_absent(std::string_view characters);

// Asks for a call of page_letters() with the larger fonts.
void fetch_letters();

// Asks for a call of page_resize() with the present size.
void measure_screen();

// Asks for another frame.
void request_frame();

// Asks the browser to call page_frame() when it is time for a picture. Only request_frame() uses
// it.
void schedule_frame();

}  // namespace evenlift::view::browser
