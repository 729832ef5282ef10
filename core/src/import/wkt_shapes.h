// Polygons in well-known text, alone or in a column of a table. What they leave out is as in GeoJSON.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "import/gathering.h"
#include "import/ring_notes.h"
#include "numbers/text_cursor.h"

namespace evenlift {

// Whether the text at the cursor begins with the name of a geometry and a parenthesis, or another
// valid continuation. The heading of a table may also begin with such a name. O(1).
bool begins_wkt(TextCursor cursor);

// A geometry in a line of a table, with its quotation marks.
struct GeometryCell {
  std::size_t from = 0, to = 0;
};

// Where the first cell of WKT is in the line, if any: up to the parenthesis that closes it, or the
// end of the line. O(line).
std::optional<GeometryCell> find_geometry(std::string_view line);

class WktReader {
 public:
  explicit WktReader(Gathering& gathering) : gathering_(gathering) {}

  // Reads a geometry, perhaps with a reference system before it, and adds its polygons under the
  // name. The cursor reads the text. Returns an error if the geometry breaks off or is no WKT.
  std::optional<InputError> take(std::string_view text, TextCursor& cursor, std::string_view name);
  // Adds the notes, after the last geometry.
  void finish();

 private:
  std::optional<InputError> take_reference_system(TextCursor& cursor);
  std::optional<InputError> take_geometry(TextCursor& cursor, std::string_view name, int depth);
  std::optional<InputError> take_polygon(TextCursor& cursor, std::string_view name);
  std::optional<InputError> skip_parentheses(TextCursor& cursor) const;

  std::string_view text_;  // of the geometry being read
  Gathering& gathering_;
  RingNotes notes_;
  std::string system_;  // the first reference system
};

// Reads a text of geometries of WKT, one after the other.
Result<Import> read_wkt_shapes(std::string_view text, const ImportOptions& options);

// Reads a table with a column of WKT: each line is a geometry, named by a column of names or
// numbers.
Result<Import> read_wkt_table(std::string_view text, const ImportOptions& options);

// Whether one of the first lines of a table has a cell of WKT, other than points beside columns of
// their x and y. O(first lines).
bool has_wkt_cells(std::string_view text);

}  // namespace evenlift
