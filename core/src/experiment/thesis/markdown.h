// Tables in Markdown.
#pragma once

#include <string>
#include <vector>

namespace evenlift::experiment::markdown {

// A text as a cell; names of polygons and sets may hold anything.
inline std::string cell(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '|' || c == '\\') out += '\\';
    out += c == '\n' || c == '\r' ? ' ' : c;
  }
  return out;
}

// A line of cells.
inline std::string row(const std::vector<std::string>& cells) {
  std::string text = "|";
  for (const std::string& c : cells) text += " " + c + " |";
  return text + "\n";
}

}  // namespace evenlift::experiment::markdown
