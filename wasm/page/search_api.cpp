// What the search for balanced robots finds beside the page (web/page/search.js).
#include <emscripten/emscripten.h>

#include <cstdint>
#include <optional>

#include "page/page_api.h"

using namespace evenlift::view;

extern "C" {

// Takes over the robots that the search of this number found, and whether they are its last ones;
// or how many were counted.
EMSCRIPTEN_KEEPALIVE void page_take_robots(double number, const char* robots, int ended) {
  carry_out({TakeRobots{static_cast<std::uint64_t>(number), robots, ended != 0}});
}

// The search of this number cannot go on.
EMSCRIPTEN_KEEPALIVE void page_search_failed(double number) {
  carry_out({TakeRobots{static_cast<std::uint64_t>(number), std::nullopt}});
}

}  // extern "C"
