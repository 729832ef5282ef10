// Polygons as text: the thesis's format (appendix A.1), WKT and GeoJSON. Numbers are read and
// written as numbers.h says.
#pragma once

#include <string>
#include <string_view>

#include "evenlift/document.h"
#include "evenlift/result.h"

namespace evenlift {

// Reads a text in whichever of the formats its content shows:
//   thesis   `CoM:(x,y)` on the first line, optional; then a `(x,y)` a line; blank lines and
//            spaces do not matter
//   WKT      `POLYGON ((x y, ...))`; a closing vertex equal to the first is dropped; any case
//   GeoJSON  a `Polygon`, or a `Feature` of one, whose property `centre_of_mass: [x, y]` is taken;
//            other members are left out, but none of these may stand there twice
// Settings are the defaults. Holes, other geometries and third coordinates are refused as
// unsupported; an error names the line. Nothing of the geometry is checked (see Polygon::create).
// Bounded by max_text_bytes and max_vertices. O(bytes).
Result<Document> read_polygon(std::string_view text);

// The document's polygon, and centre of mass if it has one of its own, as text ending in a newline.
// WKT has no place for a centre of mass and leaves it out. O(n).
std::string write_thesis(const Document& document);
std::string write_wkt(const Document& document);
std::string write_geojson(const Document& document);

}  // namespace evenlift
