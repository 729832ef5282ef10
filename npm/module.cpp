// The package's WebAssembly, which api.js calls: requests of request.h, and memory for their bytes.
#include <emscripten/emscripten.h>

#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <string>
#include <string_view>

#include "evenlift/request.h"
#include "evenlift/settings.h"

extern "C" {

// Returns 0 if memory is too low. Free with evenlift_free().
EMSCRIPTEN_KEEPALIVE void* evenlift_room(std::size_t bytes) { return std::malloc(bytes); }

EMSCRIPTEN_KEEPALIVE void evenlift_free(void* room) { std::free(room); }

// Answers a request. The answer ends with a zero byte; free it with evenlift_free(). Returns 0 if
// memory is too low.
EMSCRIPTEN_KEEPALIVE char* evenlift_answer(const char* request, std::size_t bytes) {
  const std::string answer = evenlift::answer(std::string_view(request, bytes));
  auto* copy = static_cast<char*>(std::malloc(answer.size() + 1));
  if (copy) std::memcpy(copy, answer.c_str(), answer.size() + 1);
  return copy;
}

// The names of all settings that requests take, separated by commas.
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
