// Characters in UTF-8.
#pragma once

#include <cstddef>
#include <string_view>

namespace evenlift {

// The number of bytes in the text's first character; 0 if the text is empty or does not begin with
// a valid UTF-8 character. O(1).
std::size_t utf8_length(std::string_view text);

// Whether the line is UTF-8 without control characters other than tabs and carriage returns.
// O(bytes).
bool is_line_of_text(std::string_view line);

}  // namespace evenlift
