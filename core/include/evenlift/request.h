// Requests and answers as JSON: all that other languages need of evenlift, in one function. The C
// library (c/include/evenlift/evenlift.h), the Python package over it and the package for npm are
// made of it. docs/requests.md is the manual.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "evenlift/document.h"

namespace evenlift {

inline constexpr std::size_t max_request_bytes = max_text_bytes;
inline constexpr std::size_t max_request_polygons = 10000;  // of an experiment

// The answer to a request: one JSON text that ends in a newline. A request that cannot be answered
// gets {"error": {"code", "message", "place"}}. The same request gives the same bytes on every
// platform; what `place` answers is what `evenlift place --json` prints. Any bytes are a request,
// though perhaps a bad one: more than max_request_bytes of them, and text that is not JSON, are
// refused like all else. The cost is that of what is asked for, and O(bytes).
std::string answer(std::string_view request);

}  // namespace evenlift
