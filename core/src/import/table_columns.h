// Finds the columns of x and y in a table whose headings do not name them.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "import/tables/table_headings.h"

namespace evenlift {

struct CellStyle {
  char separator = ' ';
  bool decimal_comma = false;  // decimal commas are allowed
};

// The indices of the columns whose cells in this row are numbers. O(cells).
std::vector<std::size_t> number_columns(const Fields& cells, const CellStyle& style);

// Whether each cell is empty, or has a digit and otherwise only characters that numbers can have.
// O(cells).
bool has_only_digits(const Fields& cells);

// The style of the first line that begins with a number and has two numbers. If there is none, the
// style is that of the first line with two numbers, which may follow a name, or else that of the
// first line with a digit. Decimal commas are allowed if tabs, semicolons or bars separate cells.
// If commas do, decimal commas are allowed only if a quoted cell has a comma that cannot separate
// thousands. Only the first 200 lines count. O(first lines).
CellStyle style_of_table(std::string_view text);

// Whether all cells of a column are words, or whole numbers from 0 to 9999. O(bytes).
bool has_words_or_counts(std::string_view rows, const CellStyle& style, std::size_t column);

// Returns those of `columns`, at most the first 64, that consist of two or more runs, each of at
// least three equal cells. Columns that number or name the shapes have such runs. Columns of
// coordinates do not, since the vertices of each run would be on one line. Before these stand the
// columns that name the parts of such runs: each name has one run of three cells or more, or one
// cell, and two names have three or more. O(bytes log rows).
std::vector<std::size_t> columns_of_shapes(std::string_view rows, const CellStyle& style,
                                           const std::vector<std::size_t>& columns);

struct ChosenColumns {
  std::size_t x = 0, y = 0;
  std::vector<std::size_t> shapes;  // the columns that number the shapes
  std::string note;                 // empty if no other columns have numbers
};

// Chooses x and y among the columns, at least two, with a number in the first row. While more than
// two of these remain, it drops, in this order: the first column, if it numbers the shapes; columns
// headed as point numbers or heights; columns that are the same in every line; columns that number
// the points. The first two of the remaining columns are x and y. `rows` begins with the first row.
// There may be fewer headings than columns. O(bytes).
ChosenColumns choose_columns(std::string_view rows, const CellStyle& style, const Fields& first_row,
                             const Fields& headings);

}  // namespace evenlift
