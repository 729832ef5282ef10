// Tables: lines, cells, and what headings mean.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "evenlift/document.h"

namespace evenlift {

// --- Splits a table into lines and cells. The table may be CSV, cells copied from a spreadsheet, or
// lines "x, y".

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

// --- Understands headings of tables of coordinates, such as "x (mm)", "POINT_X", "Position X",
// "Easting", "lon".

enum class Column : std::uint8_t {
  other,
  x,
  y,
  easting,
  northing,
  longitude,
  latitude,
  height,  // z
  number,  // the number of a point: "OBJECTID", "Point No.", "#"
  name,
  support,   // what numbers or names a support: "jack", "Stütze"
  capacity,  // "SWL (kg)", "Tragkraft", "max. load"
  load,      // what a support reads: "reading (lb)", "Last", "kg"
  size,      // of a round hole: "Dia"
  thickness
};

// What the heading says about its column as one of coordinates: one of those up to `name`. O(heading).
Column column_of(std::string_view heading);

// What the heading says about its column besides coordinates: one of those from `name` on, or other. O(heading).
Column content_of(std::string_view heading);

// The kilograms in the unit of weight that the heading states in brackets, or as its last word: "load
// (kN)", "reading lb". Nothing without brackets or such a word; 0 for an unknown unit in brackets. O(heading).
std::optional<double> weight_unit_in(std::string_view heading);

// Whether a column may number or name the shapes: "Name", "fid", "part", "Layer". O(heading).
bool may_tell_shapes(std::string_view heading);

// The words that name columns, such as X and Y in "X coord Y coord". Words such as "coord" are
// passed over. Empty if there is any other word, since the line may be prose. O(words).
Fields names_among(const Fields& words);

// The unit in a heading such as "Easting (m)" or "x_cm"; LengthUnit::none if there is no unit.
// O(heading).
LengthUnit unit_in(std::string_view heading);

// Whether the heading says that its column is in feet, other than those of a survey. O(heading).
bool is_in_feet(std::string_view heading);
inline constexpr double inches_of_a_foot = 12;

struct NamedColumns {
  std::size_t x = 0, y = 0;
  Column meaning = Column::x;          // the meaning of x: x, easting or longitude
  LengthUnit unit = LengthUnit::none;  // the unit of both; none if their units differ
  bool is_in_feet = false;             // both are in feet, and `unit` is inches: multiply by 12
  std::vector<std::size_t> heights;    // columns of heights, which are left out
};

// The columns of x and y, or of easting and northing, or of longitude and latitude: the first of
// these pairs for which there are both headings; nullopt if there is no such pair. If several
// headings name the same coordinate, the plainest wins ("x" rather than "x (mm)"); of equally plain
// ones, the first. O(headings).
std::optional<NamedColumns> named_columns(const Fields& headings);

}  // namespace evenlift
