// Text in UTF-8.
#pragma once

#include <cstddef>
#include <string_view>

namespace evenlift {

// Whether bytes are UTF-8 without control characters other than tabs and carriage returns. O(bytes).
bool is_line_of_text(std::string_view line);

// The number of characters in UTF-8. O(bytes).
std::size_t count_characters(std::string_view text);

}  // namespace evenlift
