// The thesis's format (appendix A.1): optionally `CoM:(x,y)` on the first line, then one `(x,y)` on
// each line.
#include "formats/readers.h"
#include "numbers/text_cursor.h"

namespace evenlift {
namespace {

// Reads `(x,y)`, with spaces anywhere but no line break.
std::optional<InputError> take_pair(TextCursor& cursor, const char* before, Vec2& point) {
  if (!cursor.take('(')) return cursor.expected(before);
  cursor.skip_spaces_in_line();
  if (auto error = cursor.take_number(point.x(), "a number")) return error;
  cursor.skip_spaces_in_line();
  if (!cursor.take(',')) return cursor.expected("',' between the coordinates");
  cursor.skip_spaces_in_line();
  if (auto error = cursor.take_number(point.y(), "a number")) return error;
  cursor.skip_spaces_in_line();
  if (cursor.sees(',')) return cursor.error(ErrorCode::unsupported, no_third_coordinate);
  if (!cursor.take(')')) return cursor.expected("')' after the coordinates");
  return std::nullopt;
}

std::optional<InputError> take_line_end(TextCursor& cursor) {
  cursor.skip_spaces_in_line();
  if (!cursor.at_line_end()) return cursor.expected("the end of the line after ')'");
  cursor.skip_white_space();
  return std::nullopt;
}

std::optional<InputError> take_centre_of_mass(TextCursor& cursor, Document& document) {
  if (!same_word(cursor.word(), "com")) return cursor.expected("'(' or 'CoM:'");
  cursor.take_word();
  cursor.skip_spaces_in_line();
  if (!cursor.take(':')) return cursor.expected("':' after 'CoM'");
  cursor.skip_spaces_in_line();
  Vec2 point;
  if (auto error = take_pair(cursor, "'(' after 'CoM:'", point)) return error;
  document.centre_of_mass = point;
  return take_line_end(cursor);
}

}  // namespace

Result<Document> read_thesis(std::string_view text) {
  Document document;
  TextCursor cursor(text);
  cursor.skip_white_space();
  if (cursor.sees_letter()) {
    if (auto error = take_centre_of_mass(cursor, document)) return *std::move(error);
  }
  while (!cursor.at_end()) {
    if (document.vertices.size() == max_vertices) {
      return cursor.error(ErrorCode::too_many_vertices, no_more_vertices);
    }
    if (same_word(cursor.word(), "com")) {
      return cursor.error(ErrorCode::bad_syntax,
                          "'CoM:' may appear only once, before the vertices");
    }
    Vec2 point;
    if (auto error = take_pair(cursor, "'(' before the coordinates", point)) {
      return *std::move(error);
    }
    document.vertices.push_back(point);
    if (auto error = take_line_end(cursor)) return *std::move(error);
  }
  if (document.vertices.empty()) return cursor.error(ErrorCode::too_few_vertices, no_vertices);
  return document;
}

}  // namespace evenlift
