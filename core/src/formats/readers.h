// The readers of WKT and GeoJSON, and what the readers of all formats share. They hand shapes and
// reasons to a sink: that of read_polygon(), or the import's, which gathers those of all formats.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "evenlift/document.h"
#include "evenlift/result.h"
#include "numbers/json_tree.h"
#include "numbers/text_cursor.h"

namespace evenlift {

// Messages that the readers share.
inline constexpr char no_more_vertices[] = "the polygon has more than 1048576 vertices";
inline constexpr char no_vertices[] = "the polygon has no vertices";
inline constexpr char no_more_holes[] = "the polygon has more than 1000 holes";
inline constexpr char no_vertices_of_hole[] = "the hole has no vertices";
inline constexpr char no_more_cargo[] = "there are more than 1000 items of cargo";
static_assert(max_vertices == 1048576 && max_holes == 1000 && max_cargo == 1000,
              "the messages name the numbers");

// O(1).
std::string_view without_byte_order_mark(std::string_view text);

// Drops the last vertex if it equals the first. O(1).
void drop_closing_vertex(Points& ring);

class ShapeSink {
 public:
  // A shape with the document's vertices and holes, whose last vertex may equal the first.
  virtual void add(Document document, std::string_view name, std::string_view kind) = 0;
  // A shape that is left out because of this error.
  virtual void add_problem(InputError error) = 0;
  // A thing that is no shape, in the singular and in the plural.
  virtual void leave_out(std::string_view one, std::string_view many) = 0;
  // Whether a limit is reached, so that a reader may stop.
  virtual bool full() const = 0;
  virtual std::size_t most_holes() const = 0;

 protected:
  ~ShapeSink() = default;
};

// What readers leave out of rings.
struct RingNotes {
  std::size_t repeated = 0;  // vertices at the place of the preceding one
  std::size_t heights = 0;   // positions with coordinates beyond x and y
  bool are_degrees = false;  // the text says that its coordinates are degrees
  // The note about degrees.
  std::string_view in_degrees =
      "the coordinates are degrees of longitude and latitude, not lengths";

  // Drops and counts vertices equal to the one before, but not a last one equal to the first. O(n).
  void drop_repeated(Points& ring);
};

// Whether the reference system with this EPSG code has coordinates in degrees. The function knows
// only WGS 84 and the other such systems that are most common in files. O(1).
bool is_in_degrees(double code);

// --- WKT: polygons, multipolygons and collections, perhaps with further coordinates and after
// `SRID=...;`. Other geometries are left out.

// Whether the cursor is at a geometry's name or at "SRID", with a valid continuation such as a
// parenthesis. The name alone is not enough, since a table's heading may also begin with it. O(1).
bool begins_wkt(TextCursor cursor);

class WktReader {
 public:
  WktReader(ShapeSink& sink, RingNotes& notes) : sink_(sink), notes_(notes) {}

  // Reads a geometry, perhaps after a reference system, and adds its polygons. The cursor must read
  // `text`. Returns an error if the text breaks off, is not WKT or nests collections too deeply.
  std::optional<InputError> take(std::string_view text, TextCursor& cursor, std::string_view name);
  // Reads geometries, each perhaps followed by ';', to the end of the text.
  std::optional<InputError> take_all(std::string_view text);

  const std::string& system() const { return system_; }  // the first reference system, or empty

 private:
  std::optional<InputError> take_reference_system(TextCursor& cursor);
  std::optional<InputError> take_geometry(TextCursor& cursor, std::string_view name, int depth);
  std::optional<InputError> take_polygon(TextCursor& cursor, std::string_view name);
  std::optional<InputError> skip_parentheses(TextCursor& cursor) const;

  std::string_view text_;  // the text of the geometry being read
  ShapeSink& sink_;
  RingNotes& notes_;
  std::string system_;
};

// --- GeoJSON of any kind (RFC 7946): the polygons of geometries, features and collections. A feature
// may have a property `centre_of_mass: [x, y]`.

class GeojsonReader {
 public:
  using Index = JsonTree::Index;

  // Text and tree must outlive the reader.
  GeojsonReader(std::string_view text, const JsonTree& tree, ShapeSink& sink, RingNotes& notes)
      : text_(text), tree_(tree), sink_(sink), notes_(notes) {}

  // Reads a whole text, which also says whether its coordinates are degrees.
  void take_all();
  // Reads an object that may be within other JSON.
  void take(Index object, std::string_view name);

  Result<Points> ring(Index array);
  Result<Vec2> position(Index array);
  // What the feature is called by its table of properties, or empty.
  std::string name_of(Index feature, std::string_view table) const;

 private:
  InputError error(Index at, ErrorCode code, std::string message) const;
  bool is(std::optional<Index> at, JsonTree::Kind kind) const {
    return at && tree_.kind(*at) == kind;
  }
  void object(Index object, std::string_view name, const Document& of);
  void feature(Index object);
  void geometry(Index object, std::string_view name, const Document& of);
  void polygon(Index rings, std::string_view name, const Document& of);
  std::optional<InputError> take_hole(Index ring, Document& document);
  std::optional<std::string> name_in(Index object, std::string_view member) const;
  bool is_in_degrees() const;

  std::string_view text_;
  const JsonTree& tree_;
  ShapeSink& sink_;
  RingNotes& notes_;
  bool of_evenlift_ = false;  // a feature has "centre_of_mass", which only evenlift writes
};

}  // namespace evenlift
