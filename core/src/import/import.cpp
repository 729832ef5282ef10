#include "evenlift/import.h"

#include <algorithm>
#include <cmath>

#include "evenlift/formats.h"
#include "evenlift/link.h"
#include "evenlift/numbers.h"
#include "formats/readers.h"
#include "import/gathering.h"
#include "import/readers.h"
#include "numbers/text_cursor.h"

namespace evenlift {
namespace {

struct Kind {
  std::string_view begins;
  const char* refusal;
};

// The kinds of files that evenlift refuses, by their first bytes.
constexpr Kind other_kinds[] = {
    {"AutoCAD Binary DXF",
     "this is a binary DXF drawing, and evenlift reads only DXF as text: save it again as ASCII DXF"},
    {"AC10", "this is a DWG drawing, which evenlift does not read: save it as ASCII DXF"},
    {"\x89PNG",
     "this is a picture made of dots, which has no outline: trace it to SVG first (in Inkscape: Path, "
     "Trace Bitmap)"},
    {"\xff\xd8\xff",
     "this is a photo, which has no outline: trace it to SVG first (in Inkscape: Path, Trace Bitmap)"},
    {"GIF8",
     "this is a picture made of dots, which has no outline: trace it to SVG first (in Inkscape: Path, "
     "Trace Bitmap)"},
    {"%PDF", "this is a PDF, which evenlift does not read: open it in Inkscape and save it as SVG"},
    {"%!PS",
     "this is PostScript, which evenlift does not read: open it in Inkscape and save it as SVG"},
    {"PK\x03\x04",
     "this is a compressed file, such as a spreadsheet: unpack it, or save the sheet as CSV"},
    {"\x1f\x8b", "this is a compressed file: unpack it first (an .svgz contains an .svg)"},
    {"\xff\xfe", "this text is in UTF-16: save it again as UTF-8"},
    {"\xfe\xff", "this text is in UTF-16: save it again as UTF-8"},
};

const char* refusal_by_first_bytes(std::string_view text) {
  for (const Kind& kind : other_kinds)
    if (text.substr(0, kind.begins.size()) == kind.begins) return kind.refusal;
  return nullptr;
}

// Control characters that no text contains; old programs end a text with 0x1a.
bool is_no_text(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return byte < ' ' && c != '\t' && c != '\n' && c != '\r' && c != '\f' && c != '\v' &&
         byte != 0x1a;
}

// Whether the text begins with the name of a geometry and a parenthesis, or another valid
// continuation. The heading of a table may also begin with such a name.
bool begins_wkt(TextCursor cursor) {
  const std::string_view name = cursor.take_word();
  cursor.skip_white_space();
  if (same_word(name, "srid")) return cursor.sees('=');
  if (!same_word(name.substr(0, 7), "polygon") && !names_other_geometry(name)) return false;
  const std::string_view second = cursor.take_word();
  cursor.skip_white_space();
  return cursor.sees('(') || same_word(second, "empty");
}

Result<Import> read_link(std::string_view text) {
  Result<Document> document = decode_link(text);
  if (!document) return document.error();
  Import import;
  import.format = "share link";
  import.has_settings = true;
  import.shapes.push_back({std::move(document).value(), "", "polygon", {}});
  return import;
}

Result<Import> read_small(std::string_view text, const char* format) {
  Result<Document> document = read_polygon(text);
  if (!document) return document.error();
  Import import;
  import.format = format;
  import.shapes.push_back({std::move(document).value(), "", "polygon", {}});
  return import;
}

}  // namespace

Result<Import> read_shapes(std::string_view text, const ImportOptions& options) {
  if (options.tolerance && !(*options.tolerance > 0 && std::isfinite(*options.tolerance)))
    return InputError{ErrorCode::bad_setting,
                      "the distance between curves and edges must be a number above 0",
                      {}};
  if (text.size() > max_text_bytes)
    return InputError{ErrorCode::text_too_long, "the text is longer than 64 MiB", {}};
  constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
  if (text.substr(0, byte_order_mark.size()) == byte_order_mark)
    text.remove_prefix(byte_order_mark.size());
  if (const char* refusal = refusal_by_first_bytes(text))
    return InputError{ErrorCode::unsupported, refusal, {}};
  if (std::any_of(text.begin(), text.end(), is_no_text))
    return InputError{ErrorCode::unsupported, joined({"this is not text: ", known_formats}), {}};

  TextCursor cursor(text);
  cursor.skip_white_space();
  if (cursor.at_end()) return cursor.error(ErrorCode::bad_syntax, "the text is empty");
  if (cursor.sees('<')) return read_svg(text, options);
  if (cursor.sees('{') || cursor.sees('[')) return read_json_shapes(text, options);
  if (cursor.sees('(')) return read_small(text, "text");
  if (looks_like_link(text) && !read_number(text)) return read_link(text);
  if (looks_like_dxf(text)) return read_dxf(text, options);
  const std::string_view word = cursor.word();
  if (same_word(word, "com")) return read_small(text, "text");
  if (begins_wkt(cursor)) return read_small(text, "WKT");
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
