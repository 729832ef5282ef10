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
  number,  // of a point: "OBJECTID", "Point No.", "#"
  name
};

// O(heading).
Column column_of(std::string_view heading);

// Whether a column may number or name the shapes: "Name", "fid", "part", "Layer". O(heading).
bool may_tell_shapes(std::string_view heading);

// The names in "X coord Y coord"; none if there is another word, since the line may be prose.
// O(words).
Fields names_among(const Fields& words);

// As in "Easting (m)" or "x_cm"; none without one. O(heading).
LengthUnit unit_in(std::string_view heading);

struct NamedColumns {
  std::size_t x = 0, y = 0;
  Column meaning = Column::x;          // of x: x, easting or longitude
  LengthUnit unit = LengthUnit::none;  // of both
  std::vector<std::size_t> heights;    // left out
};

// The first of these pairs of which the headings name both: x and y, easting and northing, longitude
// and latitude. The plainest names win, then the
// first. O(headings).
std::optional<NamedColumns> named_columns(const Fields& headings);

}  // namespace evenlift
