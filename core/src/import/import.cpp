#include "evenlift/import.h"

#include <algorithm>
#include <cmath>

#include "evenlift/formats.h"
#include "evenlift/link.h"
#include "evenlift/numbers.h"
#include "import/gathering.h"
#include "import/other_kinds.h"
#include "import/python_points.h"
#include "import/readers.h"
#include "import/wkt_shapes.h"
#include "numbers/text_cursor.h"

namespace evenlift {
namespace {

// Control characters that no text contains; old programs end a text with 0x1a.
bool is_no_text(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return byte < ' ' && c != '\t' && c != '\n' && c != '\r' && c != '\f' && c != '\v' &&
         byte != 0x1a;
}

Result<Import> read_link(std::string_view text) {
  Result<Document> document = decode_link(text);
  if (!document) return document.error();
  Import import;
  import.format = "share link";
  import.has_settings = true;
  import.shapes.push_back({std::move(document).value(), {}, "", "polygon", {}});
  return import;
}

Result<Import> read_small(std::string_view text, const char* format) {
  Result<Document> document = read_polygon(text);
  if (!document) return document.error();
  Import import;
  import.format = format;
  import.shapes.push_back({std::move(document).value(), {}, "", "polygon", {}});
  return import;
}

}  // namespace

Result<Import> read_shapes(std::string_view text, const ImportOptions& options) {
  if (options.tolerance && !(*options.tolerance > 0 && std::isfinite(*options.tolerance)))
    return InputError{ErrorCode::bad_setting,
                      "the distance between curves and edges must be a number above 0",
                      {}};
  if (options.join && !(*options.join > 0 && std::isfinite(*options.join)))
    return InputError{ErrorCode::bad_setting,
                      "the distance of ends that are joined must be a number above 0",
                      {}};
  if (text.size() > max_text_bytes)
    return InputError{ErrorCode::text_too_long, "the text is longer than 64 MiB", {}};
  constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
  if (text.substr(0, byte_order_mark.size()) == byte_order_mark)
    text.remove_prefix(byte_order_mark.size());
  if (const char* refusal = refusal_of_other_kind(text))
    return InputError{ErrorCode::unsupported, refusal, {}};
  if (std::any_of(text.begin(), text.end(), is_no_text))
    return InputError{ErrorCode::unsupported, joined({"this is not text: ", known_formats}), {}};

  TextCursor cursor(text);
  cursor.skip_white_space();
  if (cursor.at_end()) return cursor.error(ErrorCode::bad_syntax, "the text is empty");
  if (cursor.sees('<')) return read_svg(text, options);
  if (cursor.sees('{') || cursor.sees('[')) {
    Result<Import> json = read_json_shapes(text, options);
    const bool other = !json && json.error().code == ErrorCode::bad_syntax;
    return other && looks_like_python(text) ? read_python_points(text, options) : std::move(json);
  }
  if (cursor.sees('(') && looks_like_python(text)) return read_python_points(text, options);
  if (cursor.sees('(')) return read_small(text, "text");
  if (looks_like_link(text) && !read_number(text)) return read_link(text);
  if (looks_like_dxf(text)) return read_dxf(text, options);
  const std::string_view word = cursor.word();
  if (same_word(word, "com")) return read_small(text, "text");
  if (begins_wkt(cursor)) return read_wkt_shapes(text, options);
  return read_columns(text, options);
}

std::string describe(const ImportedShape& shape) {
  const Vec2 size = bounding_box(shape.document.vertices).size();
  std::string text = shape.name.empty() ? "" : "\"" + shape.name + "\", ";
  text += shape.kind + ", " + counted(shape.document.vertices.size(), "vertex", "vertices") + ", " +
          short_number(size.x()) + " x " + short_number(size.y());
  return text;
}

}  // namespace evenlift
