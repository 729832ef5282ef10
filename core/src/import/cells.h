// The lines and cells of a table: CSV, cells that a spreadsheet copies to the clipboard, or lines
// "x, y".
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "evenlift/document.h"

namespace evenlift {

using Fields = std::vector<std::string_view>;

// A line that is not blank, and no comment unless they are asked for.
struct Line {
  std::string_view text;
  bool after_blank = false;  // a blank line precedes it
  std::size_t number = 0;    // from 1
};

enum class Comments { skipped, returned };

class Lines {
 public:
  explicit Lines(std::string_view text, Comments comments = Comments::skipped)
      : text_(text), comments_(comments) {}

  // The next line, or nothing at the end of the text. O(line).
  std::optional<Line> next();

 private:
  std::string_view text_;
  Comments comments_;
  std::size_t at_ = 0, number_ = 0;
};

// The first of these separators that the line contains outside quotes: tab, semicolon, bar, comma;
// else a space.
char separator_of(std::string_view line);

// The cells of a line, without quotes and spaces around them, and without empty ones at the end. A
// quoted cell may contain the separator, and quotes as "". At most a thousand. O(line).
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
