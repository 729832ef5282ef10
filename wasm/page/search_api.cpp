// What the search for balanced robots finds beside the page (web/page/search.js).
#include <emscripten/emscripten.h>

#include <cstdint>

#include "edits/search.h"
#include "page/page_api.h"
#include "state/browser.h"

using namespace evenlift::view;

extern "C" {

// Takes over the robots that the search of this number found, and whether they are its last ones; or how
// many were counted.
EMSCRIPTEN_KEEPALIVE void page_take_robots(double number, const char* robots, int ended) {
  if (take_robots(app().state, static_cast<std::uint64_t>(number), robots, ended != 0))
    browser::request_frame();
}

// The search of this number cannot go on.
EMSCRIPTEN_KEEPALIVE void page_search_failed(double number) {
  stop_search(app().state, static_cast<std::uint64_t>(number));
  browser::request_frame();
}

}  // extern "C"
