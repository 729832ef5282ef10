// Functions for text within SVG and HTML.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace evenlift {

// Returns the text with `&`, `<`, `>` and `"` as entities, for use between tags and in attribute
// values. O(bytes).
std::string escaped(std::string_view text);

// Returns the number of characters in a UTF-8 text. O(bytes).
std::size_t character_count(std::string_view text);

}  // namespace evenlift
