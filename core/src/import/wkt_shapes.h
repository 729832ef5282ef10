// Reads well-known text, alone or in a column of a table. It leaves out the same kinds of
// geometries as the reader of GeoJSON.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "import/gathering.h"
#include "import/ring_notes.h"
#include "numbers/text_cursor.h"

namespace evenlift {

// Whether the text begins with the name of a geometry and a valid continuation, such as a
// parenthesis: a table's heading may also begin with such a name. O(1).
bool begins_wkt(TextCursor cursor);

// A cell's place in its line, without quotation marks: bytes `from` .. `to` - 1.
struct GeometryCell {
  std::size_t from = 0, to = 0;
};

// The first cell of WKT in the line, up to its closing parenthesis or the end of the line; nullopt
// if the line has no such cell. O(line).
std::optional<GeometryCell> find_geometry(std::string_view line);

class WktReader {
 public:
  explicit WktReader(Gathering& gathering) : gathering_(gathering) {}

  // Reads a geometry, perhaps after a reference system, and adds its polygons. The cursor reads
  // `text`. Returns an error if the text breaks off or is not WKT.
  std::optional<InputError> take(std::string_view text, TextCursor& cursor, std::string_view name);
  // Adds the notes; called after the last geometry.
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

// Reads one geometry after another.
Result<Import> read_wkt_shapes(std::string_view text, const ImportOptions& options);

// Reads a table in which each line has a geometry, named by a column of names or numbers.
Result<Import> read_wkt_table(std::string_view text, const ImportOptions& options);

// Whether one of the first lines has WKT. Points do not count beside columns of their x and y.
// O(first lines).
bool has_wkt_cells(std::string_view text);

}  // namespace evenlift
