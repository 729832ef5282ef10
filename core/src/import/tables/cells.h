// Splits a table into lines and cells. The table may be CSV, cells copied from a spreadsheet, or
// lines "x, y".
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "evenlift/document.h"

namespace evenlift {

using Fields = std::vector<std::string_view>;

// A line that has more than separators and spaces. Comments, which are lines that begin with #, are
// skipped unless Comments::returned asks for them.
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

// The separator of cells: a tab if the line contains one, else a semicolon, else a bar, else a
// comma, else a space. Separators in quotation marks do not count.
char separator_of(std::string_view line);

// Splits a line into cells and returns at most the first 1000, without empty cells at the end. The
// quotation marks and spaces around each cell are left out. A quoted cell may contain the
// separator, and quotation marks that are doubled (""). O(line).
Fields split_cells(std::string_view line, char separator);

// The cell's number; nullopt if the cell is not a number. With `decimal_comma`, a comma may precede
// the decimals. O(cell).
std::optional<double> cell_number(std::string_view cell, bool decimal_comma);

// Whether the heading names the coordinate `name`. If `name` is x, this is true of "x", "X", "x_mm"
// and "x (m)", but not of "xml" or "share_of_x".
bool names_column(std::string_view heading, char name);

// The unit at the end of a heading that names a coordinate, such as "x (mm)", "x_cm" or "X [m]";
// LengthUnit::none if there is no unit.
LengthUnit unit_of_column(std::string_view heading);

// Whether one of the cells is this word, in upper or lower case.
bool has_field(const Fields& fields, std::string_view name);

}  // namespace evenlift
