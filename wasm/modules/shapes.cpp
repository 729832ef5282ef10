// Reads drawings and tables as polygons, and places robots on all of them.
#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "derive/derive.h"
#include "evenlift/formats.h"
#include "evenlift/import.h"
#include "evenlift/link.h"
#include "evenlift/numbers.h"
#include "evenlift/output/json_text.h"
#include "evenlift/output/words.h"
#include "evenlift/parts.h"
#include "evenlift/settings.h"
#include "modules/kinds.h"

namespace evenlift::view {
namespace {

// Enough for a small picture.
constexpr std::size_t most_points = 512;

// [[x, y], …]
std::string thinned(const Points& vertices) {
  const std::size_t step = (vertices.size() + most_points - 1) / most_points;
  std::vector<std::string> points;
  for (std::size_t i = 0; i < vertices.size(); i += std::max<std::size_t>(step, 1))
    points.push_back(json::pair(vertices[i]));
  return json::array(points);
}

std::string thinned(const std::vector<Points>& lines) {
  std::vector<std::string> all;
  for (const Points& line : lines) all.push_back(thinned(line));
  return json::array(all);
}

// The link that holds the settings: empty if the import has neither settings nor a unit of length,
// or if the link would be too long.
std::string link_of(const Import& import, const Document& document) {
  if (!import.has_settings && document.shown.units.length == LengthUnit::none) return {};
  const Result<std::string> link = encode_link(document);
  return link ? *link : std::string();
}

std::string shape_json(const Import& import, const ImportedShape& shape) {
  const Document& document = shape.document;
  return json::object({{"name", json::text(shape.name)},
                       {"description", json::text(describe(shape))},
                       {"sheet", json::boolean(shape.sheet)},
                       {"within", shape.within ? std::to_string(*shape.within) : "null"},
                       {"tolerance", json::number(shape.tolerance.value_or(0))},
                       {"outline", thinned(document.vertices)},
                       {"holes", thinned(document.holes)},
                       {"text", json::text(write_thesis(document))},
                       {"link", json::text(link_of(import, document))}});
}

// --- All parts

std::optional<std::string> typed(const RequestMembers& members, const char* name) {
  const std::string text = members.text(name);
  return text.empty() ? std::nullopt : std::optional(text);
}

// As with files of supports, lengths are converted only if both units are known.
void convert_lengths(Document& document, LengthUnit to) {
  const LengthUnit from = document.shown.units.length;
  document.shown.units.length = to;
  if (from == LengthUnit::none || from == to) return;
  const double scale = in_metres(1, from) / in_metres(1, to);
  for (const SettingRow& row : all_settings()) {
    if (!row.is_length) continue;
    const auto length = read_number(text_of(row.setting, document));
    if (length) read_setting(row.setting, shortest(*length * scale), document);
  }
}

// Prepares each shape's document. Returns what is wrong with the texts, if anything.
std::optional<InputError> prepare(std::vector<ImportedShape>& shapes, bool have_settings,
                                  const WeightByArea& weight, const RequestMembers& members) {
  for (ImportedShape& shape : shapes) {
    Document& document = shape.document;
    const LengthUnit own = document.shown.units.length;
    if (!have_settings && !read_lines(members.text("settings"), document))
      return bad_setting({}, "the settings of the page cannot be read");
    if (own != LengthUnit::none) convert_lengths(document, own);
    if (const auto capacity = typed(members, "capacity"))
      if (auto wrong = read_setting(Setting::capacity, *capacity, document)) return wrong;
    if (auto wrong = set_weight(document, weight)) return wrong;
  }
  return std::nullopt;
}

// What opens the part with its settings.
std::string opening(const ImportedShape& shape, const PartResult& result) {
  Document document = shape.document;
  document.settings = result.settings;
  const Result<std::string> link = encode_link(document);
  return link ? *link : write_thesis(document);
}

std::string part_json(const Part& part, const ImportedShape& shape, const PartResult& result) {
  std::vector<std::string> values, texts;
  for (std::size_t i = 0; i < part_columns().size(); ++i) {
    const Quantity& column = *part_columns()[i];
    const bool is_known = i < result.columns.size() && result.columns[i];
    const double value = is_known ? *result.columns[i] : 0;
    const double largest = result.columns.empty() ? 0 : result.columns[0].value_or(0);
    values.push_back(is_known ? json::number(value) : "null");
    texts.push_back(json::text(is_known ? cell_in_words(column, value, largest) : ""));
  }
  const bool refused = !result.refusal.empty();
  return json::object(
      {{"number", std::to_string(part.number)},
       {"name", json::text(part.name)},
       {"width", json::number(part.size.x)},
       {"height", json::number(part.size.y)},
       {"weight", result.weight ? json::number(*result.weight) : "null"},
       {"robots", std::to_string(result.robots)},
       {"values", json::array(values)},
       {"texts", json::array(texts)},
       {"verdict", json::text(refused ? "refused" : result.verdict)},
       {"problem", json::text(refused ? result.refusal : result.problem)},
       {"outline", thinned(shape.document.vertices)},
       {"holes", thinned(shape.document.holes)},
       {"open", json::text(refused ? write_thesis(shape.document) : opening(shape, result))}});
}

Result<Import> read_drawing(const RequestMembers& members) {
  ImportOptions options;
  if (const double tolerance = members.number("tolerance"); tolerance != 0)
    options.tolerance = tolerance;
  return read_shapes(members.text("text"), options);
}

}  // namespace

std::string place_parts(const RequestMembers& members) {
  Result<Import> import = read_drawing(members);
  if (!import) return problem(sentence(import.error()));
  std::vector<ImportedShape>& shapes = import->shapes;
  shapes.resize(count_parts(*import));
  const WeightByArea weight{typed(members, "per_area"), typed(members, "thickness"),
                            typed(members, "density")};
  if (auto wrong = prepare(shapes, import->has_settings, weight, members)) {
    wrong->place = {};  // the fields have other names
    return problem(sentence(*wrong));
  }
  const std::vector<Part> parts = parts_of(shapes);
  std::vector<std::string> headings;
  for (const Quantity* column : part_columns()) headings.push_back(json::text(column->column));
  report(
      json::object({{"count", std::to_string(parts.size())}, {"columns", json::array(headings)}}));
  std::vector<PartResult> results(parts.size());
  const std::vector<std::size_t> rows = order_of_rows(PartOrder::file, shapes, parts, {});
  for (const std::size_t row : rows) {
    results[row] = place_part(parts[row], shapes[row], {.weight_by_area = weight.typed()});
    report(part_json(parts[row], shapes[row], results[row]));
  }
  std::vector<std::string> notes;
  if (auto doubt = doubtful_unit(weight, shapes[0].document.shown.units)) {
    doubt->place = {};
    notes.push_back(sentence(*doubt));
  }
  return json::object(
      {{"csv", json::text(parts_csv(rows, parts, results, false))}, {"notes", json::texts(notes)}});
}

std::string shapes(const RequestMembers& members) {
  const Result<Import> read = read_drawing(members);
  if (!read) return problem(sentence(read.error()));
  std::vector<std::string> notes, shapes;
  for (const std::string& note : read->notes) notes.push_back(json::text(note));
  for (const ImportedShape& shape : read->shapes) shapes.push_back(shape_json(*read, shape));
  return json::object({{"format", json::text(read->format)},
                       {"unit", json::text(read->unit)},
                       {"notes", json::array(notes)},
                       {"doubtful", read->doubtful ? "true" : "false"},
                       {"leftOpen", thinned(read->left_open)},
                       {"shapes", json::array(shapes)}});
}

}  // namespace evenlift::view
