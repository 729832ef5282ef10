#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace evenlift::testing {

inline std::size_t occurrences(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
    ++found;
  return found;
}

// With a space instead of U+00A0 between number and unit.
inline std::string plainly(std::string text) {
  for (std::size_t at = 0; (at = text.find("\u00A0", at)) != std::string::npos;)
    text.replace(at, std::string("\u00A0").size(), " ");
  return text;
}

// Texts that differ only in what remains here say different things.
inline std::string without_numbers(const std::string& text) {
  std::string rest;
  for (const char c : text)
    if (std::string_view("0123456789.- ").find(c) == std::string_view::npos) rest += c;
  return rest;
}

}  // namespace evenlift::testing
