// Reads a JSON text as a sequence of events, each with its place. It wraps the event reader of
// nlohmann-json, which neither recurses nor builds a tree.
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
  std::size_t offset;     // the first byte of an object or array, the last byte of other values
  double number;          // for a number: the nearest double, finite
  std::string_view text;  // for a string
};

// Receives the events. Each function returns whether to continue. A sink that stops the reader
// stores the reason itself.
class JsonSink {
 public:
  virtual bool value(const JsonValue& value) = 0;
  virtual bool key(std::string_view name, std::size_t offset) = 0;  // the name of the next value
  virtual bool end() = 0;                                           // the end of an object or array

 protected:
  ~JsonSink() = default;
};

// Reads the text and calls the sink. Returns an error if the text is not valid JSON or nests arrays
// and objects more than 64 deep; nullopt if it is valid or the sink stopped first. O(bytes).
std::optional<InputError> read_json(std::string_view text, JsonSink& sink);

}  // namespace evenlift
