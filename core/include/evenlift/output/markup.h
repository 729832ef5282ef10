// Text within SVG and HTML, and how long it is.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace evenlift {

// The text with `&`, `<`, `>` and `"` written as entities, for between tags and for the values of
// attributes. O(bytes).
std::string escaped(std::string_view text);

// How many characters the UTF-8 text has. O(bytes).
std::size_t character_count(std::string_view text);

}  // namespace evenlift
