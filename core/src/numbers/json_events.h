// A JSON text as a stream of events: values with their place, numbers as exact doubles, errors as
// InputError. Around nlohmann-json's reader, which neither recurses nor builds a tree.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "evenlift/result.h"

namespace evenlift {

struct JsonValue {
  enum class Kind : std::uint8_t { object, array, string, number, boolean, null };
  Kind kind;
  std::size_t offset;     // of the value's last byte, but the first of an object or array
  double number;          // of a number: the nearest double, finite
  std::string_view text;  // of a string
};

// Takes the events. Each returns whether to go on; a sink that stops has kept the reason.
class JsonSink {
 public:
  virtual bool value(const JsonValue& value) = 0;
  virtual bool key(std::string_view name, std::size_t offset) = 0;  // the next value's
  virtual bool end() = 0;                                           // of an object or array

 protected:
  ~JsonSink() = default;
};

// Reads the whole text into the sink. The error, unless the text is valid JSON or the sink stopped
// first. At most 64 levels of arrays and objects. O(bytes).
std::optional<InputError> read_json(std::string_view text, JsonSink& sink);

}  // namespace evenlift
