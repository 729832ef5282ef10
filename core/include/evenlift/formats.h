// Polygons with holes as text: the thesis's format (appendix A.1), WKT and GeoJSON. The syntax of
// numbers is in numbers.h.
#pragma once

#include <string>
#include <string_view>

#include "evenlift/document.h"
#include "evenlift/result.h"

namespace evenlift {

// Reads a text as a polygon. The content of the text determines the format:
//   thesis   optionally `CoM:(x,y)` on the first line; then the vertices of the outline, a line
//            `(x,y)` for each; for each hole a line `Hole:` and its vertices; for each item of
//            cargo a line `Cargo:(x,y) weight name`, perhaps without the name. Blank lines and
//            spaces are ignored, also around a name
//   WKT      `POLYGON ((x y, ...), ...)` in upper or lower case, or a MULTIPOLYGON of one. Rings
//            after the first are holes; closing vertices are dropped
//   GeoJSON  a `Polygon`, or a `Feature` with one, optionally with a property `centre_of_mass: [x,
//            y]`; rings as in WKT. Members that are not read are ignored; the others may occur only
//            once
// All settings except the cargo have their defaults. Other geometries and third coordinates are
// unsupported. An error's place is the line and column. Weights and names of cargo are checked
// here (document.h), but object_of() (polygon_with_holes.h) checks the geometry. The limits are
// max_text_bytes, max_vertices for all rings together, max_holes and max_cargo. O(bytes).
Result<Document> read_polygon(std::string_view text);

// Write the polygon with its holes as text that ends in a newline. A given centre of mass is
// written, except in WKT, which cannot hold one. Only the thesis's format holds cargo. O(n).
std::string write_thesis(const Document& document);
std::string write_wkt(const Document& document);
std::string write_geojson(const Document& document);

}  // namespace evenlift
