#include "evenlift/import.h"

#include <algorithm>
#include <cmath>

#include "evenlift/formats.h"
#include "evenlift/link.h"
#include "evenlift/numbers.h"
#include "evenlift/wording.h"
#include "import/gathering.h"
#include "import/other_kinds.h"
#include "import/projection/projection.h"
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
  import.shapes.push_back({std::move(document).value(), "", "polygon", {}});
  return import;
}

Result<Import> read_small(std::string_view text, const char* format) {
  Result<Document> document = read_thesis(text);
  if (!document) return document.error();
  Import import;
  import.format = format;
  import.shapes.push_back({std::move(document).value(), "", "polygon", {}});
  return import;
}

// Geometries as Python libraries print them, one or a list: "<POLYGON ((…))>". Returns the same text
// with blanks in place of the brackets, and a line for each geometry; nothing for other texts.
std::optional<std::string> printed_wkt(std::string_view text) {
  TextCursor cursor(text);
  cursor.skip_white_space();
  if (cursor.take('[')) cursor.skip_white_space();
  if (!cursor.take('<') || !begins_wkt(cursor)) return std::nullopt;
  std::string plain(text);
  bool outside = true;
  for (char& c : plain) {
    if (c == '<' || c == '>') outside = c == '>';
    if (c == '<' || c == '>' || c == '[' || c == ']') c = ' ';
    if (c == ',' && outside) c = '\n';
  }
  return plain;
}

// JSON, or Python's points, that a script assigns to a variable: "var plates = {…};". Returns the same
// text with blanks in place of all but the value; nothing for other texts.
std::optional<std::string> assigned(std::string_view text) {
  const std::size_t first = text.find_first_of("{["), last = text.find_last_of("}]");
  if (first == text.npos || last == text.npos || last < first) return std::nullopt;
  std::string_view before = text.substr(0, text.find_last_not_of(" \t\r\n", first - 1) + 1);
  if (!before.ends_with('=') || text.find_first_not_of("; \t\r\n", last + 1) != text.npos)
    return std::nullopt;
  before.remove_suffix(1);
  const auto names = [](char c) {
    return is_letter(c) || is_digit(c) ||
           std::string_view("_$. \t\r\n").find(c) != std::string_view::npos;
  };
  if (!std::all_of(before.begin(), before.end(), names)) return std::nullopt;
  std::string plain(text);
  for (std::size_t i = 0; i < plain.size(); ++i)
    if ((i < first || i > last) && !ends_line(plain[i])) plain[i] = ' ';
  return plain;
}

Result<Import> read_format(std::string_view text, const ImportOptions& options) {
  TextCursor cursor(text);
  cursor.skip_white_space();
  if (const auto value = assigned(text)) return read_format(*value, options);
  if (const auto printed = printed_wkt(text)) return read_wkt_shapes(*printed, options);
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

constexpr char record_separator = '\x1e';

// Features one after another (GeoJSON text sequences, RFC 8142, or one in each line) as a collection,
// in the same lines; nothing for other texts.
std::optional<std::string> collected(std::string_view text) {
  TextCursor cursor(text);
  cursor.skip_white_space();
  const bool separated = cursor.sees(record_separator);
  if (!separated && !cursor.sees('{')) return std::nullopt;
  std::string collection = "{\"type\":\"FeatureCollection\",\"features\":[";
  std::size_t records = 0;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end =
        std::min(text.find(separated ? record_separator : '\n', at), text.size());
    const std::string_view record = text.substr(at, end - at);
    std::string_view plain = record;
    plain.remove_prefix(std::min(plain.find_first_not_of(" \t\r\n"), plain.size()));
    plain = plain.substr(0, plain.find_last_not_of(" \t\r\n") + 1);
    if (!plain.empty()) {
      const bool is_feature = plain.front() == '{' && plain.back() == '}' &&
                              plain.find("\"Feature\"") != std::string_view::npos;
      if (!is_feature) return std::nullopt;
      if (records++ > 0) collection += ',';
    }
    collection += record;
    if (!separated && end < text.size()) collection += '\n';
    at = end + 1;
  }
  if (records == 0 || (records == 1 && !separated)) return std::nullopt;
  return collection + "]}";
}

// "8.5417° E".
std::string degrees_in_words(double degrees, const char* positive, const char* negative) {
  return say(degrees < 0 ? negative : positive, {as_read(shortest(std::abs(degrees)))});
}

std::string projection_note(const Projection& projection) {
  constexpr double unseen_error = 0.001;
  const std::string longitude = degrees_in_words(projection.origin().x, "{degrees}\u00B0 E",
                                                 "{degrees}\u00B0 W"),
                    latitude = degrees_in_words(projection.origin().y, "{degrees}\u00B0 N",
                                                "{degrees}\u00B0 S");
  if (projection.error() < unseen_error)
    return say(
        "the coordinates were converted from degrees to metres east and north of {longitude}, "
        "{latitude}",
        {longitude, latitude});
  return say(
      "the coordinates were converted from degrees to metres east and north of {longitude}, "
      "{latitude}; widths are off by up to {error}\u00A0%, since the shapes are so far apart or so "
      "large",
      {longitude, latitude, as_read(shortest(std::ceil(1000 * projection.error()) / 10))});
}

Result<Import> projected(Import import) {
  if (import.has_settings)
    return InputError{ErrorCode::unsupported,
                      "a result of evenlift keeps its coordinates, which are no degrees"};
  const Result<Projection> projection = Projection::about_middle(box_of(import.shapes));
  if (!projection) return projection.error();
  const auto convert = [&](Points& points) {
    for (Vec2& point : points) point = projection->metres(point);
  };
  for (ImportedShape& shape : import.shapes) {
    convert(shape.document.vertices);
    for (Points& hole : shape.document.holes) convert(hole);
    for (Cargo& item : shape.document.settings.cargo) item.at = projection->metres(item.at);
    if (auto& centre = shape.document.centre_of_mass) centre = projection->metres(*centre);
    if (shape.tolerance) *shape.tolerance *= projection->greatest_scale();
    shape.document.shown.units.length = LengthUnit::m;
  }
  import.unit = in_full(LengthUnit::m);
  import.notes.push_back(projection_note(*projection));
  return import;
}

}  // namespace

Result<Import> read_shapes(std::string_view text, const ImportOptions& options) {
  if (options.tolerance && !(*options.tolerance > 0 && std::isfinite(*options.tolerance)))
    return InputError{ErrorCode::bad_setting,
                      "the distance between curves and edges must be a number above 0"};
  if (options.join && !(*options.join > 0 && std::isfinite(*options.join)))
    return InputError{ErrorCode::bad_setting,
                      "the distance of ends that are joined must be a number above 0"};
  if (text.size() > max_text_bytes)
    return InputError{ErrorCode::text_too_long, "the text is longer than 64 MiB"};
  text = without_byte_order_mark(text);
  if (const char* refusal = refusal_of_other_kind(text))
    return InputError{ErrorCode::unsupported, refusal};
  const std::optional<std::string> collection = collected(text);
  if (collection) text = *collection;
  if (std::any_of(text.begin(), text.end(), is_no_text))
    return InputError{ErrorCode::unsupported, say("this is not text: {formats}", {known_formats})};
  Result<Import> import = read_format(text, options);
  if (import && !options.holes)
    if (std::string note = leave_out_holes(import->shapes); !note.empty())
      import->notes.push_back(std::move(note));
  return import && options.project ? projected(std::move(import).value()) : std::move(import);
}

std::size_t count_parts(const Import& import) {
  const auto sheets = std::count_if(import.shapes.begin(), import.shapes.end(),
                                    [](const ImportedShape& each) { return each.sheet; });
  return import.shapes.size() - static_cast<std::size_t>(sheets);
}

namespace {

InputError no_choice(std::string why) { return {ErrorCode::unsupported, std::move(why)}; }

Result<std::size_t> only_part(const Import& import) {
  if (count_parts(import) == 1 && !import.doubtful) return std::size_t{0};
  if (!import.doubtful) return no_choice(say("it has {number} shapes", {import.shapes.size()}));
  return no_choice(say("what does not close is larger than the largest shape") +
                   (import.notes.empty() ? std::string() : " (" + import.notes[0] + ")"));
}

}  // namespace

Result<std::size_t> choose_shape(const Import& import, const std::optional<std::string>& wanted) {
  if (!wanted) return only_part(import);
  const std::vector<ImportedShape>& shapes = import.shapes;
  const std::optional<std::uint64_t> number = read_whole(*wanted);
  if (number && *number >= 1 && *number <= shapes.size())
    return static_cast<std::size_t>(*number) - 1;
  std::optional<std::size_t> found;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    if (shapes[i].name != *wanted) continue;
    if (found)
      return InputError{
          ErrorCode::bad_setting,
          say("shapes {first} and {second} are both called {name}; give a number instead",
              {*found + 1, i + 1, in_quotes(*wanted)})};
    found = i;
  }
  if (found) return *found;
  return no_choice(say("expected a number from 1 to {most} or a shape's name, not {given}",
                       {shapes.size(), in_quotes(*wanted)}));
}

std::string leave_out_holes(std::vector<ImportedShape>& shapes) {
  std::size_t count = 0;
  for (ImportedShape& shape : shapes) {
    count += shape.document.holes.size();
    shape.document.holes.clear();
  }
  if (count == 0) return {};
  return say(count == 1 ? "{count} hole is left out" : "{count} holes are left out", {count});
}

std::string describe(const ImportedShape& shape) {
  const Vec2 size = bounding_box(shape.document.vertices).size();
  const std::size_t holes = shape.document.holes.size();
  std::string text = shape.name.empty() ? "" : in_quotes(shape.name) + ", ";
  if (shape.sheet) text += std::string(translated("sheet")) + ", ";
  text += std::string(translated(shape.kind)) + ", " +
          counted(shape.document.vertices.size(), "vertex", "vertices") + ", ";
  if (holes > 0) text += counted(holes, "hole", "holes") + ", ";
  text += short_number(size.x) + " x " + short_number(size.y);
  return text;
}

}  // namespace evenlift
