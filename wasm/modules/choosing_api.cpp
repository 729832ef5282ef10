// Chooses teams in a worker while a large object is dragged (web/page/choosing_worker.js).
#include <emscripten/emscripten.h>

#include <cstddef>
#include <cstring>
#include <vector>

#include "derive/elsewhere.h"
#include "evenlift/placement.h"

namespace {

std::vector<double>& choice() {
  static std::vector<double> the_choice;
  return the_choice;
}

}  // namespace

extern "C" {

// Places the object with these rings, `size` bytes of doubles, and settings (derive/elsewhere.h).
// Returns the choice's size in bytes: 0 if the object is refused.
EMSCRIPTEN_KEEPALIVE std::size_t choosing_place(const unsigned char* rings, std::size_t size,
                                                const char* settings) {
  std::vector<double> numbers(size / sizeof(double));
  if (!numbers.empty()) std::memcpy(numbers.data(), rings, numbers.size() * sizeof(double));
  choice().clear();
  if (const auto document = evenlift::view::read_task(numbers, settings))
    if (const auto placement = place(*document))
      choice() = evenlift::view::choice_as_numbers(*placement);
  return choice().size() * sizeof(double);
}

// Valid until the next call of choosing_place().
EMSCRIPTEN_KEEPALIVE const double* choosing_choice() { return choice().data(); }

}  // extern "C"
