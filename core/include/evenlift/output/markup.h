// Text within SVG and HTML.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace evenlift {

// With `&`, `<`, `>` and `"` as entities, for use between tags and in attribute values. O(bytes).
std::string escaped(std::string_view text);

// In a UTF-8 text. O(bytes).
std::size_t character_count(std::string_view text);

}  // namespace evenlift
