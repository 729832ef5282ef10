// Takes the results of the search for balanced robots (web/page/search.js), and of choosing teams
// while a large object is dragged (web/page/choosing.js).
#include <emscripten/emscripten.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <utility>
#include <vector>

#include "page/page_api.h"

using namespace evenlift::view;

extern "C" {

// The robots, or their count, found by the search with this number, and whether it has ended: 2 if a
// limit of work ended it.
EMSCRIPTEN_KEEPALIVE void page_take_robots(double number, const char* robots, int ended) {
  carry_out({TakeRobots{static_cast<std::uint64_t>(number), robots, ended != 0, ended == 2}});
}

// The search with this number cannot continue.
EMSCRIPTEN_KEEPALIVE void page_search_failed(double number) {
  carry_out({TakeRobots{static_cast<std::uint64_t>(number), std::nullopt}});
}

// The choice for the document with this number: `size` bytes of doubles, 0 if it is refused.
EMSCRIPTEN_KEEPALIVE void page_take_choice(double number, const unsigned char* bytes,
                                           std::size_t size) {
  std::vector<double> choice(size / sizeof(double));
  if (!choice.empty()) std::memcpy(choice.data(), bytes, choice.size() * sizeof(double));
  carry_out({TakeChoice{static_cast<std::uint64_t>(number), std::move(choice)}});
}

// No choice is possible for the document with this number.
EMSCRIPTEN_KEEPALIVE void page_choice_failed(double number) {
  carry_out({TakeChoice{static_cast<std::uint64_t>(number), std::nullopt}});
}

}  // extern "C"
