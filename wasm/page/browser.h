// Carries out the view's requests to the browser through web/page/bindings.js. Only the folder
// `page` calls the browser.
#pragma once

#include <string_view>

#include "state/effects.h"

namespace evenlift::view::browser {

// In order.
void carry_out(const Effects& effects);

// Sets the shape of the mouse pointer over the canvas.
void show_cursor(Cursor cursor);

// Reports characters that cannot be shown.
void say_absent(std::string_view characters);

// Requests a call of page_letters() with the larger fonts.
void fetch_letters();

// Requests a call of page_resize() with the present size.
void measure_screen();

// Requests another frame.
void request_frame();

// Requests a call of page_frame() from the browser at the next frame. Only request_frame() uses it.
void schedule_frame();

}  // namespace evenlift::view::browser
