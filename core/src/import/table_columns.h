// Finds x and y without headings.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "import/cells.h"

namespace evenlift {

struct CellStyle {
  char separator = ' ';
  bool decimal_comma = false;  // decimal commas are allowed
};

// The numbers of the columns whose cells are numbers. O(cells).
std::vector<std::size_t> number_columns(const Fields& cells, const CellStyle& style);

// Whether each cell is empty, or has a digit and only characters of numbers. O(cells).
bool has_only_digits(const Fields& cells);

// The style of the first line that begins with a number and has two numbers, even before headings.
// If there is no such line, it is the style of the first line with two numbers, such as after a
// name; without one, of the first line with a digit. Where commas part cells, decimal commas are
// allowed if the commas in quoted cells of the first lines can be nothing else. O(first lines).
CellStyle style_of_table(std::string_view text);

// The numbers of those `columns` that consist of two or more runs, each of at least three equal
// cells. Numbers and names of shapes do. Coordinates do not: three vertices in a row would be on
// one line. O(bytes).
std::vector<std::size_t> columns_of_shapes(std::string_view rows, const CellStyle& style,
                                           const std::vector<std::size_t>& columns);

struct ChosenColumns {
  std::size_t x = 0, y = 0;
  std::vector<std::size_t> shapes;  // the columns that number the shapes
  std::string note;                 // empty if no other columns have numbers
};

// Chooses two of the columns with numbers in the first row. It drops a first column that numbers
// the shapes, columns whose headings name numbers of points or heights, columns that stay the same,
// and columns that number the lines, as long as two others remain. `rows` begins with the first
// row. There may be fewer headings than columns. At least two columns must have numbers. O(bytes).
ChosenColumns choose_columns(std::string_view rows, const CellStyle& style, const Fields& first_row,
                             const Fields& headings);

}  // namespace evenlift
