// Any bytes as a request: the answer is one or more lines of JSON, the same when repeated.
#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>

#include "evenlift/request.h"
#include "fuzz/fuzz.h"
#include "numbers/json_tree.h"
#include "request/read_request.h"

namespace {

using namespace evenlift;

struct AnyJson final : JsonSink {
  bool value(const JsonValue&) override { return true; }
  bool key(std::string_view, std::size_t) override { return true; }
  bool end() override { return true; }
};

// Without the largest searches, which the benchmarks time.
bool is_quick(const Request& request) {
  const Settings& settings = request.document.settings;
  if (request.command == Command::experiment)
    return request.polygons.size() <= 1 && request.experiment.samples <= 3 &&
           request.experiment.most_teams <= 5 && request.experiment.most_balanced <= 3;
  return request.document.vertices.size() <= 100 && settings.robots <= 6 &&
         settings.teams.value_or(1) <= 1000 &&
         (!request.document.shown.capacity || settings.method != Method::balanced);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text = fuzz::text_of(data, size);
  const Result<RequestReader> reader = RequestReader::read(text);
  const Result<Request> request = reader ? reader->request() : reader.error();
  if (request && !is_quick(*request)) return 0;
  const std::string first = answer(text);
  fuzz::require(!first.empty() && first.front() == '{' && first.back() == '\n');
  fuzz::require(first.find('\0') == std::string::npos);
  AnyJson any;
  fuzz::require(!read_json(first, any));
  fuzz::require(request.ok() || first.starts_with("{\"error\": "));
  fuzz::require(answer(text) == first);
  return 0;
}
