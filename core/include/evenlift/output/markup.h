// Text within SVG and HTML.
#pragma once

#include <string>
#include <string_view>

namespace evenlift {

// The text with `&`, `<`, `>` and `"` written as entities, for between tags and for the values of
// attributes. O(bytes).
std::string escaped(std::string_view text);

}  // namespace evenlift
