// The package's WebAssembly: requests of request.h, and memory for their bytes. api.js calls it.
#include <emscripten/emscripten.h>

#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <string>
#include <string_view>

#include "evenlift/request.h"
#include "evenlift/settings.h"

extern "C" {

// Allocates this number of bytes; returns 0 if that is impossible. Free them with evenlift_free().
EMSCRIPTEN_KEEPALIVE void* evenlift_room(std::size_t bytes) { return std::malloc(bytes); }

EMSCRIPTEN_KEEPALIVE void evenlift_free(void* room) { std::free(room); }

// Returns the answer to a request with this number of bytes. It ends with a zero byte; free it with
// evenlift_free(). Returns 0 if memory is too low.
EMSCRIPTEN_KEEPALIVE char* evenlift_answer(const char* request, std::size_t bytes) {
  const std::string answer = evenlift::answer(std::string_view(request, bytes));
  auto* copy = static_cast<char*>(std::malloc(answer.size() + 1));
  if (copy) std::memcpy(copy, answer.c_str(), answer.size() + 1);
  return copy;
}

// The names of all settings that requests take, with commas between them.
EMSCRIPTEN_KEEPALIVE const char* evenlift_settings() {
  static const std::string names = [] {
    std::string list;
    for (const evenlift::SettingRow& row : evenlift::all_settings())
      if (row.changes != evenlift::Changes::view && row.setting != evenlift::Setting::com)
        for (const std::string_view name : {row.name, row.alias})
          if (!name.empty()) list += (list.empty() ? "" : ",") + std::string(name);
    return list;
  }();
  return names.c_str();
}

}  // extern "C"
