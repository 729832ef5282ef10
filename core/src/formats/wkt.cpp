// Well-known text.
#include <algorithm>
#include <iterator>

#include "evenlift/numbers.h"
#include "formats/readers.h"

namespace evenlift {
namespace {

constexpr int deepest_collection = 32;
constexpr std::string_view read_names[] = {"polygon", "multipolygon", "geometrycollection"};

bool names_wkt_dimensions(std::string_view word) {
  return same_word(word, "z") || same_word(word, "m") || same_word(word, "zm");
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

// Reads a position. If it has further coordinates, adds 1 to `beyond`. The caller checks the rest.
std::optional<InputError> take_position(TextCursor& cursor, Vec2& point, std::size_t& beyond) {
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
    const bool unknown = same_word(cursor.word(), "nan");
    if (cursor.offset() == end_of_last || (!unknown && !cursor.sees_number())) return std::nullopt;
    if (count == most_coordinates)
      return cursor.error(ErrorCode::unsupported, "a position has more than four coordinates");
    if (count == 2) ++beyond;
    double ignored = 0;
    if (unknown)
      cursor.take_word();
    else if (auto error = cursor.take_number(ignored, "a number"))
      return error;
  }
}

// Reads the positions of a ring, as many as there is room for, and the parenthesis after them.
std::optional<InputError> take_ring(TextCursor& cursor, Points& ring, std::size_t& room,
                                    std::size_t& beyond) {
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

// Reads the parentheses and rings of a polygon: the outline and at most `most_holes` holes. A ring's
// last vertex is dropped if it equals the first. O(bytes).
std::optional<InputError> take_wkt_polygon(TextCursor& cursor, Document& document,
                                           std::size_t most_holes, std::size_t& beyond) {
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

// Without Z, M or ZM at the end.
std::string_view without_dimensions(std::string_view word) {
  for (const std::string_view name : read_names)
    if (same_word(word.substr(0, name.size()), name) &&
        (word.size() == name.size() || names_wkt_dimensions(word.substr(name.size()))))
      return word.substr(0, name.size());
  for (const std::size_t end : {std::size_t{2}, std::size_t{1}})
    if (word.size() > end && names_wkt_dimensions(word.substr(word.size() - end)) &&
        names_other_geometry(word.substr(0, word.size() - end)))
      return word.substr(0, word.size() - end);
  return word;
}

bool names_geometry(std::string_view name) {
  return names_other_geometry(name) || same_word(name, read_names[0]);
}

// "Point", as in GeoJSON.
std::string title_of(std::string_view word) {
  std::string title;
  for (const char c : word) title += lower_case(c);
  if (!title.empty() && title[0] >= 'a') title[0] = static_cast<char>(title[0] - 'a' + 'A');
  return title;
}

}  // namespace

bool begins_wkt(TextCursor cursor) {
  const std::string_view name = cursor.take_word();
  cursor.skip_white_space();
  if (same_word(name, "srid")) return cursor.sees('=');
  if (!same_word(name.substr(0, 7), "polygon") && !names_geometry(without_dimensions(name)))
    return false;
  const std::string_view second = cursor.take_word();
  cursor.skip_white_space();
  return cursor.sees('(') || same_word(second, "empty") || same_word(cursor.word(), "empty");
}

std::optional<InputError> WktReader::take_reference_system(TextCursor& cursor) {
  if (!same_word(cursor.word(), "srid")) return std::nullopt;
  cursor.take_word();
  cursor.skip_white_space();
  if (!cursor.take('=')) return cursor.expected("'=' after 'SRID'");
  cursor.skip_white_space();
  double code = 0;
  if (auto error = cursor.take_number(code, "the number of a reference system")) return error;
  cursor.skip_white_space();
  if (!cursor.take(';')) return cursor.expected("';' after the reference system");
  cursor.skip_white_space();
  if (system_.empty()) system_ = shortest(code);
  if (is_in_degrees(code)) notes_.are_degrees = true;
  return std::nullopt;
}

std::optional<InputError> WktReader::skip_parentheses(TextCursor& cursor) const {
  if (!cursor.sees('(')) return cursor.expected("'(' after the name of the geometry");
  std::size_t depth = 0;
  do {
    if (cursor.at_end()) return cursor.expected("')' after the coordinates");
    const char c = text_[cursor.offset()];
    if (c == '(') ++depth;
    if (c == ')') --depth;
    cursor.take(c);
  } while (depth > 0);
  return std::nullopt;
}

std::optional<InputError> WktReader::take_polygon(TextCursor& cursor, std::string_view name) {
  Document document;
  if (auto error = take_wkt_polygon(cursor, document, sink_.most_holes(), notes_.heights))
    return error;
  notes_.drop_repeated(document.vertices);
  for (Points& hole : document.holes) notes_.drop_repeated(hole);
  sink_.add(std::move(document), name, "polygon");
  return std::nullopt;
}

std::optional<InputError> WktReader::take_geometry(TextCursor& cursor, std::string_view name,
                                                   int depth) {
  if (depth > deepest_collection)
    return cursor.error(ErrorCode::unsupported, "the collections are nested too deep");
  const std::size_t start = cursor.offset();
  const std::string_view kind = without_dimensions(cursor.take_word());
  if (!names_geometry(kind))
    return cursor.error_at(start, ErrorCode::bad_syntax,
                           "expected 'POLYGON' or another geometry of WKT here");
  cursor.skip_white_space();
  if (names_wkt_dimensions(cursor.word())) cursor.take_word();
  cursor.skip_white_space();
  const std::size_t second = cursor.offset();
  const bool single = same_word(kind, "polygon");
  if (same_word(cursor.word(), "empty")) {
    cursor.take_word();
    if (single)
      sink_.add_problem(cursor.error_at(second, ErrorCode::too_few_vertices, no_vertices));
    return std::nullopt;
  }
  if (cursor.sees_letter())
    return cursor.error_at(second, ErrorCode::bad_syntax,
                           "expected '(' after the name of the geometry but found a word");
  if (single) return take_polygon(cursor, name);
  const bool collection = same_word(kind, "geometrycollection");
  if (!collection && !same_word(kind, "multipolygon")) {
    const std::string title = title_of(kind);
    sink_.leave_out(title, title + "s");
    return skip_parentheses(cursor);
  }
  if (!cursor.take('(')) return cursor.expected("'(' after the name of the geometry");
  do {
    cursor.skip_white_space();
    auto error = collection ? take_geometry(cursor, name, depth + 1) : take_polygon(cursor, name);
    if (error) return error;
    cursor.skip_white_space();
  } while (cursor.take(','));
  if (!cursor.take(')')) return cursor.expected("',' or ')' after the polygon");
  return std::nullopt;
}

std::optional<InputError> WktReader::take(std::string_view text, TextCursor& cursor,
                                          std::string_view name) {
  text_ = text;
  cursor.skip_white_space();
  if (auto error = take_reference_system(cursor)) return error;
  return take_geometry(cursor, name, 0);
}

std::optional<InputError> WktReader::take_all(std::string_view text) {
  TextCursor cursor(text);
  do {
    if (auto error = take(text, cursor, "")) return error;
    cursor.skip_white_space();
    if (cursor.take(';')) cursor.skip_white_space();
    if (!cursor.at_end() && !cursor.sees_letter())
      return cursor.expected("the end of the text after the polygon");
  } while (!cursor.at_end() && !sink_.full());
  return std::nullopt;
}

}  // namespace evenlift
