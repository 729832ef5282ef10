// The package's WebAssembly: requests of request.h, and the room for their bytes. api.js calls it.
#include <emscripten/emscripten.h>

#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <string>
#include <string_view>

#include "evenlift/request.h"
#include "evenlift/settings.h"

extern "C" {

// Room for so many bytes, or 0 if there is none; evenlift_free() takes it back.
EMSCRIPTEN_KEEPALIVE void* evenlift_room(std::size_t bytes) { return std::malloc(bytes); }

EMSCRIPTEN_KEEPALIVE void evenlift_free(void* room) { std::free(room); }

// The answer to a request of so many bytes, ended by a zero byte, for evenlift_free(); 0 if there
// is no room for it.
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
        list += (list.empty() ? "" : ",") + std::string(row.name);
    return list;
  }();
  return names.c_str();
}

}  // extern "C"
