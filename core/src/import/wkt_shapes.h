// Well-known text, alone or in a column of a table. It leaves out what GeoJSON leaves out.
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

// Quotation marks included.
struct GeometryCell {
  std::size_t from = 0, to = 0;
};

// The first cell of WKT in the line: up to its closing parenthesis, or the end of the line.
// O(line).
std::optional<GeometryCell> find_geometry(std::string_view line);

class WktReader {
 public:
  explicit WktReader(Gathering& gathering) : gathering_(gathering) {}

  // Reads a geometry, perhaps after a reference system, and adds its polygons. The cursor reads the
  // text. An error if it breaks off or is no WKT.
  std::optional<InputError> take(std::string_view text, TextCursor& cursor, std::string_view name);
  // After the last geometry, adds the notes.
  void finish();

 private:
  std::optional<InputError> take_reference_system(TextCursor& cursor);
  std::optional<InputError> take_geometry(TextCursor& cursor, std::string_view name, int depth);
  std::optional<InputError> take_polygon(TextCursor& cursor, std::string_view name);
  std::optional<InputError> skip_parentheses(TextCursor& cursor) const;

  std::string_view text_;  // of the geometry being read
  Gathering& gathering_;
  RingNotes notes_;
  std::string system_;  // the first one
};

// Reads one geometry after another.
Result<Import> read_wkt_shapes(std::string_view text, const ImportOptions& options);

// Each line is a geometry, named by a column of names or numbers.
Result<Import> read_wkt_table(std::string_view text, const ImportOptions& options);

// Whether a first line has WKT, other than points beside columns of their x and y. O(first lines).
bool has_wkt_cells(std::string_view text);

}  // namespace evenlift
