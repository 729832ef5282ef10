// Reads polygons, multipolygons and collections in well-known text, alone or in a column of a
// table. Other geometries, such as points, are left out.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "evenlift/import.h"
#include "import/gathering.h"
#include "numbers/text_cursor.h"

namespace evenlift {

// Whether the cursor is at a geometry's name or at "SRID", with a valid continuation such as a
// parenthesis. The name alone is not enough, since a table's heading may also begin with it. O(1).
bool begins_wkt(TextCursor cursor);

// A cell's place in its line, without quotation marks: bytes `from` .. `to` - 1.
struct GeometryCell {
  std::size_t from = 0, to = 0;
};

// The first cell of WKT in the line; nullopt if there is no such cell. It ends at its closing
// parenthesis, or at a quotation mark before any parenthesis, or at the end of the line. O(line).
std::optional<GeometryCell> find_geometry(std::string_view line);

class WktReader {
 public:
  explicit WktReader(Gathering& gathering) : gathering_(gathering) {}

  // Reads a geometry, perhaps after a reference system, and adds its polygons. The cursor must read
  // `text`. Returns an error if the text breaks off, is not WKT or nests collections too deeply.
  std::optional<InputError> take(std::string_view text, TextCursor& cursor, std::string_view name);
  // Adds the notes on what was left out. Call it after the last geometry.
  void finish();

 private:
  std::optional<InputError> take_reference_system(TextCursor& cursor);
  std::optional<InputError> take_geometry(TextCursor& cursor, std::string_view name, int depth);
  std::optional<InputError> take_polygon(TextCursor& cursor, std::string_view name);
  std::optional<InputError> skip_parentheses(TextCursor& cursor) const;

  std::string_view text_;  // the text of the geometry being read
  Gathering& gathering_;
  RingNotes notes_;
  std::string system_;  // the first reference system
};

// Reads a text of one or more geometries, each perhaps followed by ';'.
Result<Import> read_wkt_shapes(std::string_view text, const ImportOptions& options);

// Reads a table of geometries, one per line. A column of names or numbers, if any, names them.
Result<Import> read_wkt_table(std::string_view text, const ImportOptions& options);

// Whether one of the first 100 lines of a table has WKT. But returns false if an earlier line
// names columns of coordinates and the first WKT is a point, which repeats them. O(100 lines).
bool has_wkt_cells(std::string_view text);

// --- Reads points as Python writes them: lists and tuples, such as "[(0, 0), (1, 0)]", and numpy's
// arrays.

// Whether the text has only numbers, commas, brackets and parentheses, and either begins with two
// brackets or parentheses, such as "[(", or has a comma after its first "(x, y)". The thesis's
// format has no such comma. O(bytes).
bool looks_like_python(std::string_view text);

// Reads each list of points as a shape. O(bytes).
Result<Import> read_python_points(std::string_view text, const ImportOptions& options);

}  // namespace evenlift
