// Requests and answers as JSON: one function that other languages can call. The C library
// (c/include/evenlift/evenlift.h), the Python package built on it, and the npm package call this
// function. docs/requests.md is the manual.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "evenlift/document.h"

namespace evenlift {

inline constexpr std::size_t max_request_bytes = max_text_bytes;
inline constexpr std::size_t max_request_polygons = 10000;  // in an experiment

// Returns the answer to a request: one JSON text that ends in a newline. An invalid request, such
// as one that is not JSON or has more than max_request_bytes, yields {"error": {"code", "message",
// "place"}}. The same request gives the same bytes on every platform; the answer to `place` is the
// output of `evenlift place --json`. O(bytes), plus the cost of the requested computation.
std::string answer(std::string_view request);

}  // namespace evenlift
