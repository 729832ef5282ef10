#include "import/other_tables.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "evenlift/predicates.h"
#include "evenlift/vec.h"
#include "import/tables/cells.h"
#include "import/tables/table_headings.h"
#include "numbers/text_cursor.h"

namespace evenlift {
namespace {

constexpr std::size_t first_rows_of_table = 100;

using Table = std::vector<Fields>;

Table rows_of(std::string_view text) {
  Table rows;
  Lines lines(text);
  for (auto line = lines.next(); line && rows.size() < first_rows_of_table; line = lines.next())
    rows.push_back(split_cells(line->text, separator_of(line->text)));
  return rows;
}

// Letters and digits only, in lower case: "x_min" and "X Min" are "xmin". Includes letters beyond
// ASCII.
std::string plain_word(std::string_view heading) {
  std::string word;
  for (const char c : heading)
    if (is_letter(c) || is_digit(c) || static_cast<unsigned char>(c) >= 0x80) word += lower_case(c);
  return word;
}

template <std::size_t n>
bool has_heading(const Fields& headings, const std::array<std::string_view, n>& words) {
  return std::any_of(headings.begin(), headings.end(), [&](std::string_view heading) {
    const std::string word = plain_word(heading);
    return std::find(words.begin(), words.end(), word) != words.end();
  });
}

// Of parts: a length and a width or thickness, but no coordinates.
bool lists_sizes(const Table& rows) {
  constexpr std::array<std::string_view, 7> lengths{"length", "l\u00e4nge", "laenge", "longueur",
                                                    "largo",  "lunghezza",  "lengte"};
  constexpr std::array<std::string_view, 9> widths{"width",   "breite",    "largeur",
                                                   "ancho",   "larghezza", "breedte",
                                                   "breadth", "thickness", "dicke"};
  return has_heading(rows[0], lengths) && has_heading(rows[0], widths) && !named_columns(rows[0]);
}

bool lists_boxes(const Table& rows) {
  constexpr std::array<std::string_view, 2> least{"xmin", "minx"};
  constexpr std::array<std::string_view, 2> greatest{"xmax", "maxx"};
  return has_heading(rows[0], least) && has_heading(rows[0], greatest);
}

bool lists_segments(const Table& rows) {
  constexpr std::array<std::string_view, 2> first{"x1", "startx"}, second{"x2", "endx"};
  constexpr std::array<std::string_view, 2> height{"y1", "starty"};
  return has_heading(rows[0], first) && has_heading(rows[0], second) &&
         has_heading(rows[0], height);
}

std::size_t numbers_after_first(const Fields& cells) {
  const auto numbers = std::count_if(cells.begin() + 1, cells.end(), [](std::string_view cell) {
    return cell_number(cell, false).has_value();
  });
  return static_cast<std::size_t>(numbers);
}

// A row "x" with all x, and one "y" with as many.
bool is_transposed(const Table& rows) {
  std::size_t x = 0, y = 0;
  for (const Fields& cells : rows) {
    if (cells.size() < 4 || numbers_after_first(cells) + 1 != cells.size()) continue;
    if (same_word(cells[0], "x")) x = cells.size();
    if (same_word(cells[0], "y")) y = cells.size();
  }
  return x > 0 && x == y;
}

// Eight numbers in each row, or nine after a class: the corners of a convex quadrilateral.
bool lists_four_corners(const Table& rows) {
  if (rows.size() < 2) return false;  // one row may list the points of a shape
  for (const Fields& cells : rows) {
    if (cells.size() != 8 && cells.size() != 9) return false;
    std::array<Vec2, 4> corners;
    for (std::size_t i = 0; i < 8; ++i) {
      const auto number = cell_number(cells[cells.size() - 8 + i], false);
      if (!number) return false;
      (i % 2 == 0 ? corners[i / 2].x : corners[i / 2].y) = *number;
    }
    std::size_t left = 0, right = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      const double turn = orient(corners[i], corners[(i + 1) % 4], corners[(i + 2) % 4]);
      left += turn > 0 ? 1 : 0;
      right += turn < 0 ? 1 : 0;
    }
    if (left != 4 && right != 4) return false;
  }
  return true;
}

struct KindOfTable {
  bool (*is_kind)(const Table& rows);
  const char* refusal;
};

constexpr KindOfTable table_kinds[] = {
    {lists_sizes, "this table lists sizes of parts (length, width), not coordinates of vertices"},
    {lists_boxes,
     "this table lists boxes (xmin, ymin, xmax, ymax), not vertices: write the corners of one, a line "
     "for each"},
    {lists_segments,
     "this table lists lines from (x1, y1) to (x2, y2), not vertices: save the drawing as DXF or SVG"},
    {is_transposed,
     "this table has all x in one row and all y in another: swap its rows and columns"},
    {lists_four_corners,
     "each row has four corners: write the corners of a shape in a line each, with a blank line "
     "between shapes"},
};

}  // namespace

const char* refusal_of_other_table(std::string_view beginning) {
  const Table rows = rows_of(beginning);
  if (rows.empty()) return nullptr;
  for (const KindOfTable& kind : table_kinds)
    if (kind.is_kind(rows)) return kind.refusal;
  return nullptr;
}

}  // namespace evenlift
