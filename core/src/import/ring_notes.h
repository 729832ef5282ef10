// Counts the vertices and heights that readers leave out of rings, and writes notes about these and
// about coordinates in degrees. The readers of WKT, GeoJSON, other JSON, Python and tables use
// RingNotes.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "evenlift/document.h"
#include "import/gathering.h"

namespace evenlift {

struct RingNotes {
  std::size_t repeated = 0;  // vertices at the place of the preceding one
  std::size_t heights = 0;   // positions with coordinates beyond x and y
  bool are_degrees = false;  // the text says that its coordinates are degrees
  // The note about degrees.
  std::string_view in_degrees =
      "the coordinates are degrees of longitude and latitude, not lengths";

  // Drops and counts vertices equal to the one before, but not a last one equal to the first. O(n).
  void drop_repeated(Points& ring);
  // Adds the notes to the import, which must already have all its shapes. O(vertices).
  void add_to(Gathering& gathering) const;
};

// The box around all vertices. O(vertices).
Box box_of(const std::vector<ImportedShape>& shapes);

// Whether the reference system with this EPSG code has coordinates in degrees. The function knows
// only WGS 84 and the other such systems that are most common in files. O(1).
bool is_in_degrees(double code);

}  // namespace evenlift
