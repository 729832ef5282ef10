// The readers of this room. Each reads a whole text without a byte-order mark and without bytes 0.
// read_shapes() in import.cpp tells which one to use.
#pragma once

#include <string_view>

#include "evenlift/import.h"

namespace evenlift {

Result<Import> read_svg(std::string_view text, const ImportOptions& options);
Result<Import> read_dxf(std::string_view text, const ImportOptions& options);
Result<Import> read_columns(std::string_view text, const ImportOptions& options);
// GeoJSON, arrays of points, and results.
Result<Import> read_json_shapes(std::string_view text, const ImportOptions& options);

// Whether the text begins as DXF does: pairs of lines, a code and a value, the first 0 and SECTION
// after any comments. O(bytes until then).
bool looks_like_dxf(std::string_view text);

// What there is for people whose text is none of the formats.
inline constexpr char known_formats[] =
    "evenlift reads lines \"x, y\", columns of a table (CSV), SVG, DXF, WKT and GeoJSON";

// Where somebody opens the robots' poses that evenlift saved, whatever their format.
inline constexpr char robots_are_no_polygon[] =
    "these are the robots of a result and no polygon: open the JSON that was saved with them, which holds the "
    "polygon and all settings";

}  // namespace evenlift
