// A table's lines and cells: CSV, cells copied from a spreadsheet, or lines "x, y".
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "evenlift/document.h"

namespace evenlift {

using Fields = std::vector<std::string_view>;

// A line that is not blank. Comments are skipped, unless Comments::returned asks for them.
struct Line {
  std::string_view text;
  bool after_blank = false;
  std::size_t number = 0;  // from 1
};

enum class Comments { skipped, returned };

class Lines {
 public:
  explicit Lines(std::string_view text, Comments comments = Comments::skipped)
      : text_(text), comments_(comments) {}

  // The next line; nullopt at the end of the text. O(line).
  std::optional<Line> next();

 private:
  std::string_view text_;
  Comments comments_;
  std::size_t at_ = 0, number_ = 0;
};

// The separator of cells: the first of tab, semicolon, bar and comma that the line has outside
// quotes, or a space if it has none of them.
char separator_of(std::string_view line);

// Splits a line into at most 1000 cells, without the quotes and spaces around them, and without
// empty cells at the end. A quoted cell may contain the separator, and quotes as "". O(line).
Fields split_cells(std::string_view line, char separator);

// The cell's number; nullopt if the cell is not a number. With `decimal_comma` a comma may precede
// the decimals. O(cell).
std::optional<double> cell_number(std::string_view cell, bool decimal_comma);

// Whether the heading names this coordinate: "x", "X", "x_mm", "x (m)", but not "xml" or
// "share_of_x".
bool names_column(std::string_view heading, char name);

// The unit at the end of a heading that names a coordinate, such as "x (mm)", "x_cm" or "X [m]";
// LengthUnit::none if there is no unit.
LengthUnit unit_of_column(std::string_view heading);

// Whether one of the cells is this word, in any case.
bool has_field(const Fields& fields, std::string_view name);

}  // namespace evenlift
