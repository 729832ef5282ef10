// The results of the search for balanced robots, which runs in the background (web/page/search.js).
#include <emscripten/emscripten.h>

#include <cstdint>
#include <optional>

#include "page/page_api.h"

using namespace evenlift::view;

extern "C" {

// Takes over the robots found by the search with this number, and whether they are its last ones;
// or the number of robots counted.
EMSCRIPTEN_KEEPALIVE void page_take_robots(double number, const char* robots, int ended) {
  carry_out({TakeRobots{static_cast<std::uint64_t>(number), robots, ended != 0}});
}

// The search with this number cannot continue.
EMSCRIPTEN_KEEPALIVE void page_search_failed(double number) {
  carry_out({TakeRobots{static_cast<std::uint64_t>(number), std::nullopt}});
}

}  // extern "C"
