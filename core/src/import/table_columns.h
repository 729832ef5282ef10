// Which columns of a table are x and y when no heading says so.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "import/cells.h"

namespace evenlift {

// How the cells of a table are parted and written.
struct CellStyle {
  char separator = ' ';
  bool decimal_comma = false;  // allowed
};

// The cells that are numbers. O(cells).
std::vector<std::size_t> number_columns(const Fields& cells, const CellStyle& style);

// Whether every cell that is not empty has a digit and no other characters than numbers have. O(cells).
bool has_only_digits(const Fields& cells);

// Takes the style of the first line that begins with a number and has two of them, even for a
// heading before it; else of the first line with two numbers, such as a name before them; else of
// the first line with a digit. Where commas part the cells, decimal commas are allowed if quoted cells
// of the first lines can have nothing else. O(first lines).
CellStyle style_of_table(std::string_view text);

// Those of the columns whose cells come in two runs or more of at least three equal ones, as the
// numbers or names of shapes do. No coordinate does: three vertices in a row would be on one line.
// O(bytes).
std::vector<std::size_t> columns_of_shapes(std::string_view rows, const CellStyle& style,
                                           const std::vector<std::size_t>& columns);

struct ChosenColumns {
  std::size_t x = 0, y = 0;
  std::vector<std::size_t> shapes;  // they number the shapes
  std::string note;                 // empty if the table has no other columns of numbers
};

// Chooses two of the columns with numbers of the first row: not those whose headings name numbers
// of points or heights, not those that stay the same, and not those that number the lines, as long
// as two others are there. `rows` is the text from the first row on; the headings may be fewer than
// the columns. At least two columns must have numbers. O(bytes).
ChosenColumns choose_columns(std::string_view rows, const CellStyle& style, const Fields& first_row,
                             const Fields& headings);

}  // namespace evenlift
