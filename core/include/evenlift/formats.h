// Polygons with holes as text: the thesis's format (appendix A.1), WKT and GeoJSON. numbers.h
// defines the syntax of numbers.
#pragma once

#include <string>
#include <string_view>

#include "evenlift/document.h"
#include "evenlift/result.h"

namespace evenlift {

// Reads a text. The content determines the format:
//   thesis   optionally `CoM:(x,y)` on the first line, then the vertices of the outline, one
//            `(x,y)` on each line; then for each hole a line `Hole:` and its vertices in the same
//            way; then for each item of cargo a line `Cargo:(x,y) weight name`, in which the name
//            may be missing. Blank lines and spaces are ignored, also those around a name
//   WKT      `POLYGON ((x y, ...), ...)` in upper or lower case, or a MULTIPOLYGON of one; the
//            first ring is the outline, and the others are holes; closing vertices are dropped
//   GeoJSON  a `Polygon`, or a `Feature` with one, optionally with a property
//            `centre_of_mass: [x, y]`; rings as in WKT; other members are ignored, but a member
//            that is read may not occur twice
// All settings except the cargo have their defaults. Other geometries and third coordinates are
// unsupported. An error's place is the line and column. Weights and names of cargo are within their
// bounds (document.h). The geometry is not checked; object_of() (polygon_with_holes.h) does that.
// Bounded by max_text_bytes, max_vertices for all rings together, max_holes and max_cargo.
// O(bytes).
Result<Document> read_polygon(std::string_view text);

// The document's polygon with its holes as text that ends in a newline, with its centre of mass if
// the document has one. WKT cannot hold a centre of mass and omits it. Only the thesis's format
// holds cargo. O(n).
std::string write_thesis(const Document& document);
std::string write_wkt(const Document& document);
std::string write_geojson(const Document& document);

}  // namespace evenlift
