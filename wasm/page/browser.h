// Carries out the view's requests through web/page/bindings.js. Only the folder `page` calls the
// browser.
#pragma once

#include <string_view>

#include "state/effects.h"

namespace evenlift::view::browser {

// Carries out the requests in order.
void carry_out(const Effects& effects);

void show_cursor(Cursor cursor);

// Tells the user that the canvas cannot show these characters.
void say_absent(std::string_view characters);

// Asks the browser to fetch the larger fonts and to call page_letters() with them.
void fetch_letters();

// Asks the browser to call page_resize() with the present size.
void measure_screen();

void request_frame();

// Asks the browser to call page_frame() at its next frame. Only schedule() in main.cpp uses this
// function.
void schedule_frame();

}  // namespace evenlift::view::browser
