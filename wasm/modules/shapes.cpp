// Reads drawings and tables as polygons.
#include <algorithm>
#include <string>
#include <vector>

#include "evenlift/formats.h"
#include "evenlift/import.h"
#include "evenlift/link.h"
#include "evenlift/output/json_text.h"
#include "evenlift/output/words.h"
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
                       {"tolerance", json::number(shape.tolerance.value_or(0))},
                       {"outline", thinned(document.vertices)},
                       {"holes", thinned(document.holes)},
                       {"text", json::text(write_thesis(document))},
                       {"link", json::text(link_of(import, document))}});
}

}  // namespace

std::string shapes(const RequestMembers& members) {
  ImportOptions options;
  if (const double tolerance = members.number("tolerance"); tolerance != 0)
    options.tolerance = tolerance;
  const Result<Import> read = read_shapes(members.text("text"), options);
  if (!read) return json::object({{"problem", json::text(sentence(read.error()))}});
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
