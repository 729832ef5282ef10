// Understands headings of tables of coordinates, such as "x (mm)", "POINT_X", "Position X",
// "Easting", "lon".
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "evenlift/document.h"
#include "import/tables/cells.h"

namespace evenlift {

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
  name
};

// What the heading says about its column. O(heading).
Column column_of(std::string_view heading);

// Whether a column may number or name the shapes: "Name", "fid", "part", "Layer". O(heading).
bool may_tell_shapes(std::string_view heading);

// Whether a column has capacities, such as "capacity (kg)"; or these or other amounts, such as "Dia".
// O(heading).
bool tells_capacity(std::string_view heading);
bool tells_amounts(std::string_view heading);

// The words that name columns, such as X and Y in "X coord Y coord". Words such as "coord" are
// passed over. Empty if there is any other word, since the line may be prose. O(words).
Fields names_among(const Fields& words);

// The unit in a heading such as "Easting (m)" or "x_cm"; LengthUnit::none if there is no unit.
// O(heading).
LengthUnit unit_in(std::string_view heading);

struct NamedColumns {
  std::size_t x = 0, y = 0;
  Column meaning = Column::x;          // the meaning of x: x, easting or longitude
  LengthUnit unit = LengthUnit::none;  // the unit of both; none if their units differ
  std::vector<std::size_t> heights;    // columns of heights, which are left out
};

// The columns of x and y, or of easting and northing, or of longitude and latitude: the first of
// these pairs for which there are both headings; nullopt if there is no such pair. If several
// headings name the same coordinate, the plainest wins ("x" rather than "x (mm)"); of equally plain
// ones, the first. O(headings).
std::optional<NamedColumns> named_columns(const Fields& headings);

}  // namespace evenlift
