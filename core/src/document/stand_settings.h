// The settings of where robots can stand, from text.
#pragma once

#include <string_view>
#include <vector>

#include "evenlift/document.h"

namespace evenlift {

// Calls read(word) for each word between commas until one of them is refused. Returns whether none
// is.
template <class Read>
bool for_each_word(std::string_view text, Read read) {
  while (true) {
    const std::size_t comma = text.find(',');
    if (!read(text.substr(0, comma))) return false;
    if (comma == std::string_view::npos) return true;
    text.remove_prefix(comma + 1);
  }
}

// Each returns whether the text is a value of its setting, and changes the setting only then.
// O(bytes).
bool read_size(std::string_view text, double& size);
bool read_robot(std::string_view text, RobotSize& robot);
bool read_no_go(std::string_view text, std::vector<EdgePart>& no_go);

// The first word that is no edge or part of one; empty if all are, or if it is too long or strange
// to be quoted. O(bytes).
std::string_view refused_part(std::string_view text);

// Whether the values are in their ranges. O(1) and O(parts).
bool is_robot_size(const RobotSize& robot);
bool is_no_go(const std::vector<EdgePart>& no_go);

}  // namespace evenlift
