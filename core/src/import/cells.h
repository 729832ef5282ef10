// The lines and cells of a table: CSV, cells that a spreadsheet copies to the clipboard, or lines
// "x, y".
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "evenlift/document.h"

namespace evenlift {

using Fields = std::vector<std::string_view>;

// A line that is neither blank nor a comment.
struct Line {
  std::string_view text;
  bool after_blank = false;  // a blank line precedes it
};

class Lines {
 public:
  explicit Lines(std::string_view text) : text_(text) {}

  // The next line, or nothing at the end of the text. O(line).
  std::optional<Line> next();

 private:
  std::string_view text_;
  std::size_t at_ = 0;
};

// The first of these separators that the line contains: tab, semicolon, bar, comma; else a space.
char separator_of(std::string_view line);

// The cells of a line, without quotes and spaces around them, and without empty ones at the end. A
// quoted cell may contain the separator. At most a thousand. O(line).
Fields split_cells(std::string_view line, char separator);

// The number in a cell; with `decimal_comma` a comma may precede its decimals. O(cell).
std::optional<double> cell_number(std::string_view cell, bool decimal_comma);

// Whether the heading names the column of a coordinate: "x", "X", "x_mm", "x (m)", but not "xml" or
// "share_of_x".
bool names_column(std::string_view heading, char name);

// The unit at the end of the heading of such a column: "x (mm)", "x_cm", "X [m]"; none without one.
LengthUnit unit_of_column(std::string_view heading);

// Whether a cell is this word, in any case.
bool has_field(const Fields& fields, std::string_view name);

}  // namespace evenlift
