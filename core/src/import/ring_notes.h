// What the readers of rings leave out or doubt, and the notes about it: one rule for WKT, GeoJSON,
// other JSON and tables.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "evenlift/document.h"
#include "import/gathering.h"

namespace evenlift {

struct RingNotes {
  std::size_t repeated = 0;  // vertices at the place of the one before
  std::size_t heights = 0;   // positions with coordinates beyond x and y
  bool are_degrees = false;  // the text says that coordinates are longitudes and latitudes
  // The note about these.
  std::string_view in_degrees =
      "the coordinates are degrees of longitude and latitude, not lengths";

  // Drops each vertex that equals the one before it and counts it; the last vertex of a ring may
  // equal the first. O(n).
  void drop_repeated(Points& ring);
  // Adds the notes to an import with all its shapes. O(vertices).
  void add_to(Gathering& gathering) const;
};

// The smallest box around all vertices. O(vertices).
Box box_of(const std::vector<ImportedShape>& shapes);

// Whether these are the codes of a reference system in degrees: WGS 84 and the national ones that
// files most often have. O(1).
bool is_in_degrees(double code);

}  // namespace evenlift
