// The settings for the stands of robots, from text.
#pragma once

#include <string_view>
#include <vector>

#include "evenlift/document.h"

namespace evenlift {

// Calls read(word) for the words between commas until it refuses one. Returns whether all words
// were accepted.
template <class Read>
bool for_each_word(std::string_view text, Read read) {
  while (true) {
    const std::size_t comma = text.find(',');
    if (!read(text.substr(0, comma))) return false;
    if (comma == std::string_view::npos) return true;
    text.remove_prefix(comma + 1);
  }
}

// Each of these returns whether the text is valid, and changes the setting only then. O(bytes).
bool read_size(std::string_view text, double& size);
bool read_robot(std::string_view text, RobotSize& robot);
bool read_no_go(std::string_view text, std::vector<EdgePart>& no_go);

// The first word that is not an edge or part of an edge; empty if there is no such word, or if it
// is not quotable. O(bytes).
std::string_view refused_part(std::string_view text);

// Whether a part is short and plain enough to quote in a message. O(bytes).
bool is_quotable(std::string_view part);

// Whether the sizes, or the parts, are in their ranges. O(1) for sizes, O(parts) for parts.
bool is_robot_size(const RobotSize& robot);
bool is_no_go(const std::vector<EdgePart>& no_go);

}  // namespace evenlift
