// Well-known text: `POLYGON ((x y, ...), ...)`, the outline and then the holes, with two
// coordinates; or a MULTIPOLYGON of one.
#include <algorithm>
#include <iterator>
#include <vector>

#include "formats/readers.h"
#include "numbers/json_tree.h"
#include "numbers/text_cursor.h"

namespace evenlift {
namespace {

constexpr std::string_view multipolygon = "multipolygon";

// Reads everything before the first parenthesis, and whether it names a MULTIPOLYGON.
std::optional<InputError> take_keywords(TextCursor& cursor, bool& of_several) {
  const std::size_t start = cursor.offset();
  const std::string_view word = cursor.take_word();
  if (same_word(word, "srid")) {
    return cursor.error_at(start, ErrorCode::unsupported,
                           "a prefix 'SRID=...;' is not supported: leave it out");
  }
  of_several = same_word(word.substr(0, multipolygon.size()), multipolygon);
  if (!of_several && names_other_geometry(word)) {
    return cursor.error_at(start, ErrorCode::unsupported,
                           "only a POLYGON is supported, no other geometry");
  }
  const std::size_t length = of_several ? multipolygon.size() : 7;
  const bool known = of_several || same_word(word.substr(0, 7), "polygon");
  if (!known || (word.size() > length && !names_wkt_dimensions(word.substr(length)))) {
    return cursor.error_at(start, ErrorCode::bad_syntax,
                           "expected '(', 'CoM:', 'POLYGON' or '{' but found a word");
  }
  if (word.size() > length)
    return cursor.error_at(start, ErrorCode::unsupported, no_third_coordinate);

  cursor.skip_white_space();
  const std::size_t second = cursor.offset();
  const std::string_view what = cursor.take_word();
  if (names_wkt_dimensions(what)) {
    return cursor.error_at(second, ErrorCode::unsupported, no_third_coordinate);
  }
  if (same_word(what, "empty")) {
    return cursor.error_at(second, ErrorCode::too_few_vertices, no_vertices);
  }
  if (!what.empty()) {
    return cursor.error_at(second, ErrorCode::bad_syntax,
                           of_several ? "expected '(((' after 'MULTIPOLYGON' but found a word"
                                      : "expected '((' after 'POLYGON' but found a word");
  }
  return std::nullopt;
}

// Reads a position. If it has further coordinates, adds 1 to `beyond`, or refuses them if that is
// null. The caller checks the rest.
std::optional<InputError> take_position(TextCursor& cursor, Vec2& point, std::size_t* beyond) {
  constexpr std::size_t most_coordinates = 4;
  cursor.skip_white_space();
  if (auto error = cursor.take_number(point.x, "a number")) return error;
  const std::size_t end_of_first = cursor.offset();
  cursor.skip_white_space();
  if (cursor.offset() == end_of_first) return cursor.expected("a space between the coordinates");
  if (auto error = cursor.take_number(point.y, "a number")) return error;
  for (std::size_t count = 2;; ++count) {
    const std::size_t end_of_last = cursor.offset();
    cursor.skip_white_space();
    // Programs write an unknown height as NaN.
    const bool unknown = beyond && same_word(cursor.word(), "nan");
    if (cursor.offset() == end_of_last || (!unknown && !cursor.sees_number())) return std::nullopt;
    if (!beyond || count == most_coordinates)
      return cursor.error(ErrorCode::unsupported, no_third_coordinate);
    if (count == 2) ++*beyond;
    double ignored = 0;
    if (unknown)
      cursor.take_word();
    else if (auto error = cursor.take_number(ignored, "a number"))
      return error;
  }
}

// Reads the positions of a ring, as many as there is room for, and the parenthesis after them.
std::optional<InputError> take_ring(TextCursor& cursor, Points& ring, std::size_t& room,
                                    std::size_t* beyond) {
  do {
    if (ring.size() > room) {  // one more vertex may close the ring
      return cursor.error(ErrorCode::too_many_vertices, no_more_vertices);
    }
    Vec2 point;
    if (auto error = take_position(cursor, point, beyond)) return error;
    ring.push_back(point);
  } while (cursor.take(','));
  if (!cursor.take(')')) return cursor.expected("',' or ')' after the coordinates");
  drop_closing_vertex(ring);
  if (ring.size() > room) return cursor.error(ErrorCode::too_many_vertices, no_more_vertices);
  room -= ring.size();
  return std::nullopt;
}

}  // namespace

bool names_wkt_dimensions(std::string_view word) {
  return same_word(word, "z") || same_word(word, "m") || same_word(word, "zm");
}

std::optional<InputError> take_wkt_polygon(TextCursor& cursor, Document& document,
                                           std::size_t most_holes, std::size_t* beyond) {
  constexpr char beginning[] = "'((' after 'POLYGON'";
  cursor.skip_white_space();
  if (!cursor.take('(')) return cursor.expected(beginning);
  std::size_t room = max_vertices;
  for (bool is_hole = false;; is_hole = true) {
    cursor.skip_white_space();
    if (document.holes.size() == most_holes && is_hole)
      return cursor.error(ErrorCode::too_many_vertices, no_more_holes);
    if (!cursor.take('(')) return cursor.expected(is_hole ? "'(' before the hole" : beginning);
    Points& ring = is_hole ? document.holes.emplace_back() : document.vertices;
    if (auto error = take_ring(cursor, ring, room, beyond)) return error;
    cursor.skip_white_space();
    if (!cursor.take(',')) break;
  }
  if (!cursor.take(')')) return cursor.expected("')' after the ring");
  return std::nullopt;
}

bool names_other_geometry(std::string_view word) {
  static constexpr std::string_view names[] = {
      "point",          "linestring",        "multipoint",   "multilinestring",
      "multipolygon",   "multicurve",        "multisurface", "geometrycollection",
      "circularstring", "compoundcurve",     "curvepolygon", "curve",
      "surface",        "polyhedralsurface", "tin",          "triangle"};
  return std::any_of(std::begin(names), std::end(names),
                     [&](std::string_view name) { return same_word(word, name); });
}

Result<Document> read_wkt(std::string_view text) {
  Document document;
  TextCursor cursor(text);
  cursor.skip_white_space();
  bool of_several = false;
  if (auto error = take_keywords(cursor, of_several)) return *std::move(error);
  if (of_several && !cursor.take('(')) return cursor.expected("'(((' after 'MULTIPOLYGON'");
  if (auto error = take_wkt_polygon(cursor, document, max_holes, nullptr)) return *std::move(error);

  cursor.skip_white_space();
  if (of_several) {
    if (cursor.sees(','))
      return cursor.error(ErrorCode::unsupported,
                          "only a MULTIPOLYGON of one polygon is supported");
    if (!cursor.take(')')) return cursor.expected("')' after the polygon");
    cursor.skip_white_space();
  }
  if (!cursor.at_end()) return cursor.expected("the end of the text after the polygon");
  return document;
}

// --- GeoJSON (RFC 7946): a Polygon, or a Feature with a Polygon, optionally with a property
// `centre_of_mass: [x, y]`. Members may appear in any order, so a fault in the coordinates is kept
// until the type is known: they may belong to another kind of geometry.

namespace {

// The role of a JSON value in GeoJSON.
enum class Role : std::uint8_t {
  ignored,
  whole,          // the outermost object
  type,           // "type" of the whole or of the geometry
  geometry,       // "geometry" of the whole
  properties,     // "properties" of the whole
  centre,         // "centre_of_mass" of the properties
  centre_number,  // an element of the centre
  rings,          // "coordinates" of the whole or of the geometry
  ring,           // an element of the rings
  position,       // an element of a ring
  number          // an element of a position
};

Role role_of_member(Role object, std::string_view name) {
  if (object == Role::whole || object == Role::geometry) {
    if (name == "type") return Role::type;
    if (name == "coordinates") return Role::rings;
  }
  if (object == Role::whole && name == "geometry") return Role::geometry;
  if (object == Role::whole && name == "properties") return Role::properties;
  if (object == Role::properties && name == "centre_of_mass") return Role::centre;
  return Role::ignored;
}

Role role_of_element(Role array) {
  switch (array) {
    case Role::centre:
      return Role::centre_number;
    case Role::rings:
      return Role::ring;
    case Role::ring:
      return Role::position;
    case Role::position:
      return Role::number;
    default:
      return Role::ignored;
  }
}

// A geometry object so far: the whole or its geometry.
struct GeometryObject {
  std::optional<std::string> type;
  std::size_t type_offset = 0;
  bool has_coordinates = false;
  std::vector<Points> rings;        // the outline, then the holes
  std::size_t vertices = 0;         // of the rings that are complete
  std::optional<InputError> fault;  // the first in the coordinates, if they are a polygon's
};

class GeojsonReader final : public JsonSink {
 public:
  explicit GeojsonReader(std::string_view text) : text_(text) {}
  Result<Document> read();

  bool value(const JsonValue& value) override;
  bool key(std::string_view name, std::size_t offset) override;
  bool end() override;

 private:
  // An object or array being read.
  struct Level {
    Role role;
    Role next = Role::ignored;  // of the next value
    std::size_t elements = 0;   // of an array, so far
    unsigned members = 0;       // of an object, so far: a bit for each role
  };
  using Kind = JsonValue::Kind;

  InputError error_at(std::size_t offset, ErrorCode code, const char* message) const {
    return text_error(code, message, text_, offset);
  }
  bool fail(ErrorCode code, const char* message, std::size_t offset) {
    error_ = error_at(offset, code, message);
    return false;
  }
  // Records the first fault and continues: the geometry may be ignored.
  bool note_fault(ErrorCode code, const char* message, std::size_t offset) {
    if (!object().fault) object().fault = error_at(offset, code, message);
    return true;
  }
  GeometryObject& object() { return in_geometry_ ? geometry_ : whole_; }

  bool take(Role role, const JsonValue& value, std::size_t index);
  bool take_centre(Role role, const JsonValue& value, std::size_t index);
  bool take_coordinates(Role role, const JsonValue& value, std::size_t index);
  bool end_of(const Level& level);
  bool end_of_ring();
  Result<Document> document_of(GeometryObject& object);
  Result<Document> finish();

  std::string_view text_;
  std::vector<Level> levels_;
  std::size_t offset_ = 0;  // of the last value
  bool in_geometry_ = false;
  bool has_geometry_ = false;
  GeometryObject whole_;
  GeometryObject geometry_;
  Vec2 centre_;
  bool has_centre_ = false;
  Vec2 position_;
  std::optional<InputError> error_;
};

bool GeojsonReader::value(const JsonValue& value) {
  offset_ = value.offset;
  Role role = Role::whole;
  std::size_t index = 0;
  if (!levels_.empty()) {
    role = levels_.back().next;
    index = levels_.back().elements++;
  }
  if (!take(role, value, index)) return false;
  if (value.kind == Kind::object || value.kind == Kind::array) {
    Level level{role};
    if (value.kind == Kind::array) level.next = role_of_element(role);
    levels_.push_back(level);
    if (role == Role::geometry) in_geometry_ = true;
  }
  return true;
}

bool GeojsonReader::key(std::string_view name, std::size_t offset) {
  Level& object = levels_.back();
  object.next = role_of_member(object.role, name);
  if (object.next == Role::ignored) return true;
  const unsigned bit = 1u << static_cast<unsigned>(object.next);
  if ((object.members & bit) != 0) {
    return fail(ErrorCode::bad_syntax, "the object has this member twice", offset);
  }
  object.members |= bit;
  return true;
}

bool GeojsonReader::end() {
  const Level level = levels_.back();
  levels_.pop_back();
  if (!end_of(level)) return false;
  if (level.role == Role::geometry) in_geometry_ = false;
  return true;
}

bool GeojsonReader::take(Role role, const JsonValue& value, std::size_t index) {
  switch (role) {
    case Role::whole:
      if (value.kind == Kind::object) return true;
      return fail(ErrorCode::bad_syntax, "expected a GeoJSON object", value.offset);
    case Role::type:
      if (value.kind != Kind::string) {
        return fail(ErrorCode::bad_syntax, "the \"type\" is not a string", value.offset);
      }
      object().type = std::string(value.text);
      object().type_offset = value.offset;
      return true;
    case Role::geometry:
      has_geometry_ = value.kind == Kind::object;
      return true;
    case Role::centre:
    case Role::centre_number:
      return take_centre(role, value, index);
    case Role::rings:
    case Role::ring:
    case Role::position:
    case Role::number:
      return take_coordinates(role, value, index);
    case Role::properties:
    case Role::ignored:
      break;
  }
  return true;
}

bool GeojsonReader::take_centre(Role role, const JsonValue& value, std::size_t index) {
  if (role == Role::centre) {
    if (value.kind == Kind::null) return true;
    has_centre_ = value.kind == Kind::array;
    if (has_centre_) return true;
  } else if (value.kind == Kind::number) {
    if (index > 1) return fail(ErrorCode::unsupported, no_third_coordinate, value.offset);
    centre_[index] = value.number;
    return true;
  }
  return fail(ErrorCode::bad_syntax, "\"centre_of_mass\" is not [x, y]", value.offset);
}

bool GeojsonReader::take_coordinates(Role role, const JsonValue& value, std::size_t index) {
  if (role == Role::rings) object().has_coordinates = true;
  if (role == Role::ring && index > max_holes) {
    return note_fault(ErrorCode::too_many_vertices, no_more_holes, value.offset);
  }
  if (role != Role::number) {
    if (value.kind == Kind::array) {
      if (role == Role::ring && !object().fault) object().rings.emplace_back();
      return true;
    }
    return note_fault(ErrorCode::bad_syntax,
                      role == Role::position ? "expected a position [x, y] in the ring"
                                             : "expected an array of rings of positions [x, y]",
                      value.offset);
  }
  if (value.kind != Kind::number) {
    return note_fault(ErrorCode::bad_syntax, "expected a number as a coordinate", value.offset);
  }
  if (index > 1) return note_fault(ErrorCode::unsupported, no_third_coordinate, value.offset);
  position_[index] = value.number;
  return true;
}

bool GeojsonReader::end_of(const Level& level) {
  if (level.role == Role::centre && level.elements < 2) {
    return fail(ErrorCode::bad_syntax, "\"centre_of_mass\" is not [x, y]", offset_);
  }
  if (object().fault) return true;
  if (level.role == Role::ring) return end_of_ring();
  if (level.role != Role::position) return true;
  if (level.elements < 2) {
    return note_fault(ErrorCode::bad_syntax, "a position has fewer than two coordinates", offset_);
  }
  Points& ring = object().rings.back();
  if (ring.size() > max_vertices - object().vertices) {  // one more vertex may close the ring
    return note_fault(ErrorCode::too_many_vertices, no_more_vertices, offset_);
  }
  ring.push_back(position_);
  return true;
}

bool GeojsonReader::end_of_ring() {
  Points& ring = object().rings.back();
  drop_closing_vertex(ring);
  if (ring.size() > max_vertices - object().vertices) {
    return note_fault(ErrorCode::too_many_vertices, no_more_vertices, offset_);
  }
  object().vertices += ring.size();
  if (ring.empty() && object().rings.size() > 1) {
    return note_fault(ErrorCode::too_few_vertices, no_vertices_of_hole, offset_);
  }
  return true;
}

Result<Document> GeojsonReader::document_of(GeometryObject& object) {
  if (!object.has_coordinates) {
    return error_at(object.type_offset, ErrorCode::bad_syntax,
                    "the Polygon has no \"coordinates\"");
  }
  if (object.fault) return *std::move(object.fault);
  if (object.rings.empty() || object.rings.front().empty()) {
    return error_at(object.type_offset, ErrorCode::too_few_vertices, no_vertices);
  }
  Document document;
  document.vertices = std::move(object.rings.front());
  object.rings.erase(object.rings.begin());
  document.holes = std::move(object.rings);
  return document;
}

Result<Document> GeojsonReader::finish() {
  if (!whole_.type) {
    return error_at(0, ErrorCode::bad_syntax, "the object has no \"type\", so it is not GeoJSON");
  }
  if (*whole_.type == "Polygon") return document_of(whole_);
  constexpr char only[] = "only a Polygon, or a Feature of one, is supported";
  if (*whole_.type != "Feature") {
    return error_at(whole_.type_offset, ErrorCode::unsupported, only);
  }
  if (!has_geometry_) {
    return error_at(whole_.type_offset, ErrorCode::unsupported, "the Feature has no geometry");
  }
  if (!geometry_.type) {
    return error_at(whole_.type_offset, ErrorCode::bad_syntax, "the geometry has no \"type\"");
  }
  if (*geometry_.type != "Polygon") {
    return error_at(geometry_.type_offset, ErrorCode::unsupported, only);
  }
  Result<Document> document = document_of(geometry_);
  if (document && has_centre_) document->centre_of_mass = centre_;
  return document;
}

Result<Document> GeojsonReader::read() {
  if (auto invalid = read_json(text_, *this)) return *std::move(invalid);
  if (error_) return *std::move(error_);
  return finish();
}

}  // namespace

Result<Document> read_geojson(std::string_view text) { return GeojsonReader(text).read(); }

}  // namespace evenlift
