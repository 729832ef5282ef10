// Headings of tables of coordinates: "x (mm)", "POINT_X", "Position X", "Easting", "lon".
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "evenlift/document.h"
#include "import/cells.h"

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

// The words that name columns, such as X and Y in "X coord Y coord". Empty if there is any other
// word, since the line may be prose. O(words).
Fields names_among(const Fields& words);

// The unit in a heading such as "Easting (m)" or "x_cm"; LengthUnit::none if there is no unit.
// O(heading).
LengthUnit unit_in(std::string_view heading);

struct NamedColumns {
  std::size_t x = 0, y = 0;
  Column meaning = Column::x;          // the meaning of x: x, easting or longitude
  LengthUnit unit = LengthUnit::none;  // the unit of both
  std::vector<std::size_t> heights;    // columns of heights, which are left out
};

// The first of these pairs of which the headings name both parts: x and y, easting and northing,
// longitude and latitude. If several headings name the same part, the plainest name wins; among
// equals, the first. O(headings).
std::optional<NamedColumns> named_columns(const Fields& headings);

}  // namespace evenlift
