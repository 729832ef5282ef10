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

// Returns a UTF-8 text of at most `most` characters, at least 1: a longer one ends in "…". O(bytes).
std::string shortened(std::string_view text, std::size_t most);

// What a picture writes beside a robot: its name, of at most 16 characters, and its load, of which either
// may be empty. O(bytes).
std::string robot_label(std::string_view name, const std::string& load);

}  // namespace evenlift
