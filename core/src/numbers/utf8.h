// The characters of a text in UTF-8.
#pragma once

#include <cstddef>
#include <string_view>

namespace evenlift {

// The length in bytes of the character at the front, or 0 if the text is empty or its first bytes are
// no character of UTF-8. O(1).
std::size_t utf8_length(std::string_view text);

// Whether bytes are UTF-8 without control characters other than tabs and carriage returns. O(bytes).
bool is_line_of_text(std::string_view line);

}  // namespace evenlift
