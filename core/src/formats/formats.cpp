// The thesis's format (appendix A.1): optionally `CoM:(x,y)` on the first line, then one `(x,y)` on
// each line. Lines for holes and cargo, which the thesis lacks, may follow.
#include "evenlift/formats.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <string>
#include <utility>

#include "document/setting_values.h"
#include "evenlift/wording.h"
#include "formats/readers.h"
#include "numbers/number_text.h"
#include "numbers/text_cursor.h"

namespace evenlift {
namespace {

// Reads `(x,y)`, with spaces anywhere but no line break.
std::optional<InputError> take_pair(TextCursor& cursor, const char* before, Vec2& point) {
  if (!cursor.take('(')) return cursor.expected(before);
  cursor.skip_spaces_in_line();
  if (auto error = cursor.take_number(point.x, "a number")) return error;
  cursor.skip_spaces_in_line();
  if (!cursor.take(',')) return cursor.expected("',' between the coordinates");
  cursor.skip_spaces_in_line();
  if (auto error = cursor.take_number(point.y, "a number")) return error;
  cursor.skip_spaces_in_line();
  if (cursor.sees(','))
    return cursor.error(ErrorCode::unsupported, "coordinates beyond x and y are not supported");
  if (!cursor.take(')')) return cursor.expected("')' after the coordinates");
  return std::nullopt;
}

std::optional<InputError> take_line_end(TextCursor& cursor, const char* after) {
  cursor.skip_spaces_in_line();
  if (!cursor.at_line_end())
    return cursor.expected(say("the end of the line after {text}", {after}));
  cursor.skip_white_space();
  return std::nullopt;
}

// Reads a word that is known to be there, such as CoM, and its colon.
std::optional<InputError> take_label(TextCursor& cursor, const char* expected) {
  cursor.take_word();
  cursor.skip_spaces_in_line();
  if (!cursor.take(':')) return cursor.expected(expected);
  cursor.skip_spaces_in_line();
  return std::nullopt;
}

std::optional<InputError> take_centre_of_mass(TextCursor& cursor, Document& document) {
  if (!same_word(cursor.word(), "com")) return cursor.expected("'(' or 'CoM:'");
  if (auto error = take_label(cursor, "':' after 'CoM'")) return error;
  Vec2 point;
  if (auto error = take_pair(cursor, "'(' after 'CoM:'", point)) return error;
  document.centre_of_mass = point;
  return take_line_end(cursor, "')'");
}

// Reads the lines of vertices at the cursor, at most `room`.
std::optional<InputError> take_ring(TextCursor& cursor, Points& ring, std::size_t& room) {
  for (; cursor.sees('('); --room) {
    if (room == 0) return cursor.error(ErrorCode::too_many_vertices, no_more_vertices);
    Vec2 point;
    if (auto error = take_pair(cursor, "'(' before the coordinates", point)) return error;
    ring.push_back(point);
    if (auto error = take_line_end(cursor, "')'")) return error;
  }
  return std::nullopt;
}

std::optional<InputError> take_hole(TextCursor& cursor, Document& document, std::size_t& room) {
  if (document.holes.size() == max_holes)
    return cursor.error(ErrorCode::too_many_vertices, no_more_holes);
  if (auto error = take_label(cursor, "':' after 'Hole'")) return error;
  if (auto error = take_line_end(cursor, "'Hole:'")) return error;
  Points& hole = document.holes.emplace_back();
  if (auto error = take_ring(cursor, hole, room)) return error;
  if (hole.empty()) return cursor.error(ErrorCode::too_few_vertices, no_vertices_of_hole);
  return std::nullopt;
}

// Reads `Cargo:(x,y) weight name`; the name may be missing.
std::optional<InputError> take_cargo(TextCursor& cursor, Settings& settings) {
  if (settings.cargo.size() == max_cargo)
    return cursor.error(ErrorCode::bad_setting, no_more_cargo);
  if (auto error = take_label(cursor, "':' after 'Cargo'")) return error;
  Cargo item;
  if (auto error = take_pair(cursor, "'(' after 'Cargo:'", item.at)) return error;
  cursor.skip_spaces_in_line();
  const std::size_t weight = cursor.offset();
  if (auto error = cursor.take_number(item.weight, "a weight after ')'")) return error;
  if (const char* fault = fault_of_cargo_weight(item.weight))
    return cursor.error_at(weight, ErrorCode::bad_setting, fault);
  const std::size_t end = cursor.offset();
  cursor.skip_spaces_in_line();
  if (cursor.offset() == end && !cursor.at_line_end())
    return cursor.expected("a space or the end of the line after the weight");
  const std::size_t name = cursor.offset();
  item.name = trimmed(cursor.take_rest_of_line());
  if (const char* fault = fault_of_name(item.name))
    return cursor.error_at(name, ErrorCode::bad_setting, fault);
  settings.cargo.push_back(std::move(item));
  cursor.skip_white_space();
  return std::nullopt;
}

InputError out_of_place(const TextCursor& cursor, bool after_cargo) {
  if (same_word(cursor.word(), "com"))
    return cursor.error(ErrorCode::bad_syntax, "'CoM:' may appear only once, before the vertices");
  if (after_cargo && (cursor.sees('(') || same_word(cursor.word(), "hole")))
    return cursor.error(ErrorCode::bad_syntax, "vertices and holes come before the cargo");
  return cursor.expected("'(' before the coordinates");
}

}  // namespace

Result<Document> read_thesis(std::string_view text) {
  if (text.size() > max_text_bytes)
    return InputError{ErrorCode::text_too_long, "the text is longer than 64 MiB"};
  Document document;
  TextCursor cursor(without_byte_order_mark(text));
  cursor.skip_white_space();
  if (cursor.at_end()) return cursor.error(ErrorCode::bad_syntax, "the text is empty");
  if (cursor.sees_letter()) {
    if (auto error = take_centre_of_mass(cursor, document)) return *std::move(error);
  }
  std::size_t room = max_vertices;
  if (auto error = take_ring(cursor, document.vertices, room)) return *std::move(error);
  if (document.vertices.empty())
    return cursor.at_end() ? cursor.error(ErrorCode::too_few_vertices, no_vertices)
                           : out_of_place(cursor, false);
  while (same_word(cursor.word(), "hole")) {
    if (auto error = take_hole(cursor, document, room)) return *std::move(error);
  }
  while (same_word(cursor.word(), "cargo")) {
    if (auto error = take_cargo(cursor, document.settings)) return *std::move(error);
  }
  if (!cursor.at_end()) return out_of_place(cursor, !document.settings.cargo.empty());
  return document;
}

namespace {

void append_pair(std::string& text, const Vec2& point, const char* separator) {
  append_shortest(text, point.x);
  text += separator;
  append_shortest(text, point.y);
}

// The ring and its first vertex again, as WKT and GeoJSON require.
template <class Append>
void append_closed_ring(std::string& text, const Points& ring, const char* separator,
                        const Append& append) {
  for (std::size_t i = 0; i <= ring.size(); ++i) {
    if (i > 0) text += separator;
    append(text, ring[i == ring.size() ? 0 : i]);
  }
}

void append_json_pair(std::string& text, const Vec2& point) {
  text += '[';
  append_pair(text, point, ", ");
  text += ']';
}

void append_geojson_ring(std::string& text, const Points& ring) {
  text += "[\n  ";
  append_closed_ring(text, ring, ",\n  ", append_json_pair);
  text += "\n]";
}

std::string geojson_polygon(const Document& document) {
  std::string text = R"({"type": "Polygon", "coordinates": [)";
  if (!document.vertices.empty()) append_geojson_ring(text, document.vertices);
  for (const Points& hole : document.holes) {
    text += ", ";
    append_geojson_ring(text, hole);
  }
  return text + "]}";
}

void append_wkt_ring(std::string& text, const Points& ring) {
  text += '(';
  append_closed_ring(text, ring, ", ",
                     [](std::string& to, const Vec2& point) { append_pair(to, point, " "); });
  text += ')';
}

void append_thesis_pair(std::string& text, const Vec2& point) {
  text += '(';
  append_pair(text, point, ",");
  text += ')';
}

void append_thesis_ring(std::string& text, const Points& ring) {
  for (const Vec2& vertex : ring) {
    append_thesis_pair(text, vertex);
    text += '\n';
  }
}

}  // namespace

std::string_view without_byte_order_mark(std::string_view text) {
  constexpr std::string_view mark = "\xef\xbb\xbf";
  return text.starts_with(mark) ? text.substr(mark.size()) : text;
}

void RingNotes::drop_repeated(Points& ring) {
  const auto end = std::unique(ring.begin(), ring.end());
  repeated += static_cast<std::size_t>(std::distance(end, ring.end()));
  ring.erase(end, ring.end());
}

bool is_in_degrees(double code) {
  static constexpr double codes[] = {4326, 4979, 4258, 4269, 4267, 4283, 4230, 4171, 4612, 4674};
  return std::find(std::begin(codes), std::end(codes), code) != std::end(codes);
}

void drop_closing_vertex(Points& ring) {
  if (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
}

namespace {

// Keeps the first shape, and the first problem.
class OneShape final : public ShapeSink {
 public:
  void add(Document document, std::string_view, std::string_view) override {
    if (count_++ > 0) return;
    drop_closing_vertex(document.vertices);
    for (Points& hole : document.holes) drop_closing_vertex(hole);
    shape_ = std::move(document);
  }
  void add_problem(InputError error) override {
    if (!problem_) problem_ = std::move(error);
  }
  void leave_out(std::string_view, std::string_view) override {}
  bool full() const override { return false; }
  std::size_t most_holes() const override { return max_holes; }

  Result<Document> finish(const char* format) {
    if (count_ == 1) return check_size(std::move(shape_));
    if (count_ > 1)
      return InputError{ErrorCode::unsupported, say("it has {number} shapes", {count_})};
    if (problem_) return *std::move(problem_);
    return InputError{ErrorCode::unsupported, say("this {format} has no polygon", {format})};
  }

 private:
  static Result<Document> check_size(Document document) {
    std::size_t vertices = document.vertices.size();
    for (const Points& hole : document.holes) vertices += hole.size();
    if (vertices > max_vertices) return InputError{ErrorCode::too_many_vertices, no_more_vertices};
    return document;
  }

  Document shape_;
  std::size_t count_ = 0;
  std::optional<InputError> problem_;
};

}  // namespace

Result<Document> read_polygon(std::string_view text) {
  const std::string_view plain = without_byte_order_mark(text);
  TextCursor cursor(plain);
  cursor.skip_white_space();
  const bool is_json = cursor.sees('{') || cursor.sees('[');
  if (text.size() > max_text_bytes || (!is_json && !begins_wkt(cursor))) return read_thesis(text);
  OneShape shape;
  RingNotes notes;
  if (!is_json) {
    if (auto wrong = WktReader(shape, notes).take_all(plain)) return *std::move(wrong);
    return shape.finish("WKT");
  }
  const Result<JsonTree> tree = JsonTree::read(plain);
  if (!tree) return tree.error();
  GeojsonReader(plain, *tree, shape, notes).take_all();
  return shape.finish("GeoJSON");
}

std::string write_thesis(const Document& document) {
  std::string text;
  if (document.centre_of_mass) {
    text += "CoM:";
    append_thesis_pair(text, *document.centre_of_mass);
    text += '\n';
  }
  append_thesis_ring(text, document.vertices);
  for (const Points& hole : document.holes) {
    text += "Hole:\n";
    append_thesis_ring(text, hole);
  }
  for (const Cargo& item : document.settings.cargo) {
    text += "Cargo:";
    append_thesis_pair(text, item.at);
    text += ' ';
    append_shortest(text, item.weight);
    if (!item.name.empty()) text += ' ' + item.name;
    text += '\n';
  }
  return text;
}

std::string write_wkt(const Document& document) {
  if (document.vertices.empty()) return "POLYGON EMPTY\n";
  std::string text = "POLYGON (";
  append_wkt_ring(text, document.vertices);
  for (const Points& hole : document.holes) {
    text += ", ";
    append_wkt_ring(text, hole);
  }
  return text + ")\n";
}

std::string write_geojson(const Document& document) {
  std::string text = R"({"type": "Feature", "properties": {"centre_of_mass": )";
  if (document.centre_of_mass)
    append_json_pair(text, *document.centre_of_mass);
  else
    text += "null";
  return text + "}, \"geometry\":\n" + geojson_polygon(document) + "}\n";
}

}  // namespace evenlift
