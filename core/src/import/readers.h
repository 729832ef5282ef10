// The readers from which read_shapes() chooses. Each reads a whole text, which must contain neither
// a byte-order mark nor bytes of value 0.
#pragma once

#include <string_view>

#include "document/document_json.h"
#include "evenlift/document.h"
#include "evenlift/import.h"

namespace evenlift {

Result<Import> read_svg(std::string_view text, const ImportOptions& options);
Result<Import> read_dxf(std::string_view text, const ImportOptions& options);
Result<Import> read_columns(std::string_view text, const ImportOptions& options);
// Reads GeoJSON, arrays of points, and evenlift's results.
Result<Import> read_json_shapes(std::string_view text, const ImportOptions& options);

// The document that evenlift wrote, as a result or by itself: its defaults count as unset.
Result<Document> read_written(DocumentReader& reader, JsonTree::Index object);

// Whether the text begins, after any comments, with a DXF section, that is, with the code 0 on one
// line and the value SECTION on the next. O(bytes up to there).
bool looks_like_dxf(std::string_view text);

// A part of the message about a text in no known format.
inline constexpr char known_formats[] =
    "evenlift reads lines \"x, y\", columns of a table (CSV), SVG, DXF, WKT and GeoJSON";

// The message about a file of robots' poses that evenlift saved.
inline constexpr char robots_are_no_polygon[] =
    "these are the robots of a result, not a polygon: open the JSON saved with them, which contains the "
    "polygon and all settings";

// --- Full names of length units.

// The unit's full name, such as "millimetres"; empty for LengthUnit::none.
inline const char* in_full(LengthUnit unit) {
  switch (unit) {
    case LengthUnit::m:
      return "metres";
    case LengthUnit::cm:
      return "centimetres";
    case LengthUnit::mm:
      return "millimetres";
    case LengthUnit::in:
      return "inches";
    case LengthUnit::none:
      break;
  }
  return "";
}

}  // namespace evenlift
