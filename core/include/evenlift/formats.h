// Reads and writes polygons with holes as text, in the thesis's format (appendix A.1), WKT and
// GeoJSON. The syntax of numbers is that of numbers.h or, in GeoJSON, that of JSON.
#pragma once

#include <string>
#include <string_view>

#include "evenlift/document.h"
#include "evenlift/result.h"

namespace evenlift {

// Reads the thesis's format: the first line may be `CoM:(x,y)`, the centre of mass. A line `(x,y)`
// follows for each vertex of the outline. Each hole has a line `Hole:` and the lines of its vertices.
// Each item of cargo has a line `Cargo:(x,y) weight name`, in which the name may be missing. Blank
// lines and spaces are ignored, except for spaces within a name. The document has the default
// settings, except for the cargo. The place of an error in the text is a line and a column. The
// weights and names of cargo are checked here, by the rules of document.h, but the geometry is checked
// only by object_of() (polygon_with_holes.h). The limits are max_text_bytes, max_vertices for all
// rings together, max_holes and max_cargo. O(bytes).
Result<Document> read_thesis(std::string_view text);

// Reads the one polygon of a text in the thesis's format, WKT or GeoJSON. read_shapes() (import.h)
// reads these in the same way, also several polygons and all other formats, and says what it leaves
// out. O(bytes).
Result<Document> read_polygon(std::string_view text);

// Write the polygon with its holes as text that ends in a newline. A given centre of mass is
// written, except in WKT, which cannot hold one. Only the thesis's format holds cargo. O(n).
std::string write_thesis(const Document& document);
std::string write_wkt(const Document& document);
std::string write_geojson(const Document& document);

// In robot poses as YAML (output/poses.h), comments before a pose begin with these words: the robot's name, as a text in
// JSON, and the points where one with a size lifts and touches the object. import.h reads them back.
inline constexpr std::string_view poses_name = "name", poses_lift = "lifts at",
                                  poses_touch = "touches at";

}  // namespace evenlift
