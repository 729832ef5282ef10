// Well-known text: `POLYGON ((x y, ...), ...)`, the outline and then the holes, with two
// coordinates; or a MULTIPOLYGON of one.
#include <algorithm>
#include <iterator>

#include "formats/readers.h"
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

}  // namespace evenlift
