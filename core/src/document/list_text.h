// Reads lists of items that are separated by spaces, tabs and line ends.
#pragma once

#include <algorithm>
#include <string_view>

#include "document/setting_values.h"

namespace evenlift {

// Calls read(item) for each item in order until a call returns false. Spaces, tabs and line ends
// between quotation marks are part of an item. Returns whether all items were accepted. O(bytes).
template <class Read>
bool for_each_item(std::string_view text, Read read) {
  constexpr std::string_view spaces = " \t\r\n";
  while (true) {
    text.remove_prefix(std::min(text.find_first_not_of(spaces), text.size()));
    if (text.empty()) return true;
    bool quoted = false;
    const auto end = std::find_if(text.begin(), text.end(), [&](char c) {
      if (c == '"') quoted = !quoted;
      return !quoted && spaces.find(c) != std::string_view::npos;
    });
    const auto size = static_cast<std::size_t>(end - text.begin());
    if (!read(text.substr(0, size))) return false;
    text.remove_prefix(size);
  }
}

// The first item that cannot be read; empty if all can be read, or if that item is not quotable
// (is_quotable() of stand_settings.h). `read` returns the meaning of an item, or nothing. O(bytes).
template <class Read>
std::string_view refused_item(std::string_view text, Read read) {
  std::string_view refused;
  for_each_item(text, [&](std::string_view item) {
    if (read(item)) return true;
    refused = item;
    return false;
  });
  return is_quotable(refused) ? refused : std::string_view();
}

}  // namespace evenlift
