// Reads the sizes of robots and the no-go edges and parts from text, and checks them.
#pragma once

#include <string_view>
#include <vector>

#include "evenlift/document.h"

namespace evenlift {

// Commas separate the words of the text. Calls read(word) for each word in order until a call
// returns false. Returns whether all words were accepted.
template <class Read>
bool for_each_word(std::string_view text, Read read) {
  while (true) {
    const std::size_t comma = text.find(',');
    if (!read(text.substr(0, comma))) return false;
    if (comma == std::string_view::npos) return true;
    text.remove_prefix(comma + 1);
  }
}

// Each function returns whether the text is valid, and changes the setting only if it is. O(bytes).
bool read_size(std::string_view text, double& size);
bool read_robot(std::string_view text, RobotSize& robot);
bool read_no_go(std::string_view text, std::vector<EdgePart>& no_go);

// The first word that is not an edge or part of an edge; empty if there is no such word, or if it
// is not quotable. O(bytes).
std::string_view refused_part(std::string_view text);

// Whether a part of a text can be quoted in a message: at most 40 printable ASCII characters.
// O(bytes).
bool is_quotable(std::string_view part);

// Whether all sizes are in range. O(1).
bool is_robot_size(const RobotSize& robot);
// Whether all parts and their number are in range. O(parts).
bool is_no_go(const std::vector<EdgePart>& no_go);

}  // namespace evenlift
