// Requests and answers as JSON: one function that other languages can call. The C library
// (c/include/evenlift/evenlift.h), the Python package built on it, and the npm package call this
// function. docs/requests.md is the manual.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "evenlift/document.h"

namespace evenlift {

inline constexpr std::size_t max_request_bytes = max_text_bytes;
inline constexpr std::size_t max_request_polygons = 10000;  // in an experiment

// Returns the answer to a request: one JSON text that ends in a newline. An invalid request, such
// as one that is not JSON or has more than max_request_bytes, yields {"error": {"code", "message",
// "place"}}. The same request gives the same bytes on every platform; the answer to `place` is the
// output of `evenlift place --json`. O(bytes), plus the cost of the requested computation.
std::string answer(std::string_view request);

// The members of a request. A member that is missing, or of another kind, is empty, or NaN.
// O(members) each, plus O(contents).
class RequestMembers {
 public:
  virtual std::string text(std::string_view name) const = 0;
  virtual double number(std::string_view name) const = 0;
  // The strings of an array, and the names and strings of an object.
  virtual std::vector<std::string> texts(std::string_view name) const = 0;
  virtual std::vector<std::pair<std::string, std::string>> named_texts(
      std::string_view name) const = 0;

 protected:
  ~RequestMembers() = default;
};

// A kind of request that a program adds to those above, and the members that it may have next to
// "command". The function returns the answer, without the newline.
struct RequestKind {
  using Names = std::array<std::string_view, 12>;  // of which the last may be empty

  std::string_view command;
  Names members;
  std::string (*answer)(const RequestMembers& members);
};

// As above, but first looks for the command among these kinds. The request may be longer: the text
// of a file, which may have max_text_bytes, is longer as JSON, and so are many results.
inline constexpr std::size_t max_bytes_of_own_kinds = 8 * max_request_bytes;
std::string answer(std::string_view request, std::span<const RequestKind> kinds);

}  // namespace evenlift
