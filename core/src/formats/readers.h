// The readers of the thesis's format, WKT and GeoJSON, and the parts that they share. Each reader
// reads a whole text, which must not begin with a byte-order mark. read_polygon() in formats.cpp
// chooses the reader.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

#include "evenlift/document.h"
#include "evenlift/result.h"
#include "numbers/text_cursor.h"

namespace evenlift {

Result<Document> read_thesis(std::string_view text);
Result<Document> read_wkt(std::string_view text);
Result<Document> read_geojson(std::string_view text);

// Messages that the readers share.
inline constexpr char no_third_coordinate[] = "coordinates beyond x and y are not supported";
inline constexpr char no_more_vertices[] = "the polygon has more than 1048576 vertices";
inline constexpr char no_vertices[] = "the polygon has no vertices";
inline constexpr char no_more_holes[] = "the polygon has more than 1000 holes";
inline constexpr char no_vertices_of_hole[] = "the hole has no vertices";
inline constexpr char no_more_cargo[] = "there are more than 1000 items of cargo";
static_assert(max_vertices == 1048576 && max_holes == 1000 && max_cargo == 1000,
              "the messages name the numbers");

// Whether the word is WKT's name for a geometry other than POLYGON, in upper or lower case. O(1).
bool names_other_geometry(std::string_view word);

// Reads the parentheses and rings of a WKT polygon: the outline and at most `most_holes` holes. A
// ring's last vertex is dropped if it equals the first. Positions with coordinates beyond x and y
// are counted in `beyond`, or refused if `beyond` is null. O(bytes).
std::optional<InputError> take_wkt_polygon(TextCursor& cursor, Document& document,
                                           std::size_t most_holes, std::size_t* beyond);

// Whether the word is Z, M or ZM, which announce further coordinates. O(1).
bool names_wkt_dimensions(std::string_view word);

// Drops the last vertex if it equals the first. O(1).
void drop_closing_vertex(Points& ring);

}  // namespace evenlift
