// read_shapes() chooses one of the readers. Each reads a whole text without a byte-order mark and
// without bytes 0.
#pragma once

#include <string_view>

#include "evenlift/import.h"

namespace evenlift {

Result<Import> read_svg(std::string_view text, const ImportOptions& options);
Result<Import> read_dxf(std::string_view text, const ImportOptions& options);
Result<Import> read_columns(std::string_view text, const ImportOptions& options);
// GeoJSON, arrays of points, and results.
Result<Import> read_json_shapes(std::string_view text, const ImportOptions& options);

// Whether the text begins, after any comments, with pairs of lines, a code and a value, first 0 and
// SECTION. O(bytes until then).
bool looks_like_dxf(std::string_view text);

// For the message about a text in no known format.
inline constexpr char known_formats[] =
    "evenlift reads lines \"x, y\", columns of a table (CSV), SVG, DXF, WKT and GeoJSON";

// For files of robots' poses that evenlift saved.
inline constexpr char robots_are_no_polygon[] =
    "these are the robots of a result, not a polygon: open the JSON saved with them, which contains the "
    "polygon and all settings";

}  // namespace evenlift
