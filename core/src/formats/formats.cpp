#include "evenlift/formats.h"

#include "formats/readers.h"
#include "numbers/number_text.h"
#include "numbers/text_cursor.h"

namespace evenlift {
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

void drop_closing_vertex(Points& ring) {
  if (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
}

Result<Document> read_polygon(std::string_view text) {
  if (text.size() > max_text_bytes) {
    return InputError{ErrorCode::text_too_long, "the text is longer than 64 MiB", {}};
  }
  constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
  if (text.substr(0, byte_order_mark.size()) == byte_order_mark) {
    text.remove_prefix(byte_order_mark.size());
  }

  TextCursor cursor(text);
  cursor.skip_white_space();
  if (cursor.at_end()) return cursor.error(ErrorCode::bad_syntax, "the text is empty");
  if (cursor.sees('{') || cursor.sees('[')) return read_geojson(text);
  if (cursor.sees('(')) return read_thesis(text);
  if (cursor.sees_letter()) {
    return same_word(cursor.take_word(), "com") ? read_thesis(text) : read_wkt(text);
  }
  return cursor.expected("'(', 'CoM:', 'POLYGON' or '{'");
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
