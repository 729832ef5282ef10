// Carries out the view's requests through web/page/bindings.js. Only the folder `page` calls the
// browser.
#pragma once

#include <string_view>

#include "state/effects.h"

namespace evenlift::view::browser {

// Carries out the requests in order.
void carry_out(const Effects& effects);

// Shows this cursor over the canvas.
void show_cursor(Cursor cursor);

// Reports characters that cannot be shown.
void say_absent(std::string_view characters);

// Requests page_letters() with the larger fonts.
void fetch_letters();

// Requests page_resize() with the present size.
void measure_screen();

void request_frame();

// Requests page_frame() at the browser's next frame. Only schedule() in main.cpp uses it.
void schedule_frame();

}  // namespace evenlift::view::browser
