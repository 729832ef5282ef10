// The core in WebAssembly, without the view: for the page's workers (web/page/core.js) and the
// package for npm (npm/api.js).
#include <emscripten/emscripten.h>
#include <qrcodegen.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <string>
#include <string_view>

#include "derive/derive.h"
#include "evenlift/output/json_text.h"
#include "evenlift/placement.h"
#include "evenlift/wording.h"
#include "modules/kinds.h"

extern "C" {
__attribute__((import_module("host"), import_name("now"))) double host_now();
__attribute__((import_module("host"), import_name("report"))) void host_report(const char* json);
}

namespace evenlift::view {
namespace {

constexpr RequestKind kinds[] = {
    {"speak", {"words"}, speak},
    {"search", {"polygon", "settings", "robots"}, search},
    {"choose", {"settings"}, choose},
    {"measure",
     {"set", "name", "text", "problem", "method", "minRatio", "samples", "weight", "weightUnit",
      "mostTeams", "mostBalanced"},
     measure},
    {"results",
     {"parts", "onePolygon", "minRatio", "samples", "weight", "weightUnit", "mostTeams",
      "mostBalanced"},
     results},
    {"optimum", {"link", "seconds"}, optimum},
    {"cases", {"link"}, cases},
    {"shapes", {"text", "tolerance"}, shapes},
    {"place_parts",
     {"text", "tolerance", "settings", "capacity", "per_area", "thickness", "density"},
     place_parts},
    {"handout", {"link", "lesson"}, handout},
    {"qr", {"text"}, qr_code},
};

}  // namespace

std::vector<double>& numbers() {
  static std::vector<double> passed;
  return passed;
}

std::string problem(std::string_view sentence) {
  return json::object({{"problem", json::text(translated(sentence))}});
}

double now() { return host_now(); }
void report(const std::string& json) { host_report(json.c_str()); }

std::string speak(const RequestMembers& members) {
  for (const auto& [english, translated] : members.named_texts("words"))
    add_translation(english, translated);
  return "{}";
}

std::string choose(const RequestMembers& members) {
  const auto document = read_task(numbers(), members.text("settings"));
  numbers().clear();
  if (document)
    if (const auto placement = place(*document)) numbers() = choice_as_numbers(*placement);
  return "{}";
}

std::string qr_code(const RequestMembers& members) {
  static std::array<std::uint8_t, qrcodegen_BUFFER_LEN_MAX> code, work;
  std::vector<std::string> rows;
  if (qrcodegen_encodeText(members.text("text").c_str(), work.data(), code.data(),
                           qrcodegen_Ecc_LOW, qrcodegen_VERSION_MIN, qrcodegen_VERSION_MAX,
                           qrcodegen_Mask_AUTO, true)) {
    const int size = qrcodegen_getSize(code.data());
    for (int y = 0; y < size; ++y) {
      std::string row;
      for (int x = 0; x < size; ++x) row += qrcodegen_getModule(code.data(), x, y) ? '1' : '0';
      rows.push_back(json::text(row));
    }
  }
  return json::object({{"rows", json::array(rows)}});
}

}  // namespace evenlift::view

namespace {

char* handed_over(const std::string& answer) {
  auto* copy = static_cast<char*>(std::malloc(answer.size() + 1));
  if (copy) std::memcpy(copy, answer.c_str(), answer.size() + 1);
  return copy;
}

}  // namespace

extern "C" {

// Returns 0 if memory is too low. Free with evenlift_free().
EMSCRIPTEN_KEEPALIVE void* evenlift_room(std::size_t bytes) { return std::malloc(bytes); }

EMSCRIPTEN_KEEPALIVE void evenlift_free(void* room) { std::free(room); }

// Room for so many numbers, which come with the next request.
EMSCRIPTEN_KEEPALIVE double* evenlift_numbers(std::size_t count) {
  evenlift::view::numbers().resize(count);
  return evenlift::view::numbers().data();
}

// How many numbers go with the last answer, and where they are.
EMSCRIPTEN_KEEPALIVE std::size_t evenlift_numbers_count() {
  return evenlift::view::numbers().size();
}
EMSCRIPTEN_KEEPALIVE const double* evenlift_numbers_at() {
  return evenlift::view::numbers().data();
}

// Answers a request of docs/requests.md. The answer ends with a zero byte; free it with
// evenlift_free(). Returns 0 if memory is too low.
EMSCRIPTEN_KEEPALIVE char* evenlift_answer(const char* request, std::size_t bytes) {
  return handed_over(evenlift::answer(std::string_view(request, bytes)));
}

// The same for the page's workers, whose requests may also be of the kinds above.
EMSCRIPTEN_KEEPALIVE char* evenlift_answer_page(const char* request, std::size_t bytes) {
  return handed_over(evenlift::answer(std::string_view(request, bytes), evenlift::view::kinds));
}

}  // extern "C"
