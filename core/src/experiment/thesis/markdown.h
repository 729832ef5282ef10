// Writes tables in Markdown.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace evenlift::experiment::markdown {

// A cell that shows the text. Since names may contain any characters, the special characters of
// HTML and Markdown are escaped, and control characters become spaces.
inline std::string cell(std::string_view text) {
  std::string out;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (std::string_view("\\|`*_~[]").find(c) != std::string_view::npos) out += '\\';
    if (c == '<')
      out += "&lt;";
    else if (c == '>')
      out += "&gt;";
    else if (c == '&')
      out += "&amp;";
    else
      out += byte < 0x20 || byte == 0x7f ? ' ' : c;
  }
  return out;
}

inline std::string row(const std::vector<std::string>& cells) {
  std::string text = "|";
  for (const std::string& c : cells) text += " " + c + " |";
  return text + "\n";
}

}  // namespace evenlift::experiment::markdown
