// The functions of evenlift.h. They throw no exceptions and return only memory that C can free.
#include <cstdlib>
#include <cstring>
#include <new>
#include <string>
#include <string_view>

#include "evenlift/evenlift.h"
#include "evenlift/request.h"

namespace {

constexpr std::string_view no_request =
    "{\"error\": {\"code\": \"bad_syntax\", \"message\": \"There is no request\", \"place\": null, \"path\": null}}\n";
constexpr std::string_view no_memory =
    "{\"error\": {\"code\": \"no_memory\", \"message\": \"There is not enough memory\", \"place\": null, \"path\": null}}\n";
constexpr std::string_view unknown =
    "{\"error\": {\"code\": \"internal\", \"message\": \"evenlift failed\", \"place\": null, \"path\": null}}\n";

char* handed_over(std::string_view text) {
  auto* copy = static_cast<char*>(std::malloc(text.size() + 1));
  if (!copy) return nullptr;
  std::memcpy(copy, text.data(), text.size());
  copy[text.size()] = '\0';
  return copy;
}

}  // namespace

char* evenlift_run(const char* json) {
  if (!json) return handed_over(no_request);
  try {
    return handed_over(evenlift::answer(json));
  } catch (const std::bad_alloc&) {
    return handed_over(no_memory);
  } catch (...) {
    return handed_over(unknown);
  }
}

void evenlift_free(char* answer) { std::free(answer); }
