// Polygons as text: the thesis's format (appendix A.1), WKT and GeoJSON. numbers.h defines the
// syntax of numbers.
#pragma once

#include <string>
#include <string_view>

#include "evenlift/document.h"
#include "evenlift/result.h"

namespace evenlift {

// Reads a text. The content determines the format:
//   thesis   optionally `CoM:(x,y)` on the first line, then one `(x,y)` on each line; blank lines
//            and spaces are ignored
//   WKT      `POLYGON ((x y, ...))` in upper or lower case; a closing vertex is dropped
//   GeoJSON  a `Polygon`, or a `Feature` with one, optionally with a property
//            `centre_of_mass: [x, y]`; other members are ignored, and a duplicate of one of these
//            members is an error
// The settings are the defaults. Holes, other geometries and third coordinates are unsupported. An
// error's place is the line and column. The geometry is not checked; Polygon::create does that.
// Bounded by max_text_bytes and max_vertices. O(bytes).
Result<Document> read_polygon(std::string_view text);

// The document's polygon as text that ends in a newline, with its centre of mass if the document
// has one. WKT cannot hold a centre of mass and omits it. O(n).
std::string write_thesis(const Document& document);
std::string write_wkt(const Document& document);
std::string write_geojson(const Document& document);

}  // namespace evenlift
